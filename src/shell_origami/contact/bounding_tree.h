/// \file
/// Which faces may come near each other: a tree of boxes over the flat sheet.
#pragma once

#include <shell_origami/contact/collision_mesh.h>

#include <Eigen/Geometry>

#include <vector>

namespace shell_origami {

/// Faces that lie together on the flat sheet stay together however it is folded, so that the tree
/// is made once and only its boxes follow the paper.
class BoundingTree {
 public:
  explicit BoundingTree(const CollisionMesh& mesh);

  /// Calls found(f, g) for every two faces whose corners' boxes meet, each pair once, in an order
  /// that depends on the tree alone. `rooms` has the box of each vertex.
  template <class Found>
  void forEachPair(const CollisionMesh& mesh, const std::vector<Eigen::AlignedBox3d>& rooms,
                   Found&& found) const {
    if (nodes_.empty()) return;
    const std::vector<Eigen::AlignedBox3d> boxes = boxesOfNodes(mesh, rooms);
    within(boxes, 0, found);
  }

 private:
  /// Its children are the node after it and `second`; of a leaf `second` is -1.
  struct Node {
    int second = -1;
    int face = -1;
  };

  void divide(const std::vector<Vector2>& centers, std::vector<int>::iterator begin,
              std::vector<int>::iterator end);
  std::vector<Eigen::AlignedBox3d> boxesOfNodes(
      const CollisionMesh& mesh, const std::vector<Eigen::AlignedBox3d>& rooms) const;
  template <class Found>
  void within(const std::vector<Eigen::AlignedBox3d>& boxes, int node, Found& found) const {
    if (nodes_[node].second < 0) return;
    within(boxes, node + 1, found);
    within(boxes, nodes_[node].second, found);
    between(boxes, node + 1, nodes_[node].second, found);
  }
  template <class Found>
  void between(const std::vector<Eigen::AlignedBox3d>& boxes, int a, int b, Found& found) const {
    if (!boxes[a].intersects(boxes[b])) return;
    const bool leaf_a = nodes_[a].second < 0, leaf_b = nodes_[b].second < 0;
    if (leaf_a && leaf_b) {
      found(nodes_[a].face, nodes_[b].face);
    } else if (leaf_a) {
      between(boxes, a, b + 1, found);
      between(boxes, a, nodes_[b].second, found);
    } else if (leaf_b) {
      between(boxes, a + 1, b, found);
      between(boxes, nodes_[a].second, b, found);
    } else {
      for (int child : {a + 1, nodes_[a].second}) {
        between(boxes, child, b + 1, found);
        between(boxes, child, nodes_[b].second, found);
      }
    }
  }

  std::vector<Node> nodes_;  ///< parents before their children
};

}  // namespace shell_origami
