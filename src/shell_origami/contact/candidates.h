/// \file
/// The pairs of primitives that can come near each other.
#pragma once

#include <shell_origami/contact/bounding_tree.h>

#include <limits>
#include <vector>

namespace shell_origami {

/// Closer than this many reaches pairs are looked at closely, and have their place in the matrix.
constexpr double kNear = 2;

/// A vertex and a face, or two edges, that are not incident.
struct ContactPair {
  PairKind kind;
  std::array<int, 4> vertices;  ///< in the order of PairPoints
  double reach;                 ///< distance within which they push, d^ [m]
  TrianglePair faces{-1, -1};   ///< that they belong to
};

inline PairPoints pointsOf(const ContactPair& pair, const Positions& x) {
  const auto& v = pair.vertices;
  return {x.col(v[0]), x.col(v[1]), x.col(v[2]), x.col(v[3])};
}

/// All pairs that may come within kNear reaches in a room of configurations: those up to kAhead of
/// the way from one to another, with a margin in which each vertex is by itself. The room is
/// convex, so that it holds every straight motion between configurations in it, and it follows
/// paper that moves on as it did.
class Candidates {
 public:
  /// \param reach of pairs far from each other on the sheet, d^ [m]
  /// \param margin around each vertex [m]
  /// \param most number of pairs
  Candidates(const CollisionMesh& mesh, const BoundingTree& tree, const Positions& from,
             const Positions& to, double reach, double margin,
             std::size_t most = std::numeric_limits<std::size_t>::max());

  /// How much of the way is in the room: paper that keeps its speed stays in it for some steps.
  static constexpr double kAhead = 4;

  /// Whether x is in the room.
  bool cover(const Positions& x) const;
  /// False, and there are no pairs, where these would be too many: paper that flies apart.
  bool complete() const { return complete_; }
  /// Always in the same order, whatever the room.
  const std::vector<ContactPair>& pairs() const { return pairs_; }

 private:
  bool meet(const MovingBox& a, const MovingBox& b) const {
    return mayMeet(a, b, kAhead, 2 * margin_ + kNear * reach_);
  }
  /// The boxes of a mesh's faces and edges.
  struct Boxes {
    std::vector<MovingBox> faces, edges;
  };

  MovingBox boxOf(int vertex) const {
    return {Eigen::AlignedBox3d(Vector3(places_.col(vertex))),
            Eigen::AlignedBox3d(Vector3(ways_.col(vertex)))};
  }
  MovingBox boxOf(const std::array<int, 2>& edge) const;
  MovingBox boxOf(const Triangle& face) const;
  void addPairs(const CollisionMesh& mesh, const Boxes& boxes, int f, int g,
                std::vector<ContactPair>& pairs) const;
  void add(const CollisionMesh& mesh, PairKind kind, const std::array<int, 4>& vertices,
           const TrianglePair& faces, std::vector<ContactPair>& pairs) const;

  double reach_, margin_;
  bool complete_ = true;
  Eigen::Matrix3d turn_;     ///< into the frame of the boxes
  Positions places_, ways_;  ///< of vertices, in that frame
  std::vector<ContactPair> pairs_;
};

}  // namespace shell_origami
