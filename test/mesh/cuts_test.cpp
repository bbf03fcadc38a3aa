/// Slits, out of FOLD files and into them.
#include <shell_origami/sheet/fold_line.h>
#include "test/mesh/lattice.h"
#include "test/sheet/random_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

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
      {"two on one line", Lattice().line({0, 1}, {1, 1}, 'C').line({3, 1}, {4, 1}, 'C'), 2, 4, 0,
       0},
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
      expectWithin(refused(Lattice()
                               .line({1, 1}, {3, 1}, 'C')
                               .line({3, 1}, {3, 3}, 'C')
                               .line({1, 3}, {3, 3}, 'C')
                               .line({1, 1}, {1, 3}, 'C')),
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
  const json document = crossOfSlits().line({0, 3}, {4, 3}, 'M').document(Faces::kTriangles);
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

/// A pop-up card, opened to a right angle: a strip between two slits is folded the other way. Its
/// cells are quadrilaterals or triangles, and the middles of the slits are there twice.
json popUpCard(Faces faces) {
  json document = Lattice()
                      .line({0, 2}, {1, 2}, 'V')
                      .line({3, 2}, {4, 2}, 'V')
                      .line({1, 1}, {3, 1}, 'V')
                      .line({1, 2}, {3, 2}, 'M')
                      .line({1, 3}, {3, 3}, 'V')
                      .line({1, 1}, {1, 3}, 'B')
                      .line({3, 1}, {3, 3}, 'B')
                      .document(faces);
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
                      points[edge[1].get<int>()][0].get<double>()) /
                     2;
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
