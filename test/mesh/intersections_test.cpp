/// Which triangles pass through each other, against other exact predicates.
#include <shell_origami/mesh/intersections.h>

#include <CGAL/MP_Float.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace shell_origami {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

/// Triangles of three vertices each.
struct Soup {
  Positions x;
  std::vector<Triangle> triangles;
  std::vector<int> names;

  explicit Soup(const std::vector<std::array<Vector3, 3>>& corners)
      : x(3, 3 * corners.size()), names(3 * corners.size()) {
    std::iota(names.begin(), names.end(), 0);
    for (int t = 0; t < static_cast<int>(corners.size()); ++t) {
      triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
      for (int k = 0; k < 3; ++k) x.col(3 * t + k) = corners[t][k];
    }
  }
  Pairs found() const { return intersections(x, triangles, names); }
};

const std::array<Vector3, 3> kBase{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)};
const Pairs kBoth{{0, 1}}, kNone{};

Pairs withBase(const Vector3& a, const Vector3& b, const Vector3& c) {
  return Soup({kBase, {a, b, c}}).found();
}

TEST(Intersections, CrossingTriangles) {
  EXPECT_EQ(withBase({.2, .2, -1}, {.3, .2, 1}, {.2, .3, 1}), kBoth) << "a corner through the face";
  EXPECT_EQ(withBase({.3, -.5, -.3}, {.3, .4, .1}, {.3, -.5, .3}), kBoth) << "across a side";
  EXPECT_EQ(withBase({.2, .2, -1}, {.2, .3, -1}, {.9, .9, .5}), kNone) << "past its long side";
}

TEST(Intersections, TouchingTriangles) {
  EXPECT_EQ(withBase({.2, .2, 0}, {.3, .2, 1}, {.2, .3, 1}), kBoth) << "a corner on the face";
  EXPECT_EQ(withBase({.5, 0, 0}, {.5, -1, 1}, {.6, -1, 1}), kBoth) << "a corner on a side";
  EXPECT_EQ(withBase({1, 0, 0}, {2, 0, 1}, {2, 1, 1}), kBoth) << "two corners, of two names";
  EXPECT_EQ(withBase({-1, 0, 0}, {2, 0, 0}, {0, 0, 1}), kBoth) << "a side along a side";
  const double ulp = std::nextafter(0.0, 1.0);
  EXPECT_EQ(withBase({.2, .2, ulp}, {.3, .2, 1}, {.2, .3, 1}), kNone) << "by the least number";
  const double above = std::nextafter(0.5, 1.0);
  EXPECT_EQ(withBase({.5, .5, 0}, {1, 1, 1}, {1, 1, -1}), kBoth) << "on the long side";
  EXPECT_EQ(withBase({.5, above, 0}, {1, 1, 1}, {1, 1, -1}), kNone) << "an ulp beside it";
}

