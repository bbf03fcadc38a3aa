/// Slits: out of FOLD files and into them, and folds made across them.
#include "fold_samples.h"
#include "random_sheets.h"
#include "sheet/fold_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

constexpr int kCells = 4;

int at(int x, int y) { return x + (kCells + 1) * y; }

enum class Faces { kNone, kQuads, kTriangles };

/// A square of 4 x 4 unit cells: lines of its lattice are cut, folded or flat.
class Lattice {
 public:
  /// Assigns the edges from one lattice point straight on to another.
  Lattice& line(std::array<int, 2> from, std::array<int, 2> to, char kind) {
    const int dx = (to[0] > from[0]) - (to[0] < from[0]);
    const int dy = (to[1] > from[1]) - (to[1] < from[1]);
    for (; from != to; from = {from[0] + dx, from[1] + dy}) {
      const int a = at(from[0], from[1]), b = at(from[0] + dx, from[1] + dy);
      kinds_[std::minmax(a, b)] = kind;
    }
    return *this;
  }

  json document(Faces faces) const {
    json result{{"vertices_coords", json::array()}, {"edges_vertices", json::array()},
                {"edges_assignment", json::array()}};
    for (int y = 0; y <= kCells; ++y) {
      for (int x = 0; x <= kCells; ++x) result["vertices_coords"].push_back({x, y});
    }
    Lattice whole = *this;
    whole.line({0, 0}, {kCells, 0}, 'B').line({kCells, 0}, {kCells, kCells}, 'B');
    whole.line({0, kCells}, {kCells, kCells}, 'B').line({0, 0}, {0, kCells}, 'B');
    for (const auto& [ends, kind] : whole.kinds_) {
      result["edges_vertices"].push_back({ends.first, ends.second});
      result["edges_assignment"].push_back(std::string(1, kind));
    }
    for (int y = 0; y < kCells && faces != Faces::kNone; ++y) {
      for (int x = 0; x < kCells; ++x) {
        const int a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
        if (faces == Faces::kQuads) result["faces_vertices"].push_back({a, b, c, d});
        if (faces == Faces::kQuads) continue;
        result["faces_vertices"].push_back({a, b, c});
        result["faces_vertices"].push_back({a, c, d});
      }
    }
    return result;
  }

 private:
  std::map<std::pair<int, int>, char> kinds_;
};

Lattice insideSlit() { return Lattice().line({1, 2}, {3, 2}, 'C'); }
Lattice borderSlit() { return Lattice().line({0, 2}, {2, 2}, 'C'); }
Lattice crossOfSlits() { return insideSlit().line({2, 1}, {2, 3}, 'C'); }

double length(const Sheet& sheet, const Edge& edge) {
  const auto [a, b] = edge.vertices;
  return (sheet.flatPositions()[a] - sheet.flatPositions()[b]).norm();
}

double creaseLength(const Sheet& sheet) {
  double sum = 0;
  for (const Edge& edge : sheet.edges()) sum += edge.crease < 0 ? 0 : length(sheet, edge);
  return sum;
}

/// Vertices that stand where another one does.
int doubled(const Sheet& sheet) {
  const auto& points = sheet.flatPositions();
  return static_cast<int>(std::count_if(points.begin(), points.end(), [&](const Vector2& p) {
    return std::count(points.begin(), points.end(), p) > 1;
  }));
}

