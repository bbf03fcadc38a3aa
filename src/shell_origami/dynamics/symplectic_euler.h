/// \file
/// Explicit symplectic Euler: no equation to solve, and steps that stiff paper keeps tiny.
#pragma once

#include <shell_origami/dynamics/integrator.h>

namespace shell_origami {

/// First order. Stable only below 2 over the highest frequency of the mesh (Discrete Shells
/// Origami, figure 2).
class SymplecticEuler : public Integrator {
 public:
  bool step(const Loading& loading, double dt, Motion& motion, StepReport& report) override;

 private:
  // Scratch, kept between steps.
  std::vector<FoldAngle> angles_;
  std::vector<HingeGradient> angle_gradients_;
  Positions gradient_;
};

}  // namespace shell_origami
