#include <shell_origami/mesh/triangulate.h>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180;

struct Figures {
  double smallest_angle = M_PI;  // [rad]
  double mean_angle = 0;         // mean over the triangles of their smallest [rad]
  double longest = 0, area = 0;
};

Figures figures(const Triangulation& mesh) {
  Figures result;
  for (const Triangle& t : mesh.triangles()) {
    double smallest = M_PI;
    for (int k = 0; k < 3; ++k) {
      const Vector2 &p = mesh.points()[t[k]], &q = mesh.points()[t[(k + 1) % 3]],
                    &r = mesh.points()[t[(k + 2) % 3]];
      const double angle = std::atan2(doubleArea(p, q, r), (q - p).dot(r - p));
      smallest = std::min(smallest, angle);
      result.longest = std::max(result.longest, (q - p).norm());
    }
    result.smallest_angle = std::min(result.smallest_angle, smallest);
    result.mean_angle += smallest / mesh.triangles().size();
    result.area += doubleArea(mesh.points()[t[0]], mesh.points()[t[1]], mesh.points()[t[2]]) / 2;
  }
  return result;
}

PlanarGraph polygon(std::vector<Vector2> corners) {
  PlanarGraph graph;
  const int count = static_cast<int>(corners.size());
  for (int i = 0; i < count; ++i) graph.segments.push_back({i, (i + 1) % count});
  graph.points = std::move(corners);
  return graph;
}

PlanarGraph square(double side) { return polygon({{0, 0}, {side, 0}, {side, side}, {0, side}}); }

/// What a call refuses with; empty when it does not.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

void expectWithin(const std::string& sentence, const std::string& part) {
  EXPECT_NE(sentence.find(part), std::string::npos)
      << "'" << sentence << "' lacks '" << part << "'";
}

TEST(TriangulateRectangle, isNearEquilateralWithinMaxEdge) {
  const double sizes[][3] = {{0.15, 0.15, 0.01}, {0.15, 0.15, 0.004}, {0.21, 0.297, 0.01},
                             {0.1, 0.01, 0.005}, {0.01, 0.1, 0.005},  {0.3, 0.02, 0.0033},
                             {0.15, 0.002, 0.01}};
  for (const auto& [width, height, max_edge] : sizes) {
    SCOPED_TRACE(testing::Message() << width << " x " << height << " at " << max_edge);
    const Figures f = figures(triangulateRectangle(width, height, max_edge));
    EXPECT_GE(f.smallest_angle, 34 * kDegree);
    EXPECT_LE(f.longest, max_edge * (1 + 1e-9));
    EXPECT_NEAR(f.area, width * height, 1e-12 * width * height);
  }
}

TEST(TriangulateRectangle, keepsItsPromisesForEveryAspect) {
  for (int i = 1; i <= 24; ++i) {
    for (int j = 1; j <= 24; ++j) {
      const Figures f = figures(triangulateRectangle(0.0517 * i, 0.0431 * j, 0.31));
      EXPECT_GE(f.smallest_angle, 33.9 * kDegree) << i << ", " << j;
      EXPECT_LE(f.longest, 0.31 * (1 + 1e-9)) << i << ", " << j;
    }
  }
}

TEST(TriangulateRectangle, mostTrianglesAreNearlyEquilateral) {
  // A square grid with a diagonal has no angle above 45 as its smallest; that bends differently
  // in different directions.
  const Triangulation mesh = triangulateRectangle(0.15, 0.15, 0.004);
  int even = 0;
  for (const auto& [a, b, c] : mesh.triangles()) {
    const Triangulation one({mesh.points()[a], mesh.points()[b], mesh.points()[c]}, {{0, 1, 2}});
    even += figures(one).smallest_angle > 54 * kDegree;
  }
  EXPECT_GT(even, 0.9 * mesh.triangles().size());
}

TEST(TriangulateRectangle, doesNotWasteTriangles) {
  // Equilateral triangles of edge max_edge would be 520 and 3248.
  EXPECT_LT(triangulateRectangle(0.15, 0.15, 0.01).triangles().size(), 1.25 * 520);
  EXPECT_LT(triangulateRectangle(0.15, 0.15, 0.004).triangles().size(), 1.25 * 3248);
}

TEST(TriangulateRectangle, cornersComeFirstAndAreExact) {
  for (const auto& [width, height] : {std::pair(0.15, 0.1), std::pair(0.1, 0.3)}) {
    const Triangulation mesh = triangulateRectangle(width, height, 0.007);
    EXPECT_EQ(mesh.points()[0], Vector2(0, 0));
    EXPECT_EQ(mesh.points()[1], Vector2(width, 0));
    EXPECT_EQ(mesh.points()[2], Vector2(width, height));
    EXPECT_EQ(mesh.points()[3], Vector2(0, height));
    for (std::size_t v = 0; v < mesh.points().size(); ++v) {
      if (!mesh.onBorder(static_cast<int>(v))) continue;
      const Vector2& p = mesh.points()[v];
      EXPECT_TRUE(p.x() == 0 || p.x() == width || p.y() == 0 || p.y() == height) << p.transpose();
    }
  }
}

