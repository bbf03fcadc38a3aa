/// \file
/// Whether a pair keeps apart on the way from one configuration to another.
#pragma once

#include <shell_origami/contact/candidates.h>
#include <shell_origami/contact/ccd.h>

#include <algorithm>

namespace shell_origami {

/// What a pair keeps of its distance in a motion that stops() accepts, and in one that freePart()
/// offers: more, so that what is offered is accepted in spite of rounding.
constexpr double kAccepted = 0.1, kOffered = 0.2;

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
  return feasiblePart(pair.kind, pointsOf(pair, from), pointsOf(pair, to), kOffered, pair.reach);
}

/// Whether the pair permits the whole motion.
inline bool isFree(const ContactPair& pair, const Positions& from, const Positions& to) {
  return feasiblePart(pair.kind, pointsOf(pair, from), pointsOf(pair, to), kAccepted,
                      pair.reach / 2) == 1;
}

}  // namespace shell_origami
