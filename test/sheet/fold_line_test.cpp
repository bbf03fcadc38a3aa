#include <shell_origami/sheet/fold_line.h>

#include <shell_origami/mesh/material_mesh.h>
#include <shell_origami/mesh/triangulate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace shell_origami {
namespace {

constexpr double kSide = 0.15;

Sheet square(double max_edge = 0.02) { return Sheet(triangulateRectangle(kSide, kSide, max_edge)); }

Segment line(double x0, double y0, double x1, double y1) {
  return {Vector2(x0, y0), Vector2(x1, y1)};
}

double length(const Sheet& sheet, const std::vector<int>& polyline) {
  double sum = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    sum += (sheet.flatPositions()[polyline[i]] - sheet.flatPositions()[polyline[i - 1]]).norm();
  }
  return sum;
}

double smallestAngle(const Sheet& sheet) {
  double smallest = M_PI;
  for (const Triangle& t : sheet.triangles()) {
    const auto& p = sheet.flatPositions();
    smallest = std::min(smallest, shell_origami::smallestAngle(p[t[0]], p[t[1]], p[t[2]]));
  }
  return smallest;
}

TEST(FoldLine, RunsStraightFromEndToEnd) {
  Sheet sheet = square();
  const FoldLine made = makeFoldLine(sheet, line(0, 0, kSide, kSide), "spine");
  sheet.validate();
  ASSERT_EQ(made.crease_ids.size(), 1u);
  ASSERT_EQ(sheet.creases().size(), 1u);
  EXPECT_EQ(sheet.creases()[0].name, "spine");
  EXPECT_EQ(sheet.creases()[0].vertices, made.vertices);
  EXPECT_EQ(sheet.revision(), 1u);
  EXPECT_NEAR(length(sheet, made.vertices), kSide * std::sqrt(2), 1e-14);
  EXPECT_NEAR(sheet.area(), kSide * kSide, 1e-14 * kSide);
}

TEST(FoldLine, EndsAnywhereInAFace) {
  Sheet sheet = square();
  const FoldLine made = makeFoldLine(sheet, line(0.0331, 0.0417, 0.1013, 0.0921));
  sheet.validate();
  EXPECT_NEAR((sheet.flatPositions()[made.vertices.front()] - Vector2(0.0331, 0.0417)).norm(), 0,
              1e-15);
  EXPECT_NEAR((sheet.flatPositions()[made.vertices.back()] - Vector2(0.1013, 0.0921)).norm(), 0,
              1e-15);
}

TEST(FoldLine, CrossingCreasesShareAVertexAndKeepTheirIdentity) {
  Sheet sheet = square();
  const auto first = makeFoldLine(sheet, line(0, 0.07, kSide, 0.08), "first").crease_ids;
  const auto second = makeFoldLine(sheet, line(0.07, 0, 0.08, kSide), "second").crease_ids;
  sheet.validate();
  ASSERT_EQ(sheet.creases().size(), 2u);
  const auto& a = sheet.creases()[sheet.creaseIndex(first[0])].vertices;
  const auto& b = sheet.creases()[sheet.creaseIndex(second[0])].vertices;
  int shared = 0;
  for (int v : a) shared += static_cast<int>(std::count(b.begin(), b.end(), v));
  EXPECT_EQ(shared, 1);
}

TEST(FoldLine, AlongAWholeCreaseIsThatCreaseAgain) {
  Sheet sheet = square();
  const FoldLine first = makeFoldLine(sheet, line(0, 0, kSide, kSide), "spine");
  const FoldLine again = makeFoldLine(sheet, line(kSide, kSide, 0, 0), "other");
  sheet.validate();
  EXPECT_EQ(again.crease_ids, first.crease_ids);
  EXPECT_EQ(sheet.creases().size(), 1u);
  EXPECT_EQ(sheet.creases()[0].name, "spine");
  EXPECT_EQ(again.vertices, std::vector<int>(first.vertices.rbegin(), first.vertices.rend()));
}

TEST(FoldLine, APartOfACreaseIsCutOffWithItsParentNamed) {
  Sheet sheet = square();
  const auto spine = makeFoldLine(sheet, line(0, 0, kSide, kSide), "spine").crease_ids[0];
  const FoldLine middle = makeFoldLine(sheet, line(0.05, 0.05, 0.1, 0.1), "belly");
  sheet.validate();
  // Three pieces: the spine keeps the first, the last is born of it, and so is the middle.
  ASSERT_EQ(sheet.creases().size(), 3u);
  ASSERT_EQ(middle.crease_ids.size(), 1u);
  EXPECT_NE(middle.crease_ids[0], spine);
  EXPECT_EQ(sheet.creases()[sheet.creaseIndex(middle.crease_ids[0])].name, "belly");
  ASSERT_EQ(middle.remap.born.size(), 2u);
  for (const Remap::Born& born : middle.remap.born) EXPECT_EQ(born.parent, spine);
  double total = 0;
  for (const Crease& crease : sheet.creases()) total += length(sheet, crease.vertices);
  EXPECT_NEAR(total, kSide * std::sqrt(2), 1e-14);
}

