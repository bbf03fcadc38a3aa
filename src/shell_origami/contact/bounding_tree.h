/// \file
/// Which faces may come near each other: trees of boxes over the flat sheet and over bodies.
#pragma once

#include <shell_origami/contact/collision_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace shell_origami {

/// Points that move together: each from a place in a box along a way in a box.
struct MovingBox {
  Eigen::AlignedBox3d places, ways;

  void extend(const MovingBox& other) {
    places.extend(other.places);
    ways.extend(other.ways);
  }
};

/// Whether points of the two boxes may come within `distance` [m], along each axis, at any part of
/// their ways up to `ahead`, the same for both. What moves alike does not come nearer, however far
/// it goes.
inline bool mayMeet(const MovingBox& a, const MovingBox& b, double ahead, double distance) {
  for (int k = 0; k < 3; ++k) {
    const double low = b.places.min()[k] - a.places.max()[k];
    const double high = b.places.max()[k] - a.places.min()[k];
    const double down = ahead * (b.ways.min()[k] - a.ways.max()[k]);
    const double up = ahead * (b.ways.max()[k] - a.ways.min()[k]);
    if (low + std::min(0.0, down) > distance || high + std::max(0.0, up) < -distance) return false;
  }
  return true;
}

/// Faces that lie together on the flat sheet stay together however it is folded, and those of a
/// body anyway, so that the trees are made once and only their boxes follow the motion.
class BoundingTree {
 public:
  explicit BoundingTree(const CollisionMesh& mesh);

  /// Calls found(f, g) for every two faces whose boxes meet, each pair once, in an order that
  /// depends on the tree alone: of the sheet, or, where there are bodies, of the sheet and a body.
  /// `faces` has the box of each face.
  template <class Meet, class Found>
  void forEachPair(const std::vector<MovingBox>& faces, Meet&& meet, Found&& found) const {
    if (nodes_.empty()) return;
    const std::vector<MovingBox> boxes = boxesOfNodes(faces);
    if (body_roots_.empty()) within(boxes, 0, meet, found);
    for (int root : body_roots_) between(boxes, 0, root, meet, found);
  }

 private:
  /// Its children are the node after it and `second`; of a leaf `second` is -1.
  struct Node {
    int second = -1;
    int face = -1;
  };

  void divide(const std::vector<Vector3>& centers, std::vector<int>::iterator begin,
              std::vector<int>::iterator end);
  std::vector<MovingBox> boxesOfNodes(const std::vector<MovingBox>& faces) const;
  template <class Meet, class Found>
  void within(const std::vector<MovingBox>& boxes, int node, Meet& meet, Found& found) const {
    if (nodes_[node].second < 0) return;
    within(boxes, node + 1, meet, found);
    within(boxes, nodes_[node].second, meet, found);
    between(boxes, node + 1, nodes_[node].second, meet, found);
  }
  template <class Meet, class Found>
  void between(const std::vector<MovingBox>& boxes, int a, int b, Meet& meet, Found& found) const {
    if (!meet(boxes[a], boxes[b])) return;
    const bool leaf_a = nodes_[a].second < 0, leaf_b = nodes_[b].second < 0;
    if (leaf_a && leaf_b) {
      found(nodes_[a].face, nodes_[b].face);
    } else if (leaf_a) {
      between(boxes, a, b + 1, meet, found);
      between(boxes, a, nodes_[b].second, meet, found);
    } else if (leaf_b) {
      between(boxes, a + 1, b, meet, found);
      between(boxes, nodes_[a].second, b, meet, found);
    } else {
      for (int child : {a + 1, nodes_[a].second}) {
        between(boxes, child, b + 1, meet, found);
        between(boxes, child, nodes_[b].second, meet, found);
      }
    }
  }

  std::vector<Node> nodes_;  ///< parents before their children; the sheet's tree first
  std::vector<int> body_roots_;
};

}  // namespace shell_origami
