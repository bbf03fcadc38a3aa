/// \file
/// The energy by which primitives that come close push each other apart.
#pragma once

#include <shell_origami/contact/distance.h>

namespace shell_origami {

/// A function of one variable with its first two derivatives.
struct Derivatives {
  double value = 0, first = 0, second = 0;
};

/// Returns -(s - 1)^2 ln s and its derivatives: 0 from s = 1 on, twice continuously differentiable
/// there (Li et al., Incremental Potential Contact, 2020, equation 6). Where s is as good as 0 or
/// less it goes on as a parabola: what lies there already is pushed away.
Derivatives logBarrier(double s);

/// The factor by which the energy of an edge-edge pair is weakened as the edges become parallel,
/// where the closest points jump from end to end: 2 r - r^2 with r = |e1 x e2|^2 / limit, 1 where
/// r >= 1 (Li et al. 2020, section 4.2).
struct Mollifier {
  double value = 1;
  /// By the four points; zero where the value is 1.
  std::array<Vector3, 4> gradient{Vector3::Zero(), Vector3::Zero(), Vector3::Zero(),
                                  Vector3::Zero()};
};

/// `limit` [m^4] is constant for the life of the pair: kParallel times the squared product of both
/// flat lengths. A limit that moved with x would lack its part of the gradient.
Mollifier mollifier(const PairPoints& x, double limit);

constexpr double kParallel = 1e-3;

}  // namespace shell_origami
