/// \file
/// One function for each closed form, which adds rows to the report and writes the data of figures.
#pragma once

#include "verify/report.h"

namespace shell_origami {

void verifyDerivatives(VerificationReport& report);    ///< item 1
void verifyMomentum(VerificationReport& report);       ///< item 2
void verifyTimeOrder(VerificationReport& report);      ///< item 3
void verifyVibration(VerificationReport& report);      ///< items 3 and 4
void verifyCantilever(VerificationReport& report);     ///< item 4
void verifyCylinder(VerificationReport& report);       ///< item 5
void verifyCreaseMoment(VerificationReport& report);   ///< item 6
void verifyDegree4(VerificationReport& report);        ///< item 7
void verifyMiura(VerificationReport& report);          ///< item 8
void verifyWaterbomb(VerificationReport& report);      ///< item 9
void verifyCone(VerificationReport& report);           ///< item 10
void verifyFlatFolded(VerificationReport& report);     ///< item 11
void verifyIntegrators(VerificationReport& report);    ///< item 12, of our own
void verifyChoices(VerificationReport& report);        ///< items 13 and 14
void verifyContact(VerificationReport& report);        ///< item 15
void verifyObstacles(VerificationReport& report);      ///< item 16
void verifyPressedCrease(VerificationReport& report);  ///< item 17

}  // namespace shell_origami
