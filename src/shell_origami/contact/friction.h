/// \file
/// Coulomb's friction of layers that touch.
#pragma once

#include <shell_origami/contact/barrier.h>
#include <shell_origami/contact/candidates.h>

namespace shell_origami {

/// A contact at the start of a step, whose normal force and direction hold for all of it (lagged:
/// Li et al., Incremental Potential Contact, 2020, section 5).
struct FrictionPair {
  ContactPair pair;
  /// Takes the displacements of the four points since the start to the slip: the displacement [m]
  /// of the first primitive's closest point relative to the second, along the layers. The gap
  /// between them turns with the pair, so that a rigid rotation is no slip and friction gives no
  /// torque.
  Eigen::Matrix<double, 3, 12> slip;
  Vector3 normal;
  double bound;  ///< largest force of friction, the coefficient times the normal force [N]
};

/// \param x where the pair is at the start
FrictionPair frictionPair(const ContactPair& pair, const ClosestPoints& closest,
                          const PairPoints& x, double bound);

/// Returns the slip [m].
Vector3 slip(const FrictionPair& pair, const Positions& start, const Positions& x);

/// The energy of friction over its bound [m] as a function of the length of the slip, and its
/// derivatives: slip - sticking / 3 beyond the slip `sticking` [m], smooth below it, where the
/// force rises from 0.
Derivatives smoothSlip(double slip, double sticking);

/// Returns d^2/ds^2 of smoothSlip(|s|) for a slip s within the plane across `normal`. Positive
/// semidefinite.
Eigen::Matrix3d slipHessian(const Vector3& slip, const Vector3& normal, double sticking);

}  // namespace shell_origami