TEST(FoldLine, BeyondACreaseMakesANewOneOfTheRest) {
  Sheet sheet = square();
  const auto half = makeFoldLine(sheet, line(0, 0, 0.075, 0.075)).crease_ids[0];
  const FoldLine whole = makeFoldLine(sheet, line(0, 0, kSide, kSide));
  sheet.validate();
  ASSERT_EQ(whole.crease_ids.size(), 2u);
  EXPECT_EQ(whole.crease_ids[0], half);
  EXPECT_TRUE(whole.remap.born.empty());
}

TEST(FoldLine, VerticesKeepTheirIdsAndAnEarlierCreaseItsLine) {
  Sheet sheet = square();
  const Sheet before = sheet;
  const FoldLine made = makeFoldLine(sheet, line(0.01, 0, 0.13, kSide));
  int stayed = 0;
  for (int v = 0; v < before.vertexCount(); ++v) {
    const bool changed =
        std::binary_search(made.remap.changed.begin(), made.remap.changed.end(), v);
    if (!changed) {
      EXPECT_EQ(sheet.flatPositions()[v], before.flatPositions()[v]);
      ++stayed;
    }
  }
  EXPECT_GT(stayed, before.vertexCount() / 2);
}

TEST(FoldLine, RemapPutsNewVerticesWhereTheirFlatPointWas) {
  Sheet sheet = square();
  const auto fold_of = [](const Vector2& p) {  // a paper folded by 90 degrees along x = 0.07
    return p.x() < 0.07 ? Vector3(p.x(), p.y(), 0) : Vector3(0.07, p.y(), p.x() - 0.07);
  };
  makeFoldLine(sheet, line(0.07, 0, 0.07, kSide));
  Positions space(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) space.col(v) = fold_of(sheet.flatPositions()[v]);
  const FoldLine made =
      makeFoldLine(sheet, line(0, 0.03, kSide, 0.11), "", EditContext{&space, {}});
  sheet.validate();
  const Positions after = made.remap.apply(space, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    EXPECT_LT((after.col(v) - fold_of(sheet.flatPositions()[v])).norm(), 1e-15);
  }
}

TEST(FoldLine, RemapTellsTheEdgeAndTheTriangleThatEachWasAPartOf) {
  Sheet sheet = square();
  makeFoldLine(sheet, line(0.02, 0, 0.11, kSide));
  const Sheet before = sheet;
  const Remap remap = makeFoldLine(sheet, line(0, 0.03, kSide, 0.11)).remap;
  const auto& old_points = before.flatPositions();
  ASSERT_EQ(remap.edges.size(), sheet.edges().size());
  int parts = 0, across = 0;
  for (std::size_t j = 0; j < sheet.edges().size(); ++j) {
    const Edge& edge = sheet.edges()[j];
    const Vector2 middle =
        (sheet.flatPositions()[edge.vertices[0]] + sheet.flatPositions()[edge.vertices[1]]) / 2;
    const auto distance = [&](const Edge& old) {
      return distanceToSegment(middle, old_points[old.vertices[0]], old_points[old.vertices[1]]);
    };
    if (remap.edges[j] == Remap::kNone) {
      ++across;
      EXPECT_FALSE(edge.onBorder());
      continue;
    }
    const Edge& old = before.edges()[remap.edges[j]];
    EXPECT_LT(distance(old), 1e-9);
    EXPECT_EQ(edge.onBorder(), old.onBorder());
    EXPECT_TRUE(old.crease < 0 || edge.crease == old.crease);
    parts += edge.vertices != old.vertices;
  }
  EXPECT_GT(parts, 2);
  EXPECT_GT(across, 5);
  ASSERT_EQ(remap.triangles.size(), sheet.triangles().size());
  for (std::size_t t = 0; t < sheet.triangles().size(); ++t) {
    const Triangle& c = sheet.triangles()[t];
    const Vector2 centroid =
        (sheet.flatPositions()[c[0]] + sheet.flatPositions()[c[1]] + sheet.flatPositions()[c[2]]) /
        3;
    const Triangle& old = before.triangles()[remap.triangles[t]];
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(doubleArea(old_points[old[k]], old_points[old[(k + 1) % 3]], centroid), -1e-15);
    }
  }
}

TEST(FoldLine, HeldVerticesAreNeverShifted) {
  Sheet sheet = square();
  EditContext context;
  for (int v = 0; v < sheet.vertexCount(); ++v) context.held.insert(v);
  const auto before = sheet.flatPositions();
  makeFoldLine(sheet, line(0.003, 0, 0.141, kSide), "", context);
  sheet.validate();
  for (std::size_t v = 0; v < before.size(); ++v) EXPECT_EQ(sheet.flatPositions()[v], before[v]);
}

