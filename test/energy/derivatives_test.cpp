/// Closed-form derivatives against automatic differentiation of the definitions. The two share no
/// formula; they must agree to rounding.
#include "verify/derivatives.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shell_origami {
namespace {

void expectAgreement(const DerivativeError& error, double rounding) {
  EXPECT_LT(error.value, rounding);
  EXPECT_LT(error.gradient, rounding);
  EXPECT_LT(error.hessian, rounding);
}

class Derivatives : public testing::TestWithParam<HingeShape> {};

TEST_P(Derivatives, OfTheFoldAngle) {
  for (const double theta : hingeAngles()) {
    SCOPED_TRACE(theta * 180 / M_PI);
    expectAgreement(foldAngleError(GetParam().bent(theta)), kFoldAngleRounding);
  }
}

TEST_P(Derivatives, OfHingeAndCreaseEnergy) {
  for (const double theta : hingeAngles()) {
    for (const double rest : {0.0, 0.7, -2.5}) {
      for (const bool crease : {false, true}) {
        SCOPED_TRACE(testing::Message() << theta * 180 / M_PI << " degrees, rest " << rest
                                        << (crease ? ", crease" : ""));
        expectAgreement(hingeEnergyError(GetParam(), theta, rest, crease), kHingeRounding);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Hinges, Derivatives, testing::ValuesIn(hingeShapes()),
                         [](const auto& info) { return "shape" + std::to_string(info.index); });

TEST(MembraneDerivatives, OfBothModels) {
  for (const MembraneKind kind :
       {MembraneKind::kStVenantKirchhoff, MembraneKind::kDiscreteShells}) {
    for (const double stretch : {0.6, 0.9, 0.999, 1.05, 1.4}) {
      SCOPED_TRACE(stretch);
      expectAgreement(membraneError(kind, stretch), kMembraneRounding);
    }
  }
}

}  // namespace
}  // namespace shell_origami
