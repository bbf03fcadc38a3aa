/// \file
/// Which faces may come near each other: trees of boxes over the flat sheet and over bodies.
#pragma once

#include <shell_origami/base/parallel.h>
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

  /// Appends to `all` what found(f, g, out) appends to its `out` for every two faces whose boxes
  /// meet: each pair once, of the sheet, or, where there are bodies, of the sheet and a body. The
  /// order of the calls' values depends on the tree alone. `faces` has the box of each face.
  template <class Value, class Meet, class Found>
  void gatherPairs(const std::vector<MovingBox>& faces, std::vector<Value>& all, const Meet& meet,
                   const Found& found) const {
    if (nodes_.empty()) return;
    const std::vector<MovingBox> boxes = boxesOfNodes(faces);
    std::vector<NodePair> pairs = roots();
    for (int round = 0; round < kRounds && pairs.size() < kEnoughPairs; ++round) {
      pairs = divided(pairs, [&](const NodePair& pair) { return near(boxes, pair, meet); });
    }
    gatherChunks(pairs.size(), 1, all, [&](const Chunk& chunk, std::vector<Value>& out) {
      descend(boxes, pairs[chunk.index], meet, [&](int f, int g) { found(f, g, out); });
    });
  }

 private:
  /// Its children are the node after it and `second`; of a leaf `second` is -1.
  struct Node {
    int second = -1;
    int face = -1;
  };

  /// The faces below one node and those below another, or the same, to be compared with each
  /// other.
  struct NodePair {
    int a, b;
  };
  /// A walk through the tree is shared among threads by pairs of nodes. Pairs are divided until
  /// there are enough of them, in so many rounds at most.
  static constexpr int kRounds = 12;
  static constexpr std::size_t kEnoughPairs = 200;

  std::vector<NodePair> roots() const;

  void divide(const std::vector<Vector3>& centers, std::vector<int>::iterator begin,
              std::vector<int>::iterator end);
  std::vector<MovingBox> boxesOfNodes(const std::vector<MovingBox>& faces) const;
  template <class Meet>
  static bool near(const std::vector<MovingBox>& boxes, const NodePair& pair, const Meet& meet) {
    return pair.a == pair.b || meet(boxes[pair.a], boxes[pair.b]);
  }
  bool areLeaves(const NodePair& pair) const {
    return nodes_[pair.a].second < 0 && nodes_[pair.b].second < 0;
  }

  /// Calls visit(pair) for the pairs that one is made up of. \pre they are not leaves
  template <class Visit>
  void forEachBelow(const NodePair& pair, const Visit& visit) const {
    const auto [a, b] = pair;
    const int second_a = nodes_[a].second, second_b = nodes_[b].second;
    if (a == b) {
      visit(NodePair{a + 1, a + 1});
      visit(NodePair{second_a, second_a});
      visit(NodePair{a + 1, second_a});
    } else if (second_a < 0) {
      visit(NodePair{a, b + 1});
      visit(NodePair{a, second_b});
    } else if (second_b < 0) {
      visit(NodePair{a + 1, b});
      visit(NodePair{second_a, b});
    } else {
      for (int child : {a + 1, second_a}) {
        visit(NodePair{child, b + 1});
        visit(NodePair{child, second_b});
      }
    }
  }

  /// Returns the pairs that these are made up of, leaves as they are, without those that are not
  /// near.
  template <class Near>
  std::vector<NodePair> divided(const std::vector<NodePair>& pairs, const Near& is_near) const {
    std::vector<NodePair> below;
    for (const NodePair& pair : pairs) {
      if (!is_near(pair)) continue;
      if (areLeaves(pair)) below.push_back(pair);
      else forEachBelow(pair, [&](const NodePair& part) { below.push_back(part); });
    }
    return below;
  }

  template <class Meet, class Found>
  void descend(const std::vector<MovingBox>& boxes, const NodePair& pair, const Meet& meet,
               const Found& found) const {
    if (!near(boxes, pair, meet)) return;
    if (!areLeaves(pair)) {
      forEachBelow(pair, [&](const NodePair& part) { descend(boxes, part, meet, found); });
    } else if (pair.a != pair.b) {  // a face is not compared with itself
      found(nodes_[pair.a].face, nodes_[pair.b].face);
    }
  }

  std::vector<Node> nodes_;  ///< parents before their children; the sheet's tree first
  std::vector<int> body_roots_;
};

}  // namespace shell_origami
