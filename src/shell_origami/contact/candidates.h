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

/// All pairs that may come within kNear reaches as long as every vertex stays in its room: a box
/// around two configurations with some margin.
class Candidates {
 public:
  /// \param reach of pairs far from each other on the sheet, d^ [m]
  /// \param margin of the rooms [m]
  /// \param most number of pairs that are looked for
  Candidates(const CollisionMesh& mesh, const BoundingTree& tree, const Positions& from,
             const Positions& to, double reach, double margin,
             std::size_t most = std::numeric_limits<std::size_t>::max());

  /// Whether every vertex is in its room.
  bool cover(const Positions& x) const;
  /// False where there are so many that the rest was left out: paper that flies apart.
  bool complete() const { return complete_; }
  /// Always in the same order, whatever the rooms.
  const std::vector<ContactPair>& pairs() const { return pairs_; }

 private:
  void addPairs(const CollisionMesh& mesh, const std::vector<Eigen::AlignedBox3d>& rooms, int f,
                int g);
  void add(const CollisionMesh& mesh, PairKind kind, const std::array<int, 4>& vertices,
           const TrianglePair& faces);

  double reach_;
  std::size_t most_;
  bool complete_ = true;
  Eigen::Matrix3d turn_;  ///< into the frame of the boxes
  std::vector<Eigen::AlignedBox3d> rooms_;
  std::vector<ContactPair> pairs_;
};

}  // namespace shell_origami