TEST(TriangulateRectangle, refusesByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  expectWithin(refusal([] { triangulateRectangle(-1, 1, 1); }), "width is -1");
  expectWithin(refusal([] { triangulateRectangle(1, 0, 1); }), "height is 0");
  expectWithin(refusal([=] { triangulateRectangle(nan, 1, 1); }), "width is nan");
  expectWithin(refusal([=] { triangulateRectangle(1, infinity, 1); }), "height is inf");
  expectWithin(refusal([] { triangulateRectangle(1, 1, 0); }), "max_edge is 0");
  expectWithin(refusal([=] { triangulateRectangle(1, 1, nan); }), "max_edge is nan");
  expectWithin(refusal([] { triangulateRectangle(1, 1, 1e-4); }), "million");
  expectWithin(refusal([] { triangulateRectangle(1, 1e-9, 1); }), "million");
  expectWithin(refusal([] { triangulateRectangle(1e300, 1e300, 1e-300); }), "million");
}

TEST(Triangulate, generalOutlinesAreEvenWithinMaxEdge) {
  std::vector<Vector2> circle;
  for (int i = 0; i < 100; ++i) {
    circle.emplace_back(0.1 * std::cos(i * M_PI / 50), 0.1 * std::sin(i * M_PI / 50));
  }
  PlanarGraph diagonal = square(0.15);
  diagonal.segments.push_back({0, 2});
  const std::pair<PlanarGraph, double> cases[] = {
      {square(0.15), 0.0225},
      {diagonal, 0.0225},
      {polygon({{0, 0}, {0.2, 0}, {0.2, 0.1}, {0.1, 0.1}, {0.1, 0.2}, {0, 0.2}}), 0.03},
      {polygon({{0, 0}, {0.2, 0}, {0.1, 0.17}}), 0.017},
      {polygon(circle), 50 * 0.01 * std::sin(M_PI / 50)}};
  for (const auto& [graph, area] : cases) {
    SCOPED_TRACE(testing::Message() << graph.points.size() << " points");
    const Triangulation mesh = triangulate(graph, 0.01);
    const Figures f = figures(mesh);
    EXPECT_GE(f.smallest_angle, 28 * kDegree);
    EXPECT_GE(f.mean_angle, 51 * kDegree);
    EXPECT_LE(f.longest, 0.01 * (1 + 1e-9));
    EXPECT_NEAR(f.area, area, 1e-12);
    for (std::size_t v = 0; v < graph.points.size(); ++v) {
      EXPECT_EQ(mesh.points()[v], graph.points[v]);
    }
  }
}

TEST(Triangulate, outlinesFinerThanMaxEdgeGetFineTrianglesAlong) {
  std::vector<Vector2> circle;
  for (int i = 0; i < 100; ++i) {
    circle.emplace_back(0.1 * std::cos(i * M_PI / 50), 0.1 * std::sin(i * M_PI / 50));
  }
  EXPECT_GE(figures(triangulate(polygon(circle), 0.05)).smallest_angle, 20 * kDegree);
}

TEST(Triangulate, sharpCornersAreLeftSharp) {
  // 15 degrees, which no triangulation can avoid; next to it all is well.
  const Figures f = figures(triangulate(polygon({{0, 0}, {0.2, 0}, {0.2, 0.0536}}), 0.01));
  EXPECT_NEAR(f.smallest_angle, std::atan2(0.0536, 0.2), 1e-9);
  EXPECT_LE(f.longest, 0.01 * (1 + 1e-9));
}

TEST(Triangulate, keepsAHoleOpenAndSegmentsInPlace) {
  PlanarGraph graph = square(1);
  graph.points.insert(graph.points.end(), {{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}});
  graph.segments.insert(graph.segments.end(), {{4, 5}, {5, 6}, {6, 7}, {7, 4}});
  graph.segments.push_back({0, 4});  // a crease to the hole
  EXPECT_NEAR(figures(triangulate(graph, 0.1)).area, 1, 1e-12);
  graph.holes = {{0.5, 0.5}};
  const GraphMesh mesh = meshGraph(graph, 0.1);
  EXPECT_NEAR(figures(mesh.triangulation).area, 0.96, 1e-12);
  EXPECT_FALSE(mesh.triangulation.locate({0.5, 0.5}, 1e-6));
}