TEST(Slits, openInEveryFileAtEveryFineness) {
  const struct {
    const char* name;
    Lattice lattice;
    double cut;
    int doubled;  // vertices, of those of the file
    std::size_t creases;
    double folded;
  } cases[] = {
      {"inside", insideSlit(), 2, 2, 0, 0},
      {"of one edge", Lattice().line({1, 2}, {2, 2}, 'C'), 1, 2, 0, 0},
      {"from the border", borderSlit(), 2, 4, 0, 0},
      {"a cross", crossOfSlits(), 4, 4, 0, 0},
      {"a cross that touches the border", borderSlit().line({2, 1}, {2, 3}, 'C'), 4, 7, 0, 0},
      {"with a bend", insideSlit().line({3, 2}, {3, 3}, 'C'), 3, 4, 0, 0},
      {"two on one line",
       Lattice().line({0, 1}, {1, 1}, 'C').line({3, 1}, {4, 1}, 'C'), 2, 4, 0, 0},
      {"that ends on a crease", borderSlit().line({2, 0}, {2, 4}, 'V'), 2, 4, 1, 4},
      {"that a crease crosses", insideSlit().line({2, 0}, {2, 4}, 'M'), 2, 2, 2, 4},
      {"that a crease lengthens", insideSlit().line({0, 2}, {1, 2}, 'V').line({3, 2}, {4, 2}, 'V'),
       2, 2, 2, 2},
      {"between creases from its ends",
       insideSlit().line({1, 0}, {1, 4}, 'V').line({3, 0}, {3, 4}, 'V'), 2, 2, 2, 8}};
  for (const auto& slit : cases) {
    for (const Faces faces : {Faces::kNone, Faces::kQuads, Faces::kTriangles}) {
      for (const double max_edge : {0.0, 0.7, 0.3}) {
        SCOPED_TRACE(testing::Message() << slit.name << ", faces " << static_cast<int>(faces)
                                        << ", max_edge " << max_edge);
        const Sheet sheet = read(slit.lattice.document(faces), 1, max_edge).sheet;
        EXPECT_NO_THROW(sheet.validate());
        EXPECT_NEAR(sheet.area(), 16, 1e-12);
        EXPECT_NEAR(borderLength(sheet), 16 + 2 * slit.cut, 1e-12);
        EXPECT_EQ(sheet.creases().size(), slit.creases);
        EXPECT_NEAR(creaseLength(sheet), slit.folded, 1e-12);
        if (max_edge == 0) {
          EXPECT_EQ(doubled(sheet), slit.doubled);
        }
      }
    }
  }
}

TEST(Slits, theFilesVerticesKeepTheirNumbers) {
  const json document = crossOfSlits().document(Faces::kTriangles);
  const Sheet sheet = read(document).sheet;
  ASSERT_EQ(sheet.vertexCount(), 25 + 3);
  for (int v = 0; v < 25; ++v) {
    EXPECT_EQ(sheet.flatPositions()[v], Vector2(v % 5, v / 5));
  }
  for (int v = 25; v < 28; ++v) EXPECT_EQ(sheet.flatPositions()[v], Vector2(2, 2));
  EXPECT_EQ(sheet.nearestVertex({2, 2}), at(2, 2));
}

TEST(Slits, cutsThatPartThePaperAreRefused) {
  for (const Faces faces : {Faces::kNone, Faces::kQuads, Faces::kTriangles}) {
    for (const double max_edge : {0.0, 0.5}) {
      const auto refused = [&](const Lattice& lattice) {
        return fileRefusal(scratch(lattice.document(faces).dump()), {1, max_edge});
      };
      expectWithin(refused(Lattice().line({0, 2}, {4, 2}, 'C')), "part the paper into 2 pieces");
      expectWithin(refused(Lattice().line({0, 2}, {4, 2}, 'C').line({2, 0}, {2, 4}, 'C')),
                   "part the paper into 4 pieces");
      expectWithin(refused(Lattice().line({1, 1}, {3, 1}, 'C').line({3, 1}, {3, 3}, 'C')
                               .line({1, 3}, {3, 3}, 'C').line({1, 1}, {1, 3}, 'C')),
                   "part the paper into 2 pieces");
    }
  }
}

TEST(Slits, openAsBorderEdgesWithoutFaces) {
  // Both sides of the slit from (1, 2) to (3, 2), each with a middle of its own.
  json document = Lattice().document(Faces::kNone);
  for (const double x : {1.0, 3.0, 2.0, 2.5}) document["vertices_coords"].push_back({x, 2});
  for (const auto& [a, b] : {std::pair<int, int>{25, 27}, {27, 26}, {25, 28}, {28, 26}}) {
    document["edges_vertices"].push_back({a, b});
    document["edges_assignment"].push_back("B");
  }
  for (const double max_edge : {0.0, 0.5}) {
    const Sheet sheet = read(document, 1, max_edge).sheet;
    EXPECT_NEAR(sheet.area(), 16, 1e-12);
    EXPECT_NEAR(borderLength(sheet), 20, 1e-12);
  }
}

TEST(Slits, aNotedCreaseAcrossACutIsRefused) {
  json document = insideSlit().line({2, 0}, {2, 4}, 'M').document(Faces::kTriangles);
  document["shell_origami:creases"] = json::array(
      {{{"id", 0}, {"name", "spine"}, {"vertices", {2, 7, 12, 17, 22}}, {"rest_angle_deg", 0}}});
  expectWithin(refusal(document), "crease spine runs across a cut at vertex 12");
}

