/// The broad phase against all pairs of primitives of folded sheets.
#include <shell_origami/contact/candidates.h>
#include <shell_origami/sheet/fold_line.h>
#include "test/contact/scenes.h"
#include "test/sheet/random_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace shell_origami {
namespace {

/// Closer than this on the flat sheet only what coincides is: sides of slits.
constexpr double kCoincide = 1e-12;

/// A pair, whatever the order of its ends, edges and corners.
using Key = std::array<int, 5>;

Key keyOf(PairKind kind, std::array<int, 4> v) {
  if (kind == PairKind::kEdgeEdge) {
    if (v[0] > v[1]) std::swap(v[0], v[1]);
    if (v[2] > v[3]) std::swap(v[2], v[3]);
    if (std::make_pair(v[0], v[1]) > std::make_pair(v[2], v[3])) {
      std::swap(v[0], v[2]);
      std::swap(v[1], v[3]);
    }
  } else {
    std::sort(v.begin() + 1, v.end());
  }
  return {static_cast<int>(kind), v[0], v[1], v[2], v[3]};
}

/// The vertices of every hinge, in ascending order.
std::set<std::array<int, 4>> hingesOf(const Sheet& sheet) {
  std::set<std::array<int, 4>> hinges;
  for (const Edge& edge : sheet.edges()) {
    std::array<int, 4> v{edge.vertices[0], edge.vertices[1], edge.opposite[0], edge.opposite[1]};
    std::sort(v.begin(), v.end());
    hinges.insert(v);
  }
  return hinges;
}

/// All pairs of primitives that have no vertex in common and are not those of one hinge.
std::vector<std::pair<PairKind, std::array<int, 4>>> allPairs(const Sheet& sheet) {
  std::vector<std::pair<PairKind, std::array<int, 4>>> pairs;
  const auto hinges = hingesOf(sheet);
  const auto add = [&](PairKind kind, const std::array<int, 4>& vertices) {
    std::array<int, 4> v = vertices;
    std::sort(v.begin(), v.end());
    const bool shared = std::adjacent_find(v.begin(), v.end()) != v.end();
    if (!shared && !hinges.count(v)) pairs.emplace_back(kind, vertices);
  };
  for (const Triangle& t : sheet.triangles()) {
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      add(PairKind::kVertexFace, {v, t[0], t[1], t[2]});
    }
  }
  const std::vector<Edge>& edges = sheet.edges();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (std::size_t f = e + 1; f < edges.size(); ++f) {
      add(PairKind::kEdgeEdge,
          {edges[e].vertices[0], edges[e].vertices[1], edges[f].vertices[0], edges[f].vertices[1]});
    }
  }
  return pairs;
}

double distanceAt(PairKind kind, const std::array<int, 4>& v, const Positions& x) {
  return closestPoints(kind, {x.col(v[0]), x.col(v[1]), x.col(v[2]), x.col(v[3])}).distance;
}

Positions flatOf(const Sheet& sheet) {
  Positions x = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) x.col(v).head<2>() = sheet.flatPositions()[v];
  return x;
}

struct Scene {
  Sheet sheet;
  Positions from, to;
};

/// Sheets of any outline, some with slits, folded at random or in pressed pleats.
Scene randomScene(unsigned seed) {
  RandomSheets sheets(seed);
  Random random(seed);
  Sheet sheet(sheets.mesh(random.between(0.02, 0.03)));
  Positions from, to;
  if (seed % 2) {
    from = folded(sheet, 1 + random.below(4), random);
    to = from + 1e-3 * Positions::Random(3, sheet.vertexCount());
  } else {
    from = turned(pleated(sheet, random.between(0.03, 0.06), 1e-4), random);
    to = from + 1e-4 * Positions::Random(3, sheet.vertexCount());
  }
  return {std::move(sheet), from, to};
}

/// Wherever vertices are in the balls that their rooms hold on the whole way, each primitive comes
/// closer to another one by the margin.
TEST(Candidates, AreAllPairsThatComeNearInTheirRooms) {
  int near = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = randomScene(seed);
    const CollisionMesh mesh(scene.sheet);
    const double margin = seed % 3 * 3e-4;
    const Candidates candidates(mesh, BoundingTree(mesh), scene.from, scene.to, kReach, margin);
    std::set<Key> found;
    for (const ContactPair& pair : candidates.pairs()) {
      EXPECT_TRUE(found.insert(keyOf(pair.kind, pair.vertices)).second) << "a pair twice";
    }
    const Positions flat = flatOf(scene.sheet);
    std::set<Key> allowed;
    for (const auto& [kind, vertices] : allPairs(scene.sheet)) {
      const double apart = distanceAt(kind, vertices, flat);
      if (apart < kCoincide) continue;
      const Key key = keyOf(kind, vertices);
      allowed.insert(key);
      const double reach = kNear * std::min(kReach, 0.005 * apart);
      for (const double t : {0.0, 0.3, 0.6, 1.0, 1.5, Candidates::kAhead}) {
        const Positions x = scene.from + t * (scene.to - scene.from);
        if (distanceAt(kind, vertices, x) - 2 * margin > reach) continue;
        ++near;
        EXPECT_TRUE(found.count(key)) << vertices[0] << " " << vertices[2];
        break;
      }
    }
    EXPECT_TRUE(std::includes(allowed.begin(), allowed.end(), found.begin(), found.end()));
  }
  EXPECT_GT(near, 5000);
}

