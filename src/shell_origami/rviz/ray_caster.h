/// \file
/// Which triangle of the paper a ray meets first.
#pragma once

#include <shell_origami/base/geometry.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace shell_origami {

struct Ray {
  Vector3 origin;     ///< [m]
  Vector3 direction;  ///< of any length but 0
};

struct RayHit {
  int triangle;
  Vector3 weights;  ///< of the triangle's corners, not negative; they sum up to 1
  Vector3 point;    ///< [m]
  double distance;  ///< [m] from the ray's origin
};

/// A tree of boxes over triangles that lie together on the flat sheet, which stay together however
/// the sheet is folded: the tree is made once, and its boxes follow the motion.
class RayCaster {
 public:
  /// \param flat  of each vertex [m]
  RayCaster(const std::vector<Vector2>& flat, std::vector<Triangle> triangles);

  /// \param positions  one column for each vertex [m]
  void follow(const Positions& positions);
  /// Returns the nearest triangle in front of the ray's origin; of those equally near the one with
  /// the lowest number. Both sides count. A ray through an edge that triangles share, but
  /// for its ends, does not pass between them. \pre follow() was called
  std::optional<RayHit> cast(const Ray& ray) const;

 private:
  /// Its children are the node after it and `second`; of a leaf `second` is -1.
  struct Node {
    int second = -1;
    int triangle = -1;
    Eigen::AlignedBox3d box;
  };
  void divide(const std::vector<Vector2>& centers, std::vector<int>::iterator begin,
              std::vector<int>::iterator end);
  void meet(int triangle, const Ray& ray, std::optional<RayHit>& nearest) const;

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;  ///< parents before their children
  Positions positions_;
};

}  // namespace shell_origami