Positions flat(const Sheet& sheet) {
  Positions positions = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    positions.col(v).head<2>() = sheet.flatPositions()[v];
  }
  return positions;
}

json written(const Sheet& sheet) {
  return writeFold(sheet, std::vector<FoldCrease>(sheet.creases().size(), {0.5, 0.5}), flat(sheet),
                   "slits");
}

void expectSame(const Sheet& a, const Sheet& b) {
  EXPECT_EQ(a.flatPositions(), b.flatPositions());
  EXPECT_EQ(a.triangles(), b.triangles());
  ASSERT_EQ(a.creases().size(), b.creases().size());
  for (std::size_t i = 0; i < a.creases().size(); ++i) {
    EXPECT_EQ(a.creases()[i].id, b.creases()[i].id);
    EXPECT_EQ(a.creases()[i].name, b.creases()[i].name);
    EXPECT_EQ(a.creases()[i].vertices, b.creases()[i].vertices);
  }
}

TEST(Slits, areWrittenAndReadBackToTheSameSheet) {
  const json document =
      crossOfSlits().line({0, 3}, {4, 3}, 'M').document(Faces::kTriangles);
  for (const double max_edge : {0.0, 0.4}) {
    const Sheet sheet = read(document, 1, max_edge).sheet;
    expectSame(read(written(sheet), 0).sheet, sheet);
  }
}

TEST(Slits, afterFoldsAreWrittenAndReadBackToTheSameSheet) {
  // Folds put vertices on the sides of a slit at different places.
  RandomSheets random(3);
  for (int i = 0; i < 30; ++i) {
    Sheet sheet(slits(random.between(0.015, 0.03)));
    const double area = sheet.area(), border = borderLength(sheet);
    for (int fold = 0; fold < 6; ++fold) {
      try {
        makeFoldLine(sheet, random.line(sheet));
      } catch (const std::invalid_argument&) {
        // A line along the border.
      }
    }
    expectSame(read(written(sheet), 0).sheet, sheet);
    const Sheet finer = read(written(sheet), 0, 0.012).sheet;
    EXPECT_NEAR(finer.area() / area, 1, 1e-9);
    EXPECT_NEAR(borderLength(finer) / border, 1, 1e-9);
    EXPECT_NEAR(creaseLength(finer), creaseLength(sheet), 1e-9);
  }
}

/// The square with one slit from (1, 2) to (3, 2), in triangles of 0.3.
Sheet slitSquare() { return read(insideSlit().document(Faces::kNone), 1, 0.3).sheet; }

FoldLine fold(Sheet& sheet, double x0, double y0, double x1, double y1) {
  const double border = borderLength(sheet);
  const FoldLine made = makeFoldLine(sheet, {Vector2(x0, y0), Vector2(x1, y1)}, "line");
  sheet.validate();
  EXPECT_NEAR(sheet.area(), 16, 1e-12);
  EXPECT_NEAR(borderLength(sheet), border, 1e-12);
  EXPECT_EQ(unforcedSlivers(sheet, 0.3), 0);
  return made;
}

TEST(Slits, acrossASlitBothPartsFoldUnderOneName) {
  Sheet sheet = slitSquare();
  const FoldLine made = fold(sheet, 1.7, 0, 2.3, 4);
  EXPECT_EQ(made.parts, 2);
  ASSERT_EQ(sheet.creases().size(), 2u);
  EXPECT_EQ(made.crease_ids.size(), 2u);
  for (const Crease& crease : sheet.creases()) EXPECT_EQ(crease.name, "line");
  EXPECT_NEAR(creaseLength(sheet), std::hypot(0.6, 4), 1e-12);
  const Vector2 &below = sheet.flatPositions()[sheet.creases()[0].vertices.back()],
                &above = sheet.flatPositions()[sheet.creases()[1].vertices.front()];
  EXPECT_LT((below - above).norm(), 1e-12);
  EXPECT_LT((below - Vector2(2, 2)).norm(), 1e-12);
}

