/// Continuous collision detection against exact arithmetic: never late, and early only as promised.
#include <shell_origami/contact/ccd.h>
#include <shell_origami/contact/guard.h>
#include "test/contact/reference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shell_origami {
namespace {

struct Query {
  PairKind kind;
  PairPoints from, to;
};

/// Makes queries of one kind of motion.
class Queries {
 public:
  explicit Queries(unsigned seed) : random_(seed) {}

  Query random(PairKind kind) {
    Query q{kind, {}, {}};
    for (int i = 0; i < 4; ++i) {
      q.from[i] = random_.inCube(size_);
      q.to[i] = random_.inCube(size_);
    }
    return q;
  }
  /// Faces and edges that are a line or a point, at the start, at the end or all the time.
  Query degenerate(PairKind kind) {
    Query q = random(kind);
    const int when = random_.below(3);
    if (when != 1) collapse(kind, q.from);
    if (when != 0) collapse(kind, q.to);
    return q;
  }
  /// All in one plane, exactly.
  Query coplanar(PairKind kind) {
    Query q = random(kind);
    const int axis = random_.below(3);
    const double height = random_.inCube(size_).x();
    for (int i = 0; i < 4; ++i) q.from[i][axis] = q.to[i][axis] = height;
    return q;
  }
  /// Edges, or sides of the face and ways, in one direction, up to rounding or exactly.
  Query parallel(PairKind kind) {
    Query q = random(kind);
    const Vector3 along = q.from[1] - q.from[0];
    const double part = random_.below(2) ? 1 : random_.between(-2, 2);
    q.from[3] = q.from[2] + part * along;
    const Vector3 way = 2 * random_.inCube(size_), other = 2 * random_.inCube(size_);
    for (int i = 0; i < 4; ++i) q.to[i] = q.from[i] + (i < firstSize(kind) ? way : other);
    return q;
  }
  /// Layers that lie a gap apart and are moved along each other.
  Query layers(PairKind kind, double gap) {
    Query q = random(kind);
    for (int i = 0; i < 4; ++i) q.from[i].z() = q.to[i].z() = i < firstSize(kind) ? gap : 0;
    turn(q);
    return q;
  }
  /// The same of primitives that lie across each other all the time.
  Query overlappingLayers(PairKind kind, double gap) {
    Query q{kind, {}, {}};
    PairPoints at{Vector3(-1, 0, 0), Vector3(1, 0, 0), Vector3(0, -1, 0), Vector3(0, 1, 0)};
    if (kind == PairKind::kVertexFace) at = {Vector3(0, 0, 0), Vector3(-1, -1, 0), at[1], at[3]};
    for (int i = 0; i < 4; ++i) {
      for (PairPoints* x : {&q.from, &q.to}) {
        (*x)[i] = size_ * (at[i] + random_.inCube(0.1));
        (*x)[i].z() = i < firstSize(kind) ? gap : 0;
      }
    }
    turn(q);
    return q;
  }
  /// Points of one plane, of which those of the first primitive are moved off it by one ulp.
  Query oneUlp(PairKind kind) {
    Query q = coplanar(kind);
    int axis = 0;
    while (q.from[0][axis] != q.from[3][axis]) ++axis;
    for (int i = 0; i < firstSize(kind); ++i) {
      q.from[i][axis] = q.to[i][axis] = std::nextafter(q.from[3][axis], 1e9);
    }
    if (random_.below(2)) turn(q);
    if (random_.below(2)) {
      for (int i = 0; i < 4; ++i) q.to[i] = q.from[i] + 1e-3 * (q.to[i] - q.from[i]);
    }
    return q;
  }
  /// The first primitive moves through the second one and as far again.
  Query headOn(PairKind kind) {
    Query q = random(kind);
    const double gap = size_ * std::pow(10, random_.between(-6, 0));
    Vector3 center = Vector3::Zero();
    for (int i = 0; i < 4; ++i) {
      q.from[i].z() = 0;
      if (i > 0) center += q.from[i] / 3;
    }
    if (kind == PairKind::kVertexFace) {
      q.from[0] = center;
    } else {
      const Vector3 crossing = q.from[0] + random_.between(0.1, 0.9) * (q.from[1] - q.from[0]);
      q.from[3] = 2 * crossing - q.from[2];
    }
    q.to = q.from;
    for (int i = 0; i < firstSize(kind); ++i) {
      q.from[i].z() = gap;
      q.to[i].z() = -gap;
    }
    turn(q);
    return q;
  }
  /// The first primitive, or for a face the second one, turns by up to half a turn.
  Query spinning(PairKind kind) {
    Query q = random(kind);
    const Eigen::Matrix3d rotation = random_.rotation();
    const Vector3 way = random_.below(2) ? Vector3::Zero() : random_.inCube(size_);
    q.to = q.from;
    const int begin = kind == PairKind::kVertexFace ? 1 : 0;
    const int end = kind == PairKind::kVertexFace ? 4 : 2;
    Vector3 center = Vector3::Zero();
    for (int i = begin; i < end; ++i) center += q.from[i] / (end - begin);
    for (int i = begin; i < end; ++i) q.to[i] = center + way + rotation * (q.from[i] - center);
    return q;
  }