TEST(MeshGraph, chainsFollowTheSegments) {
  PlanarGraph graph = square(1);
  graph.points.push_back({0.37, 0.61});
  for (int v = 0; v < 4; ++v) graph.segments.push_back({4, v});
  for (const double max_edge : {0.0, 0.3, 0.05}) {
    const GraphMesh mesh = meshGraph(graph, max_edge);
    ASSERT_EQ(mesh.chains.size(), graph.segments.size());
    for (std::size_t i = 0; i < mesh.chains.size(); ++i) {
      const auto& chain = mesh.chains[i];
      const auto [a, b] = graph.segments[i];
      EXPECT_EQ(chain.front(), a);
      EXPECT_EQ(chain.back(), b);
      double length = 0;
      for (std::size_t k = 1; k < chain.size(); ++k) {
        EXPECT_TRUE(mesh.triangulation.findSide(chain[k - 1], chain[k]));
        const auto& p = mesh.triangulation.points();
        EXPECT_LT(distanceToSegment(p[chain[k]], graph.points[a], graph.points[b]), 1e-12);
        length += (p[chain[k]] - p[chain[k - 1]]).norm();
      }
      EXPECT_NEAR(length, (graph.points[a] - graph.points[b]).norm(), 1e-12);
    }
    if (max_edge == 0) {
      EXPECT_EQ(mesh.triangulation.points().size(), 5u);
    }
  }
}

TEST(Triangulate, sameInputSameBits) {
  PlanarGraph graph = square(0.15);
  graph.points.push_back({0.05, 0.081});
  for (int v = 0; v < 4; ++v) graph.segments.push_back({4, v});
  const Triangulation once = triangulate(graph, 0.006), again = triangulate(graph, 0.006);
  EXPECT_EQ(once.points(), again.points());
  EXPECT_EQ(once.triangles(), again.triangles());
}

TEST(Triangulate, refusesWithThePlace) {
  PlanarGraph bow = polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  expectWithin(refusal([&] { triangulate(bow, 0.1); }), "segments 0 and 2 cross");
  PlanarGraph touching = square(1);
  touching.points.insert(touching.points.end(), {{0.5, 0}, {0.5, 0.5}});
  touching.segments.push_back({4, 5});
  expectWithin(refusal([&] { triangulate(touching, 0.1); }), "segments 0 and 4 cross");
  PlanarGraph off = square(1);
  off.points.push_back({2, 2});
  expectWithin(refusal([&] { triangulate(off, 0.1); }), "point 4 lies off the paper");
  PlanarGraph open = square(1);
  open.segments.pop_back();
  expectWithin(refusal([&] { triangulate(open, 0.1); }), "enclose no paper");
  PlanarGraph unknown = square(1);
  unknown.segments.push_back({0, 9});
  expectWithin(refusal([&] { triangulate(unknown, 0.1); }), "segment 4 names point 9");
  PlanarGraph twice = square(1);
  twice.points.push_back({1, 1});
  expectWithin(refusal([&] { triangulate(twice, 0.1); }), "points 2 and 4 coincide");
  PlanarGraph flat = polygon({{0, 0}, {1, 0}, {2, 0}});
  EXPECT_NE(refusal([&] { triangulate(flat, 0.1); }), "");
  PlanarGraph nowhere = square(1);
  nowhere.points[2].x() = std::numeric_limits<double>::quiet_NaN();
  expectWithin(refusal([&] { triangulate(nowhere, 0.1); }), "point 2 is not finite");
  expectWithin(refusal([] { triangulate(square(1), 0); }), "max_edge is 0");
  expectWithin(refusal([] { triangulate(square(1), -0.1); }), "max_edge is -0.1");
  expectWithin(refusal([] { triangulate(square(1), 1e-4); }), "million");
  EXPECT_NE(refusal([] { triangulate(PlanarGraph(), 0.1); }), "");
}

#if !defined(__SANITIZE_ADDRESS__)  // which reserves terabytes of the address space
TEST(Triangulate, rejectsAMeshThatTheMemoryIsTooSmallFor) {
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  rlimit limit = before;
  limit.rlim_cur = rlim_t{1200} << 20;
  setrlimit(RLIMIT_AS, &limit);
  std::string message;
  try {
    triangulateRectangle(0.15, 0.15, 3e-4);
  } catch (const std::invalid_argument& error) {
    message = error.what();
  }
  EXPECT_NO_THROW(triangulateRectangle(0.15, 0.15, 0.01));
  setrlimit(RLIMIT_AS, &before);
  EXPECT_EQ(message.find("max_edge 0.0003 is too small: about 500000 triangles need 4000 MB"), 0u)
      << message;
}
#endif

}  // namespace
}  // namespace shell_origami