TEST(Intersections, CoplanarTriangles) {
  EXPECT_EQ(withBase({.1, .1, 0}, {1, .1, 0}, {.1, 1, 0}), kBoth) << "overlapping";
  EXPECT_EQ(withBase({.1, .1, 0}, {.2, .1, 0}, {.1, .2, 0}), kBoth) << "inside";
  EXPECT_EQ(withBase({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), kBoth) << "the same";
  EXPECT_EQ(withBase({0, 0, 0}, {1, 0, 0}, {0, -1, 0}), kBoth) << "a side in common";
  EXPECT_EQ(withBase({2, 0, 0}, {3, 0, 0}, {2, 1, 0}), kNone) << "beside each other";
  EXPECT_EQ(withBase({.1, .1, 1e-300}, {1, .1, 1e-300}, {.1, 1, 1e-300}), kNone) << "above it";
}

TEST(Intersections, TrianglesOfOneVertex) {
  Soup soup({kBase, {Vector3(0, 0, 0), Vector3(.5, .2, 1), Vector3(.5, .2, -1)}});
  EXPECT_EQ(soup.found(), kBoth);
  soup.names[3] = soup.names[0];
  EXPECT_EQ(soup.found(), kNone) << "of one name, as on the sides of a slit";
  soup.names[3] = 3;
  soup.triangles[1][0] = 0;
  EXPECT_EQ(soup.found(), kNone) << "of one number";
}

TEST(Intersections, TrianglesWithoutAreaMeetNothing) {
  EXPECT_EQ(withBase({.2, .2, -1}, {.2, .2, 0}, {.2, .2, 1}), kNone) << "a line";
  EXPECT_EQ(withBase({.2, .2, 0}, {.2, .2, 0}, {.2, .2, 0}), kNone) << "a point";
  EXPECT_EQ(withBase({.2, .2, -1}, {.2, .2, -1}, {.3, .3, 1}), kNone) << "two corners in one place";
  const double tiny = 1e-160;  // its area is less than the least number
  EXPECT_EQ(withBase({.2, .2, -1}, {.2, .2, 1}, {.2 + tiny, .2, 1}), kNone) << "rounded to a line";
  EXPECT_EQ(withBase({0, 0, -1}, {tiny, 0, 1}, {0, tiny, 1}), kBoth) << "all but a line";
}

TEST(Intersections, PairsAreInOrder) {
  const std::array<Vector3, 3> needle{Vector3(.2, .2, -1), Vector3(.25, .2, 1),
                                      Vector3(.2, .25, 1)};
  const std::array<Vector3, 3> far{Vector3(5, 0, 0), Vector3(6, 0, 0), Vector3(5, 1, 0)};
  EXPECT_EQ(Soup({needle, far, kBase, kBase}).found(), (Pairs{{0, 2}, {0, 3}, {2, 3}}));
  EXPECT_EQ(Soup({}).found(), kNone);
}

/// Segments against triangles by signs of determinants in exact arithmetic.
class Predicates {
 public:
  explicit Predicates(const Positions& x) {
    for (int v = 0; v < x.cols(); ++v) points_.push_back({x(0, v), x(1, v), x(2, v)});
  }
  /// \pre no four of the points are in one plane
  bool meet(const Triangle& s, const Triangle& t) const {
    for (int k = 0; k < 3; ++k) {
      if (pierces(s[k], s[(k + 1) % 3], t) || pierces(t[k], t[(k + 1) % 3], s)) return true;
    }
    return false;
  }

 private:
  using Exact = CGAL::MP_Float;
  using Point = std::array<Exact, 3>;

  int side(int a, int b, int c, int d) const {
    const Point u = less(b, a), v = less(c, a), w = less(d, a);
    const Exact volume = u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
                         u[2] * (v[0] * w[1] - v[1] * w[0]);
    return CGAL::sign(volume);
  }
  Point less(int b, int a) const {
    return {points_[b][0] - points_[a][0], points_[b][1] - points_[a][1],
            points_[b][2] - points_[a][2]};
  }
  bool pierces(int p, int q, const Triangle& t) const {
    if (side(t[0], t[1], t[2], p) == side(t[0], t[1], t[2], q)) return false;
    const int around = side(p, q, t[0], t[1]);
    return side(p, q, t[1], t[2]) == around && side(p, q, t[2], t[0]) == around;
  }
  std::vector<Point> points_;
};

/// Triangles that share vertices by number and by name, some of them tiny or thin.
TEST(Intersections, OfRandomSoupsAreThoseOfAllPairs) {
  std::mt19937 engine(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  int meeting = 0, apart = 0;
  for (int round = 0; round < 40; ++round) {
    constexpr int kVertices = 60, kTriangles = 40;
    Positions x(3, kVertices);
    for (int v = 0; v < kVertices; ++v) {
      const double size = round % 2 && v % 3 ? 1e-6 : 0.3;
      const Vector3 center = v % 3 && round % 2 ? Vector3(x.col(v - v % 3)) : Vector3(0, 0, 0);
      x.col(v) = center + size * Vector3(between(-1, 1), between(-1, 1), between(-1, 1));
    }
    std::vector<Triangle> triangles;
    for (int t = 0; t < kTriangles; ++t) {
      const int v = static_cast<int>(engine() % (kVertices - 4));
      triangles.push_back({v, v + 1, v + 2 + static_cast<int>(engine() % 2)});
    }
    std::vector<int> names(kVertices);
    std::iota(names.begin(), names.end(), 0);
    for (int v = 30; v < 36; ++v) names[v] = v - 30;
    const Predicates exact(x);
    Pairs expected;
    for (int f = 0; f < kTriangles; ++f) {
      for (int g = f + 1; g < kTriangles; ++g) {
        bool shared = false;
        for (int v : triangles[f]) {
          for (int w : triangles[g]) shared |= names[v] == names[w];
        }
        const bool meet = !shared && exact.meet(triangles[f], triangles[g]);
        if (meet) expected.push_back({f, g});
        ++(meet ? meeting : apart);
      }
    }
    EXPECT_EQ(intersections(x, triangles, names), expected) << round;
  }
  EXPECT_GT(meeting, 3000);
  EXPECT_GT(apart, 20000);
}

}  // namespace
}  // namespace shell_origami