  /// Query number i: every kind of motion in turn, of primitives of 1 mm to 10 cm, near the origin
  /// or up to 1000 m from it.
  Query make(int i) {
    const PairKind kind = i % 2 ? PairKind::kVertexFace : PairKind::kEdgeEdge;
    size_ = std::pow(10, random_.between(-3, -1));
    Query q = motion(kind, motionOf(i));
    if (random_.below(4) == 0) {
      const Vector3 place = random_.inCube(std::pow(10, random_.between(-1, 2.75)));
      for (int k = 0; k < 4; ++k) {
        q.from[k] += place;
        q.to[k] += place;
      }
    }
    return q;
  }
  static constexpr int kMotions = 9;
  static int motionOf(int i) { return i / 2 % kMotions; }

 private:
  Query motion(PairKind kind, int motion) {
    switch (motion) {
      case 0: return degenerate(kind);
      case 1: return coplanar(kind);
      case 2: return parallel(kind);
      case 3: return layers(kind, 1e-6);
      case 4: return layers(kind, 1e-9);
      case 5: return oneUlp(kind);
      case 6: return headOn(kind);
      case 7: return spinning(kind);
      default: return random(kind);
    }
  }
  void collapse(PairKind kind, PairPoints& x) {
    if (kind == PairKind::kEdgeEdge) {
      if (random_.below(2)) x[1] = x[0];
      if (random_.below(2)) x[3] = x[2];
    } else if (random_.below(2)) {
      x[2] = x[3] = x[1];
    } else {
      x[3] = x[1] + random_.between(-1, 2) * (x[2] - x[1]);
    }
  }
  void turn(Query& q) {
    const Eigen::Matrix3d rotation = random_.rotation();
    for (int i = 0; i < 4; ++i) {
      q.from[i] = rotation * q.from[i];
      q.to[i] = rotation * q.to[i];
    }
  }

