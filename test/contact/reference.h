/// \file
/// Distances and certificates that share no formula with contact/.
#pragma once

#include <shell_origami/contact/distance.h>

#include <random>

namespace shell_origami {

using Long = long double;
using Long3 = Eigen::Matrix<Long, 3, 1>;

/// The smallest of the distances between all features of the two primitives: corners, sides and
/// the inside of the face, or ends and insides of the edges.
struct LongClosest {
  Long distance;
  Long3 difference;             ///< from the second primitive to the first
  std::array<Long, 4> weights;  ///< as those of ClosestPoints
};
LongClosest longClosest(PairKind kind, const std::array<Long3, 4>& x);
LongClosest longClosest(PairKind kind, const PairPoints& x);

/// Whether, in exact arithmetic, planes separate the primitives at all times in [0, part] of the
/// straight motion. False where they touch, and where the planes are not found in some hundred
/// parts of the motion.
bool provedApart(PairKind kind, const PairPoints& from, const PairPoints& to, double part);

/// Random numbers, points and rotations.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  /// In a cube of this half side.
  Vector3 inCube(double size);
  /// Of length 1.
  Vector3 direction();
  Eigen::Matrix3d rotation();

 private:
  std::mt19937 engine_;
};

}  // namespace shell_origami
