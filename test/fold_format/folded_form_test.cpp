/// Folded forms of FOLD files, over their own vertices and over a finer mesh.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>
#include "test/fold_format/fold_samples.h"
#include "test/sheet/random_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

constexpr double kSide = 0.15;

/// Largest relative change of an edge's length in space.
double largestStrain(const FoldPaper& paper) {
  const auto& flat = paper.sheet.flatPositions();
  double largest = 0;
  for (const Edge& edge : paper.sheet.edges()) {
    const auto [a, b] = edge.vertices;
    const double length = (paper.positions->col(a) - paper.positions->col(b)).norm();
    largest = std::max(largest, std::abs(length / (flat[a] - flat[b]).norm() - 1));
  }
  return largest;
}

/// The point of a paper folded along the line through p and q: what lies left of it is turned.
Vector3 folded(const Vector2& point, const Vector2& p, const Vector2& q, double angle) {
  const Vector2 along = (q - p).normalized(), left(-along.y(), along.x());
  const double s = along.dot(point - p), t = left.dot(point - p);
  const Vector2 on_line = p + s * along;
  const Vector2 turned = on_line + (t > 0 ? std::cos(angle) : 1) * t * left;
  return {turned.x(), turned.y(), t > 0 ? std::sin(angle) * t : 0};
}

TEST(FoldedForm, ofOurOwnFileStandsAtEveryFineness) {
  const Vector2 p(0.031, 0), q(0.092, kSide);
  for (const double angle : {1.2, -2.9}) {
    Sheet sheet(triangulateRectangle(kSide, kSide, 0.03));
    makeFoldLine(sheet, {p, q});
    Positions positions(3, sheet.vertexCount());
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      positions.col(v) = folded(sheet.flatPositions()[v], p, q, angle);
    }
    json document = writeFold(sheet, {{angle, angle}}, positions, "folded");
    document.erase("shell_origami:creases");  // so that the crease's angle is measured
    for (const double max_edge : {0.0, 0.05, 0.01, 0.004}) {
      const FoldPaper paper = read(document, 0, max_edge);
      ASSERT_TRUE(paper.positions);
      ASSERT_EQ(paper.rest_angles.size(), 1u);
      EXPECT_NEAR(paper.rest_angles[0], angle, 1e-6);
      EXPECT_LT(largestStrain(paper), 1e-9);
      for (int v = 0; v < paper.sheet.vertexCount(); ++v) {
        const Vector3 expected = folded(paper.sheet.flatPositions()[v], p, q, angle);
        EXPECT_LT((paper.positions->col(v) - expected).norm(), 1e-12);
      }
    }
  }
}