  Random random_;
  double size_ = 1e-2;  ///< half of a primitive's [m]
};

/// What feasiblePart() is asked to keep: as a pair whose reach is 50 um, in a step that is offered.
constexpr KeptDistance kKept{0.2, 5e-5, 1.1 * kClosestGap};

/// What it keeps of this distance.
double keptOf(double distance) {
  return std::min(distance, std::max(kKept.least, std::min(kKept.part * distance, kKept.enough)));
}

double permitted(const Query& q) { return feasiblePart(q.kind, q.from, q.to, kKept); }

double distanceAt(const Query& q, double part) {
  std::array<Long3, 4> x;
  for (int k = 0; k < 4; ++k) {
    x[k] = (1 - static_cast<Long>(part)) * q.from[k].cast<Long>() + part * q.to[k].cast<Long>();
  }
  return static_cast<double>(longClosest(q.kind, x).distance);
}

constexpr int kQueries = 100000;

TEST(FeasiblePart, IsNeverLate) {
  Queries queries(1);
  std::array<std::array<int, 3>, Queries::kMotions> counts{};
  for (int i = 0; i < kQueries; ++i) {
    const Query q = queries.make(i);
    const double part = permitted(q);
    ASSERT_TRUE(part >= 0 && part <= 1) << i;
    ++counts[queries.motionOf(i)][part == 0 ? 0 : part < 1 ? 1 : 2];
    if (part == 0) continue;
    ASSERT_TRUE(provedApart(q.kind, q.from, q.to, part)) << i << ": " << part;
  }
  // None of the motions leaves the proof nothing to do.
  for (const auto& [none, some, whole] : counts) EXPECT_GT(some + whole, none);
}

/// Gaps as small as the positions' rounding, oblique and far from the origin: the corners' products
/// with a direction are rounded by as much.
TEST(FeasiblePart, IsNotLateWithinRounding) {
  Random random(2);
  int moved = 0;
  for (const double size : {1e-6, 1e-7, 3e-8}) {
    for (int i = 0; i < kQueries / 3; ++i) {
      const double gap = random.between(0.2, 2) * 1e-13;
      const Eigen::Matrix3d rotation = random.rotation();
      const Vector3 place = 500 * random.direction();
      Query q{i % 2 ? PairKind::kVertexFace : PairKind::kEdgeEdge, {}, {}};
      const PairPoints at = q.kind == PairKind::kVertexFace
                                ? PairPoints{Vector3(0, 0, gap), Vector3(-size, -size, 0),
                                             Vector3(size, -size, 0), Vector3(0, size, 0)}
                                : PairPoints{Vector3(-size, 0, gap), Vector3(size, 0, gap),
                                             Vector3(0, -size, 0), Vector3(0, size, 0)};
      for (int k = 0; k < 4; ++k) {
        const auto nearby = [&]() -> Vector3 {
          return at[k] + size * Vector3(random.between(-.1, .1), random.between(-.1, .1), 0);
        };
        q.from[k] = place + rotation * nearby();
        q.to[k] = place + rotation * nearby();
      }
      const double part = permitted(q);
      if (part == 0) continue;
      ++moved;
      ASSERT_TRUE(provedApart(q.kind, q.from, q.to, part)) << size << " " << i;
    }
  }
  EXPECT_GT(moved, kQueries / 20);
}

TEST(FeasiblePart, ProofsFailWherePrimitivesPass) {
  Queries queries(3);
  for (int i = 0; i < 200; ++i) {
    const Query q = queries.headOn(i % 2 ? PairKind::kVertexFace : PairKind::kEdgeEdge);
    EXPECT_FALSE(provedApart(q.kind, q.from, q.to, 1));
    EXPECT_TRUE(provedApart(q.kind, q.from, q.to, 0.49));
  }
}

/// A stop leaves 1.2 times the kept distance at most, unless it is that of the last plane: 1 of
/// 1,000 motions pass each other so closely and at such a slant that 64 planes do not suffice.
TEST(FeasiblePart, IsNotNeedlesslyEarly) {
  Queries queries(1);
  int stopped = 0, early = 0, far = 0;
  for (int i = 0; i < kQueries; ++i) {
    const Query q = queries.make(i);
    const double part = permitted(q), distance = distanceAt(q, 0);
    Positions from(3, 4), to(3, 4);
    for (int k = 0; k < 4; ++k) {
      from.col(k) = q.from[k];
      to.col(k) = q.to[k];
    }
    // Whatever the way, this much is left.
    if (distance - approach({q.kind, {0, 1, 2, 3}, 0}, from, to) > keptOf(distance)) {
      ++far;
      EXPECT_EQ(part, 1) << i;
    }
    // Within the last digits of a direction two that are this close cannot be told apart.
    if (part == 1 || distance < kKept.least) continue;
    ++stopped;
    const double left = distanceAt(q, part);
    EXPECT_GT(left, 0.999 * keptOf(distance)) << i;
    early += left > 1.2 * keptOf(distance) * (1 + 1e-6);
  }
  EXPECT_GT(far, kQueries / 20);
  EXPECT_GT(stopped, kQueries / 4);
  EXPECT_LT(early, stopped / 1000) << "of " << stopped;
}

TEST(FeasiblePart, HeadOnLeavesWhatItPromises) {
  Queries queries(4);
  for (int i = 0; i < 2000; ++i) {
    const Query q = queries.headOn(i % 2 ? PairKind::kVertexFace : PairKind::kEdgeEdge);
    const double distance = distanceAt(q, 0), left = distanceAt(q, permitted(q));
    // The first plane is the one that they move across; what is lost is what it is tilted, by the
    // rounding of primitives of 1 cm over their distance.
    EXPECT_NEAR(left / keptOf(distance), 1, 1e-3) << distance;
  }
}

TEST(FeasiblePart, LayersSlide) {
  Queries queries(5);
  for (const double gap : {1e-4, 1e-6, 2e-8}) {
    for (int i = 0; i < 2000; ++i) {
      const Query q =
          queries.overlappingLayers(i % 2 ? PairKind::kVertexFace : PairKind::kEdgeEdge, gap);
      EXPECT_EQ(permitted(q), 1) << gap;
    }
  }
}

TEST(FeasiblePart, LayersTurnTogether) {
  Queries queries(8);
  Random random(8);
  for (const double gap : {1e-4, 1e-6, 2e-8}) {
    for (int i = 0; i < 2000; ++i) {
      Query q = queries.overlappingLayers(i % 2 ? PairKind::kVertexFace : PairKind::kEdgeEdge, gap);
      // The closer they are, the shorter the ways on which the plane's turn is theirs.
      const Eigen::AngleAxisd turn(random.between(0, gap > 1e-7 ? 0.1 : 0.02), random.direction());
      for (int k = 0; k < 4; ++k) q.to[k] = turn * q.from[k];
      EXPECT_EQ(permitted(q), 1) << gap << " " << i;
    }
  }
}

TEST(FeasiblePart, IsTheSameFarFromTheOrigin) {
  Queries queries(6);
  const double grid = std::ldexp(1, -40);
  const auto snapped = [&](double value) { return grid * std::round(value / grid); };
  for (int i = 0; i < 4000; ++i) {
    Query q = queries.random(i % 2 ? PairKind::kVertexFace : PairKind::kEdgeEdge);
    Query far = q;
    for (int k = 0; k < 4; ++k) {
      q.from[k] = q.from[k].unaryExpr(snapped);
      q.to[k] = q.to[k].unaryExpr(snapped);
      far.from[k] = q.from[k] + Vector3(512, -256, 128);
      far.to[k] = q.to[k] + Vector3(-128, 1024, 2);
    }
    EXPECT_EQ(permitted(q), permitted(far));
  }
}

TEST(Guard, AcceptsWhatItOffers) {
  Queries queries(7);
  int shortened = 0;
  for (int i = 0; i < kQueries; ++i) {
    const Query q = queries.make(i);
    const ContactPair pair{q.kind, {0, 1, 2, 3}, i % 3 ? 5e-5 : 1e-7};
    Positions from(3, 4), to(3, 4);
    for (int k = 0; k < 4; ++k) {
      from.col(k) = q.from[k];
      to.col(k) = q.to[k];
    }
    const double part = freePart(pair, from, to);
    if (part == 0) continue;
    shortened += part < 1;
    const Positions there = part < 1 ? Positions(from + part * (to - from)) : to;
    EXPECT_TRUE(isFree(pair, from, there)) << i << ": " << part;
  }
  EXPECT_GT(shortened, kQueries / 5);
}

}  // namespace
}  // namespace shell_origami
