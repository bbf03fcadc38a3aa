/// Closed-form derivatives against automatic differentiation of the definitions. They share no
/// formula: where both agree to rounding, both are right.
#include "verify/derivatives.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shell_origami {
namespace {

/// Rounding of 1e-16, times the aspect of the thinnest triangle, 100, once for each derivative, and
/// times tan(theta / 2) < 115.
constexpr double kRounding = 1e-10;

void expectAgreement(const DerivativeError& error) {
  EXPECT_LT(error.value, kRounding);
  EXPECT_LT(error.gradient, kRounding);
  EXPECT_LT(error.hessian, kRounding);
}

class Derivatives : public testing::TestWithParam<HingeShape> {};

TEST_P(Derivatives, OfTheFoldAngle) {
  for (const double theta : hingeAngles()) {
    SCOPED_TRACE(theta * 180 / M_PI);
    expectAgreement(foldAngleError(GetParam().bent(theta)));
  }
}

TEST_P(Derivatives, OfHingeAndCreaseEnergy) {
  for (const double theta : hingeAngles()) {
    for (const double rest : {0.0, 0.7, -2.5}) {
      for (const bool crease : {false, true}) {
        SCOPED_TRACE(testing::Message() << theta * 180 / M_PI << " degrees, rest " << rest
                                        << (crease ? ", crease" : ""));
        expectAgreement(hingeEnergyError(GetParam(), theta, rest, crease));
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
      expectAgreement(membraneError(kind, stretch));
    }
  }
}

}  // namespace
}  // namespace shell_origami