TEST(Slits, aLineMayEndOnASlit) {
  for (const double from : {0.0, 4.0}) {
    Sheet sheet = slitSquare();
    const FoldLine made = fold(sheet, 1.6, from, 2.21, 2);
    EXPECT_EQ(made.parts, 1);
    EXPECT_NEAR(creaseLength(sheet), std::hypot(0.61, 2), 1e-12);
    Sheet back = slitSquare();
    EXPECT_EQ(fold(back, 2.21, 2, 1.6, from).parts, 1);
    EXPECT_NEAR(creaseLength(back), std::hypot(0.61, 2), 1e-12);
  }
}

TEST(Slits, whatRunsAlongASlitDoesNotFold) {
  Sheet sheet = slitSquare();
  const FoldLine whole = fold(sheet, 0, 2, 4, 2);
  EXPECT_EQ(whole.parts, 2);
  EXPECT_NEAR(creaseLength(sheet), 2, 1e-12);
  // From, to or beyond the middle of the slit.
  for (const auto& [x0, x1, length] : {std::array<double, 3>{0, 2.05, 1}, {2.05, 0, 1},
                                       {2.05, 4, 1}, {4, 1.95, 1}, {1, 4, 1}, {0, 3, 1}}) {
    Sheet part = slitSquare();
    EXPECT_EQ(fold(part, x0, 2, x1, 2).parts, 1);
    EXPECT_NEAR(creaseLength(part), length, 1e-12);
  }
  // Whichever side of the slit the line's end comes to lie on.
  RandomSheets random(7);
  for (int i = 0; i < 20; ++i) {
    const double x = random.between(1.1, 2.9);
    for (const double from : {0.0, 4.0}) {
      Sheet level = slitSquare(), upright =
          read(Lattice().line({2, 1}, {2, 3}, 'C').document(Faces::kNone), 1, 0.3).sheet;
      fold(level, from, 2, x, 2);
      fold(upright, 2, from, 2, x);
      EXPECT_NEAR(creaseLength(level), 1, 1e-12);
      EXPECT_NEAR(creaseLength(upright), 1, 1e-12);
    }
  }
  Sheet same = slitSquare();
  const Sheet before = same;
  EXPECT_THROW(makeFoldLine(same, {Vector2(1.2, 2), Vector2(2.7, 2)}), std::invalid_argument);
  EXPECT_EQ(same.triangles(), before.triangles());
}

TEST(Slits, aLineThroughTheEndOfASlitIsWhole) {
  for (const double x : {0.0, 1.0, 2.0}) {
    Sheet sheet = slitSquare();
    EXPECT_EQ(fold(sheet, x, 0, 2 - x, 4).parts, 1);
    EXPECT_EQ(sheet.creases().size(), 1u);
  }
}

TEST(Slits, aLineThroughACrossOfSlitsGoesOnBeyondIt) {
  Sheet sheet = read(crossOfSlits().document(Faces::kNone), 1, 0.3).sheet;
  EXPECT_EQ(fold(sheet, 0, 0, 4, 4).parts, 2);
  EXPECT_NEAR(creaseLength(sheet), 4 * std::sqrt(2), 1e-12);
  EXPECT_EQ(fold(sheet, 0, 2, 4, 2).parts, 2);
  EXPECT_EQ(fold(sheet, 2, 4, 2, 0).parts, 2);
  EXPECT_NEAR(creaseLength(sheet), 4 * std::sqrt(2) + 4, 1e-12);
}

TEST(Slits, newVerticesStandOnTheirSideOfAnOpenSlit) {
  // The lip below the slit is bent down, the one above it up.
  const auto place = [](const Vector2& p, double side) {
    const double gape = std::max(0.0, 1 - std::abs(p.x() - 2));
    return Vector3(p.x(), p.y(), side * 0.1 * gape * std::max(0.0, 1 - std::abs(p.y() - 2)));
  };
  const auto sideOf = [](const Sheet& sheet, int v) {
    const int t = sheet.triangulation().around(v)[0];
    return sheet.triangulation().centroid(t).y() > 2 ? 1.0 : -1.0;
  };
  RandomSheets random(5);
  for (int i = 0; i < 50; ++i) {
    Sheet sheet = slitSquare();
    Positions space(3, sheet.vertexCount());
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      space.col(v) = place(sheet.flatPositions()[v], sideOf(sheet, v));
    }
    const Line line{Vector2(random.between(1.2, 2.8), 0), Vector2(random.between(1.2, 2.8), 4)};
    const Remap remap = makeFoldLine(sheet, line, "", {&space, {}}).remap;
    const Positions after = remap.apply(space, sheet.vertexCount());
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      const Vector3 expected = place(sheet.flatPositions()[v], sideOf(sheet, v));
      EXPECT_LT((after.col(v) - expected).norm(), 0.01) << sheet.flatPositions()[v].transpose();
    }
  }
}