TEST(FoldLine, WherePaperMustKeepItsShapeEdgesAreSplitOnly) {
  // Rolled onto a cylinder, by 0.1 rad or less at an edge, and folded along lines that pass
  // vertices at all distances.
  constexpr double kRadius = 0.1;
  Sheet sheet = square(0.01);
  Positions space(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const Vector2& p = sheet.flatPositions()[v];
    const double angle = p.x() / kRadius;
    space.col(v) = kRadius * Vector3(std::sin(angle), p.y() / kRadius, 1 - std::cos(angle));
  }
  const std::vector<Vector2> flat = sheet.flatPositions();
  const Positions rolled = space;
  const auto triangles = static_cast<double>(sheet.triangles().size());
  constexpr int kFolds = 12;
  for (int i = 0; i < kFolds; ++i) {
    EditContext context{&space, {}};
    context.exact = true;
    const Segment fold = line(0, 0.011 + 0.0107 * i, kSide, 0.013 + 0.0103 * i);
    space = makeFoldLine(sheet, fold, "", context).remap.apply(space, sheet.vertexCount());
  }
  sheet.validate();
  for (std::size_t v = 0; v < flat.size(); ++v) EXPECT_EQ(sheet.flatPositions()[v], flat[v]);
  EXPECT_LT((space.leftCols(rolled.cols()) - rolled).cwiseAbs().maxCoeff(), 1e-15);
  // A line makes two triangles of each that it crosses, at most 33 of 627 here. Slivers that were
  // split in turn made 74 times as many triangles.
  EXPECT_LT(static_cast<double>(sheet.triangles().size()), triangles + kFolds * 2 * 33);
}

TEST(FoldLine, ALongFoldLeavesNoSliver) {
  // The corners of the paper force nothing here: the line meets the border at 60 degrees or more.
  Sheet sheet = square(0.01);
  makeFoldLine(sheet, line(0.0531, 0, 0.0742, kSide));
  EXPECT_GT(smallestAngle(sheet), 15 * M_PI / 180);
}

TEST(FoldLine, RefusesWhatMakesNoSenseAndLeavesTheSheet) {
  Sheet sheet = square();
  makeFoldLine(sheet, line(0, 0, kSide, kSide));
  const Sheet before = sheet;
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const Segment& bad : {line(0.05, 0.05, 0.05, 0.05), line(-0.01, 0, 0.1, 0.1),
                             line(0, 0, 0.2, 0.2), line(nan, 0, 0.1, 0.1),
                             line(0, 0, infinity, 0.1), line(0, 0, kSide, 0), line(1, 1, 2, 2)}) {
    EXPECT_THROW(makeFoldLine(sheet, bad), std::invalid_argument);
  }
  EXPECT_EQ(sheet.revision(), before.revision());
  EXPECT_EQ(sheet.triangles(), before.triangles());
  EXPECT_EQ(sheet.flatPositions(), before.flatPositions());
}

TEST(AddVertex, SplitsTheEdgeWhereAsked) {
  Sheet sheet = square();
  const auto [a, b] = sheet.edges()[7].vertices;
  const Vector2 from = sheet.flatPositions()[a], to = sheet.flatPositions()[b];
  const AddedVertex added = addVertex(sheet, a, b, 0.25);
  sheet.validate();
  EXPECT_LT((sheet.flatPositions()[added.vertex] - (0.75 * from + 0.25 * to)).norm(), 1e-16);
  EXPECT_EQ(sheet.revision(), 1u);
  // Both halves were edge 7; the edges to the far corners were none.
  int halves = 0, none = 0;
  for (std::size_t j = 0; j < sheet.edges().size(); ++j) {
    const auto& ends = sheet.edges()[j].vertices;
    if (ends[0] != added.vertex && ends[1] != added.vertex) continue;
    (added.remap.edges[j] == 7 ? halves : none) += 1;
    EXPECT_TRUE(added.remap.edges[j] == 7 || added.remap.edges[j] == Remap::kNone);
  }
  EXPECT_EQ(halves, 2);
  EXPECT_EQ(none, 2);
  EXPECT_THROW(addVertex(sheet, a, b, 0.5), std::invalid_argument);
  EXPECT_THROW(addVertex(sheet, a, added.vertex, 0), std::invalid_argument);
  EXPECT_THROW(addVertex(sheet, a, added.vertex, std::nan("")), std::invalid_argument);
  EXPECT_THROW(addVertex(sheet, a, 100000, 0.5), std::invalid_argument);
  EXPECT_THROW(addVertex(sheet, a, a, 0.5), std::invalid_argument);
}

TEST(AddVertex, OnACreaseBecomesItsVertex) {
  Sheet sheet = square();
  const FoldLine made = makeFoldLine(sheet, line(0, 0, kSide, kSide));
  const AddedVertex added = addVertex(sheet, made.vertices[1], made.vertices[2], 0.3);
  sheet.validate();
  const auto& crease = sheet.creases()[0].vertices;
  EXPECT_EQ(crease.size(), made.vertices.size() + 1);
  EXPECT_EQ(crease[2], added.vertex);
}

}  // namespace
}  // namespace shell_origami