/// Four pleats, two quadrilaterals long, folded to 60 degrees in turn, in centimetres.
json pleats() {
  json document{{"frame_unit", "cm"},
                {"frame_classes", json::array({"creasePattern"})},
                {"vertices_coords", json::array()},
                {"edges_vertices", json::array()},
                {"edges_assignment", json::array()},
                {"faces_vertices", json::array()}};
  json space = json::array();
  const auto at = [](int x, int y) { return 3 * x + y; };
  for (int x = 0; x <= 4; ++x) {
    for (int y = 0; y <= 2; ++y) {
      document["vertices_coords"].push_back({4 * x, 3 * y});
      space.push_back({4 * x * std::cos(M_PI / 6), 3 * y, 2 * (x % 2)});
      if (x < 4 && y < 2) {
        document["faces_vertices"].push_back(
            {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
      }
      if (x == 0 || x == 4 || y == 2) continue;
      document["edges_vertices"].push_back({at(x, y), at(x, y + 1)});
      document["edges_assignment"].push_back(x % 2 ? "M" : "V");
    }
  }
  document["file_frames"] = json::array({{{"frame_inherit", true},
                                          {"frame_classes", json::array({"foldedForm"})},
                                          {"vertices_coords", space}}});
  return document;
}

TEST(FoldedForm, ofQuadrilateralsStandsAtEveryFineness) {
  for (const double max_edge : {0.0, 0.03, 0.01}) {
    const FoldPaper paper = read(pleats(), 0, max_edge);
    EXPECT_NEAR(paper.sheet.area(), 0.16 * 0.06, 1e-12);
    ASSERT_TRUE(paper.positions);
    ASSERT_EQ(paper.rest_angles.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(paper.rest_angles[i], i == 1 ? M_PI / 3 : -M_PI / 3, 1e-6);
    }
    EXPECT_LT(largestStrain(paper), 1e-9);
  }
}

TEST(FoldedForm, holdsTheMiddleThatASlitOfOneEdgeGets) {
  json document = pleats();
  document["edges_vertices"].push_back({4, 7});
  document["edges_assignment"].push_back("C");
  for (const double max_edge : {0.0, 0.01}) {
    const FoldPaper paper = read(document, 0, max_edge);
    EXPECT_NEAR(borderLength(paper.sheet), 2 * (0.16 + 0.06 + 0.04), 1e-12);
    ASSERT_TRUE(paper.positions);
    EXPECT_LT(largestStrain(paper), 1e-9);
  }
}

TEST(FoldedForm, thatFoldsWhatThePatternHasFlatIsRefusedOnAFinerMesh) {
  // A sharp pleat in a flat edge of the pattern: a finer mesh has no edge there to fold.
  json document = pleats();
  document["edges_assignment"] = json::array({"M", "M", "F", "F", "M", "M"});
  json& space = document["file_frames"][0]["vertices_coords"];
  for (int i = 0; i < 15; ++i) {
    const int x = i / 3;
    space[i] = {4 * x * std::cos(M_PI / 2.5), 3 * (i % 3), 4 * std::sin(M_PI / 2.5) * (x % 2)};
  }
  EXPECT_TRUE(read(document, 0, 0).positions);
  expectWithin(fileRefusal(scratch(document.dump()), {0, 0.01}),
               "file_frames[0] is no folded form of the pattern: an edge is 0.");
}

TEST(FoldedForm, thatIsFoldedFlatIsNoPlaceToStartFromAtAnyFineness) {
  json document = pleats();
  json& space = document["file_frames"][0]["vertices_coords"];
  for (int i = 0; i < 15; ++i) space[i] = {4 * (i / 3 % 2), 3 * (i % 3), 0};
  for (const double max_edge : {0.0, 0.01}) EXPECT_FALSE(read(document, 0, max_edge).positions);
}

TEST(FoldedForm, atAnotherScaleIsBroughtToThePatterns) {
  json document = pleats();
  const Positions expected = *read(document, 0, 0).positions;
  for (json& point : document["file_frames"][0]["vertices_coords"]) {
    for (json& coordinate : point) coordinate = 1.42 * coordinate.get<double>();
  }
  for (const double max_edge : {0.0, 0.01}) {
    const FoldPaper paper = read(document, 0, max_edge);
    ASSERT_TRUE(paper.positions);
    EXPECT_LT(largestStrain(paper), 1e-9);
    EXPECT_NEAR(paper.rest_angles.at(1), M_PI / 3, 1e-6);
    if (max_edge > 0) continue;
    EXPECT_LT((*paper.positions - expected).norm(), 1e-12);
  }
}

TEST(FoldedForm, ofAnotherPatternIsPassedOver) {
  // A second pattern with a folded form of its own, nested below it: child of a child.
  json document = pleats();
  const json other_form = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  json& frames = document["file_frames"];
  frames.push_back({{"frame_classes", {"creasePattern"}},
                    {"vertices_coords", {{0, 0}, {1, 0}, {0, 1}}},
                    {"edges_vertices", {{0, 1}, {1, 2}, {2, 0}}},
                    {"faces_vertices", {{0, 1, 2}}}});
  frames.push_back({{"frame_parent", 2},
                    {"frame_inherit", true},
                    {"frame_classes", {"foldedForm"}},
                    {"vertices_coords", other_form}});
  frames.push_back({{"frame_parent", 3},
                    {"frame_inherit", true},
                    {"frame_classes", {"foldedForm"}},
                    {"vertices_coords", other_form}});
  const FoldPaper paper = read(document, 0, 0);
  ASSERT_TRUE(paper.positions);
  EXPECT_NEAR(paper.rest_angles.at(1), M_PI / 3, 1e-6);
  document["file_frames"].erase(0);
  document["file_frames"][1]["frame_parent"] = 1;
  document["file_frames"][2]["frame_parent"] = 2;
  EXPECT_FALSE(read(document, 0, 0).positions);
}

TEST(FoldedForm, andPatternMayInheritByWayOfOthers) {
  // The key frame has the mesh, the next one the angles, the one after that the flat coordinates;
  // the folded form is a child of a child of the pattern, drawn at 2.5 times its scale.
  const json all = pleats();
  const auto part = [&all](std::initializer_list<const char*> words, int parent) {
    json frame{{"frame_inherit", true}, {"frame_parent", parent}};
    for (const char* word : words) frame[word] = all[word];
    return frame;
  };
  json document{{"faces_vertices", all["faces_vertices"]},
                {"edges_vertices", all["edges_vertices"]},
                {"frame_classes", {"abstract"}}};
  const json pattern = part({"vertices_coords", "frame_classes"}, 3);
  const json between{{"frame_inherit", true}, {"frame_parent", 1}};
  json form = all["file_frames"][0];
  form["frame_parent"] = 2;
  for (json& point : form["vertices_coords"]) {
    for (json& coordinate : point) coordinate = 2.5 * coordinate.get<double>();
  }
  document["file_frames"] =
      json::array({pattern, between, part({"edges_assignment", "frame_unit"}, 0), form});
  const FoldPaper expected = read(all, 0, 0);
  for (const double max_edge : {0.0, 0.01}) {
    const FoldPaper paper = read(document, 0, max_edge);
    EXPECT_NEAR(paper.sheet.area(), expected.sheet.area(), 1e-12);
    ASSERT_TRUE(paper.positions);
    EXPECT_NEAR(paper.rest_angles.at(1), M_PI / 3, 1e-6);
    EXPECT_LT(largestStrain(paper), 1e-9);
  }
  EXPECT_LT((*read(document, 0, 0).positions - *expected.positions).norm(), 1e-12);
}

TEST(FoldedForm, ofAFileWithoutFacesStandsToo) {
  json document = pleats();
  document.erase("faces_vertices");
  for (const auto& [a, b] : {std::pair{0, 12}, {12, 14}, {14, 2}, {2, 0}}) {
    document["edges_vertices"].push_back({a, b});
    document["edges_assignment"].push_back("B");
  }
  for (const double max_edge : {0.0, 0.01}) {
    const FoldPaper paper = read(document, 0, max_edge);
    ASSERT_TRUE(paper.positions);
    EXPECT_LT(largestStrain(paper), 1e-9);
    EXPECT_NEAR(paper.rest_angles.at(1), M_PI / 3, 1e-6);
  }
}

TEST(FoldedForm, isPassedOverWhereTheFlatFormIsAskedFor) {
  FoldReadOptions options{0, 0, FoldForm::kFlat};
  json document = pleats();
  EXPECT_FALSE(readFold(scratch(document.dump()), options).positions);
  document["file_frames"][0]["vertices_coords"][0] = {100, 0, 0};
  EXPECT_EQ(fileRefusal(scratch(document.dump()), options), "");
  expectWithin(fileRefusal(scratch(document.dump()), {0, 0}), "form: flat");
}

/// The square with a diagonal: its first face above the second.
json ordered(int side) {
  json document = diagonal();
  document["faces_vertices"] = {{0, 1, 2}, {0, 2, 3}};
  document["faceOrders"] = {{0, 1, side}};
  return document;
}

/// The order of the two halves of the square, told by points; 0: none is stated.
int orderOf(const Sheet& sheet) {
  EXPECT_EQ(sheet.layerOrders().size(), 1u);
  const LayerOrder& order = sheet.layerOrders().at(0);
  EXPECT_GT(order.first.x(), order.first.y());
  EXPECT_LT(order.second.x(), order.second.y());
  return order.side;
}

TEST(FaceOrders, SurviveMeshingEditsAndFiles) {
  for (const int side : {1, 0, -1}) {
    for (const double max_edge : {0.0, 0.2}) {
      FoldPaper paper = read(ordered(side), 0.1, max_edge * 0.1);
      EXPECT_EQ(orderOf(paper.sheet), side);
      makeFoldLine(paper.sheet, {Vector2(0, 0.03), Vector2(0.1, 0.06)}, "cut", {});
      const Positions flat = Positions::Zero(3, paper.sheet.vertexCount());
      const std::vector<FoldCrease> creases(paper.sheet.creases().size());
      const json document = writeFold(paper.sheet, creases, flat, "");
      ASSERT_EQ(document["faceOrders"].size(), 1u);
      FoldReadOptions own;
      own.form = FoldForm::kFlat;
      EXPECT_EQ(orderOf(readFold(scratch(document.dump()), own).sheet), side);
    }
  }
}

TEST(FaceOrders, AreOfTheSecondFacesNormal) {
  json document = ordered(1);
  document["faces_vertices"][1] = {0, 3, 2};  // clockwise: its normal points down
  EXPECT_EQ(orderOf(read(document, 0.1).sheet), -1);
}

TEST(FaceOrders, MayBeThoseOfTheFoldedForm) {
  json document = ordered(1);
  document.erase("faceOrders");
  document["file_frames"] = json::array({{{"frame_inherit", true},
                                          {"frame_classes", json::array({"foldedForm"})},
                                          {"vertices_coords", {{0, 0}, {0, 1}, {1, 1}, {0, 1}}},
                                          {"faceOrders", {{0, 1, -1}}}}});
  document["frame_classes"] = json::array({"creasePattern"});
  EXPECT_EQ(orderOf(read(document, 0.1).sheet), -1);
}

}  // namespace
}  // namespace shell_origami
