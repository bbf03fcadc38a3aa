/// \file
/// Continuous collision detection: how far a pair of primitives may move until it comes too close.
#pragma once

#include <shell_origami/contact/distance.h>

namespace shell_origami {

/// No motion brings two primitives closer than this [m]. It is far above the rounding of positions
/// within 1000 m, so that a certificate in double precision holds for the exact motion as well.
constexpr double kClosestGap = 1e-8;

/// The distance that two primitives keep during a motion: `part` of their distance before it, but
/// at most `enough` [m] and at least `least` [m]. Primitives that are closer than `least` keep all
/// of it.
struct KeptDistance {
  double part, enough, least;
};

/// Returns a part in [0, 1] of the straight motion from `from` to `to` during which the primitives
/// keep apart, never too large.
///
/// Conservative advancement: the plane across the closest points separates the two convex
/// primitives as long as their corners stay on their sides of it, which for a linear motion is
/// decided at its end. A step is never shorter than that of additive CCD (Li, Kaufman and Jiang,
/// Codimensional Incremental Potential Contact, 2021, section 5), and layers that slide along each
/// other are not held up. Nor are layers that turn together, however close: a second plane turns
/// from where the closest points are now to where they will be, and the corners' distances from it
/// are quadratic in time.
double feasiblePart(PairKind kind, const PairPoints& from, const PairPoints& to,
                    const KeptDistance& kept);

}  // namespace shell_origami