TEST(Candidates, HaveTheReachOfTheirFlatDistance) {
  const Scene scene = randomScene(2);
  const CollisionMesh mesh(scene.sheet);
  const Candidates candidates(mesh, BoundingTree(mesh), scene.from, scene.to, kReach, 1e-3);
  const Positions flat = flatOf(scene.sheet);
  int tapered = 0;
  for (const ContactPair& pair : candidates.pairs()) {
    const double reach = std::min(kReach, 0.005 * distanceAt(pair.kind, pair.vertices, flat));
    EXPECT_NEAR(pair.reach, reach, 1e-15 * kReach);
    tapered += reach < kReach;
  }
  EXPECT_GT(tapered, 0);
}

TEST(Candidates, AreInOneOrderWhateverTheRooms) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Scene scene = randomScene(seed);
    const CollisionMesh mesh(scene.sheet);
    const BoundingTree tree(mesh);
    const Candidates few(mesh, tree, scene.from, scene.from, kReach, 0);
    const Candidates many(mesh, tree, scene.from, scene.to, kReach, 5e-3);
    const Candidates other(mesh, tree, scene.to, scene.from, kReach, 3e-3);
    EXPECT_GT(many.pairs().size(), few.pairs().size());
    std::map<Key, int> places;
    for (const ContactPair& pair : many.pairs()) {
      places.emplace(keyOf(pair.kind, pair.vertices), static_cast<int>(places.size()));
    }
    for (const Candidates* some : {&few, &other}) {
      int last = -1;
      for (const ContactPair& pair : some->pairs()) {
        const auto place = places.find(keyOf(pair.kind, pair.vertices));
        if (place == places.end()) continue;
        EXPECT_GT(place->second, last) << seed;
        last = place->second;
        const ContactPair& same = many.pairs()[last];
        EXPECT_EQ(same.vertices, pair.vertices);
        EXPECT_EQ(same.reach, pair.reach);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 5000);
}

/// The sides of a slit coincide, also where a vertex of one lies between those of the other.
TEST(Candidates, LeaveTheSidesOfSlitsAlone) {
  Sheet sheet(slits(0.02));
  const auto onSlit = [&](const Edge& edge) {
    const auto inside = [&](int v) {
      const Vector2& p = sheet.flatPositions()[v];
      return p.x() > 1e-9 && p.x() < 0.15 - 1e-9 && p.y() > 1e-9 && p.y() < 0.15 - 1e-9;
    };
    return edge.onBorder() && (inside(edge.vertices[0]) || inside(edge.vertices[1]));
  };
  RandomSheets random(1);
  int split = 0;
  for (int i = 0; i < 2000 && split < 12; ++i) {
    const Edge& edge = sheet.edges()[random.below(static_cast<int>(sheet.edges().size()))];
    if (!onSlit(edge)) continue;
    addVertex(sheet, edge.vertices[0], edge.vertices[1], random.between(0.2, 0.8));
    ++split;
  }
  ASSERT_EQ(split, 12);
  const CollisionMesh mesh(sheet);
  const Positions flat = flatOf(sheet);
  const Candidates candidates(mesh, BoundingTree(mesh), flat, flat, kReach, 1e-3);
  int left_out = 0;
  for (const auto& [kind, vertices] : allPairs(sheet)) {
    left_out += distanceAt(kind, vertices, flat) < kCoincide;
  }
  EXPECT_GT(left_out, 50);
  EXPECT_GT(candidates.pairs().size(), 50u);
  for (const ContactPair& pair : candidates.pairs()) {
    EXPECT_GT(distanceAt(pair.kind, pair.vertices, flat), kCoincide)
        << pair.vertices[0] << " " << pair.vertices[1] << ": " << pair.reach;
  }
}

TEST(Candidates, CoverTheirRooms) {
  const Scene scene = randomScene(4);
  const CollisionMesh mesh(scene.sheet);
  const double margin = 1e-3;
  const Candidates candidates(mesh, BoundingTree(mesh), scene.from, scene.to, kReach, margin);
  const Candidates tight(mesh, BoundingTree(mesh), scene.from, scene.to, kReach, 0);
  EXPECT_TRUE(tight.cover(scene.from));
  EXPECT_TRUE(tight.cover(scene.to));
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const double t = random.between(0, Candidates::kAhead);
    Positions x = scene.from + t * (scene.to - scene.from);
    for (int v = 0; v < x.cols(); ++v) x.col(v) += 0.999 * margin * random.direction();
    EXPECT_TRUE(candidates.cover(x));
    // Outside, however the box is turned: it reaches by the way and the root of 3 times the margin
    // at most.
    const int v = random.below(static_cast<int>(x.cols()));
    const double way = (scene.to.col(v) - scene.from.col(v)).norm();
    const double farthest = std::sqrt(3) * margin + Candidates::kAhead * way;
    x.col(v) = scene.from.col(v) + 1.001 * farthest * random.direction();
    EXPECT_FALSE(candidates.cover(x));
  }
  Positions nowhere = scene.from;
  nowhere(1, 3) = NAN;
  EXPECT_FALSE(candidates.cover(nowhere));
}

}  // namespace
}  // namespace shell_origami
