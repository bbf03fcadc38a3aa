/// \file
/// Whether a pair keeps apart on the way from one configuration to another.
#pragma once

#include <shell_origami/contact/candidates.h>
#include <shell_origami/contact/ccd.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {

/// The distance that a pair must keep for isFree() to accept a motion.
inline KeptDistance accepted(const ContactPair& pair) { return {0.1, pair.reach / 2, kClosestGap}; }

/// The distance that it keeps in the part of a motion that freePart() returns. It is larger, so
/// that isFree() accepts that part in spite of rounding.
inline KeptDistance offered(const ContactPair& pair) {
  return {0.2, pair.reach, 1.1 * kClosestGap};
}

/// An upper bound [m] of how much closer a motion brings the pair at any time.
inline double approach(const ContactPair& pair, const Positions& from, const Positions& to) {
  const auto& v = pair.vertices;
  const Vector3 common = to.col(v[0]) - from.col(v[0]);
  const auto way = [&](int i) { return (to.col(v[i]) - from.col(v[i]) - common).squaredNorm(); };
  if (pair.kind == PairKind::kVertexFace) return std::sqrt(std::max({way(1), way(2), way(3)}));
  return std::sqrt(way(1)) + std::sqrt(std::max(way(2), way(3)));
}

/// Returns the part of the motion that the pair permits.
inline double freePart(const ContactPair& pair, const Positions& from, const Positions& to) {
  return feasiblePart(pair.kind, pointsOf(pair, from), pointsOf(pair, to), offered(pair));
}

/// Whether the pair permits the whole motion.
inline bool isFree(const ContactPair& pair, const Positions& from, const Positions& to) {
  return feasiblePart(pair.kind, pointsOf(pair, from), pointsOf(pair, to), accepted(pair)) == 1;
}

}  // namespace shell_origami