/// A pop-up card, opened to a right angle: a strip between two slits is folded the other way. Its
/// cells are quadrilaterals or triangles, and the middles of the slits are there twice.
json popUpCard(Faces faces) {
  json document = Lattice().line({0, 2}, {1, 2}, 'V').line({3, 2}, {4, 2}, 'V')
                      .line({1, 1}, {3, 1}, 'V').line({1, 2}, {3, 2}, 'M').line({1, 3}, {3, 3}, 'V')
                      .line({1, 1}, {1, 3}, 'B').line({3, 1}, {3, 3}, 'B').document(faces);
  json& points = document["vertices_coords"];
  const std::map<int, int> strip{{at(1, 2), 25}, {at(3, 2), 26}};
  for (const auto& [v, twin] : strip) points.push_back(points[v]);
  const auto moveToStrip = [&](json& list) {
    for (json& v : list) {
      if (strip.count(v.get<int>())) v = strip.at(v.get<int>());
    }
  };
  for (json& face : document["faces_vertices"]) {
    const double x = std::accumulate(face.begin(), face.end(), 0.0, [&](double sum, const json& v) {
      return sum + points[v.get<int>()][0].get<double>() / face.size();
    });
    if (x > 1 && x < 3) moveToStrip(face);
  }
  // The slits' edges are there twice too.
  json edges = json::array(), kinds = json::array();
  for (std::size_t i = 0; i < document["edges_vertices"].size(); ++i) {
    json edge = document["edges_vertices"][i];
    const json kind = document["edges_assignment"][i];
    const double x = (points[edge[0].get<int>()][0].get<double>() +
                      points[edge[1].get<int>()][0].get<double>()) / 2;
    const bool on_slit = kind == "B" && (x == 1 || x == 3) && edge[0] > 4 && edge[1] < 20;
    if (x <= 1 || x >= 3) {
      edges.push_back(edge);
      kinds.push_back(kind);
    }
    if (on_slit || (x > 1 && x < 3)) {
      moveToStrip(edge);
      edges.push_back(edge);
      kinds.push_back(kind);
    }
  }
  document["edges_vertices"] = edges;
  document["edges_assignment"] = kinds;
  document["frame_classes"] = json::array({"creasePattern"});
  json folded = json::array();
  for (const json& p : points) {
    const double x = p[0], y = p[1];
    folded.push_back({x, std::min(y, 2.0), std::max(y - 2, 0.0)});
  }
  for (const auto& [v, twin] : strip) folded[twin] = {points[v][0], 1, 1};
  folded[at(2, 2)] = {2, 1, 1};
  document["file_frames"] = json::array({{{"frame_inherit", true},
                                          {"frame_classes", json::array({"foldedForm"})},
                                          {"vertices_coords", folded}}});
  return document;
}

TEST(Slits, aPopUpCardLoadsFoldedAtEveryFineness) {
  for (const Faces faces : {Faces::kQuads, Faces::kTriangles}) {
    for (const double max_edge : {0.0, 0.4, 0.13}) {
      SCOPED_TRACE(max_edge);
      const FoldPaper paper = read(popUpCard(faces), 1, max_edge);
      EXPECT_NEAR(paper.sheet.area(), 16, 1e-12);
      EXPECT_NEAR(borderLength(paper.sheet), 16 + 8, 1e-12);
      ASSERT_TRUE(paper.positions);
      ASSERT_EQ(paper.rest_angles.size(), 5u);
      for (std::size_t i = 0; i < 5; ++i) {
        const bool valley = paper.sheet.creases()[i].pattern_angle > 0;
        EXPECT_NEAR(paper.rest_angles[i], valley ? M_PI / 2 : -M_PI / 2, 1e-6);
      }
      for (const Edge& edge : paper.sheet.edges()) {
        const auto [a, b] = edge.vertices;
        const double space = (paper.positions->col(a) - paper.positions->col(b)).norm();
        EXPECT_NEAR(space / length(paper.sheet, edge), 1, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace shell_origami
