/// Crease patterns in FOLD files that are read.
#include <shell_origami/fold_format/crease_pattern.h>
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>
#include <shell_origami/sheet/fold_line.h>
#include "test/fold_format/fold_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

TEST(ReadFold, everyTestPatternLoadsAtEveryFineness) {
  const struct {
    const char* name;
    double area;
    int mountains, valleys;  // crease lines
  } patterns[] = {{"01_diagonal-cp", 1, 0, 1},
                  {"10_house-cp", 1, 4, 6},
                  {"12_kabuto-cp", 1, 9, 8},
                  {"15_crane-cp", 1, 32, 24},
                  {"16_miura-cp", 1, 60, 60},
                  {"17_bad-twist-UNSAT", 1, 4, 8},
                  {"30_os-simpleVertex", 1, 3, 1},
                  {"31_os-mapfold", 0.734236352, 3, 4},
                  {"32_os-squareBase", 1, 2, 1},
                  {"34_os-birdBase", 1, 10, 6},
                  {"36_os-traditionalCrane", 1, 62, 47},
                  {"41_os-curvedPleatSimple", 1, 1, 1},
                  {"50_ff-030_tanakaoripa_fish_base", 1, 68, 64},
                  {"51_ff-045_traditionaloripa_Pig", 1, 30, 24},
                  {"52_ff-018_komatsu_Butterfly_Base", 1, 57, 50},
                  {"53_ff-021_chan_Simple_Dragon", 1, 45, 43},
                  {"54_ff-062_furutaoripa_houou", 1, 28, 23},
                  {"55_ff-121_komatsuoripa_rafflesia", 1, 44, 24},
                  {"56_ff-244_komatsuoripa_Smallbird_Base", 1, 6, 3},
                  {"57_ff-UNSAT_007", 1, 64, 68},
                  {"58_ff-122_brown_4x4_A100", 1, 8, 4}};
  for (const auto& pattern : patterns) {
    for (const double max_edge : {0.0, 0.02, 0.007}) {
      SCOPED_TRACE(testing::Message() << pattern.name << " at " << max_edge);
      const FoldPaper paper = readFold(patternPath(pattern.name), {0.15, max_edge});
      EXPECT_NO_THROW(paper.sheet.validate());
      EXPECT_NEAR(area(paper), pattern.area * 0.0225, 1e-5);
      EXPECT_FALSE(paper.positions);
      const auto angles = patternAngles(paper);
      EXPECT_EQ(std::count_if(angles.begin(), angles.end(), [](double a) { return a < 0; }),
                pattern.mountains);
      EXPECT_EQ(std::count_if(angles.begin(), angles.end(), [](double a) { return a > 0; }),
                pattern.valleys);
      for (const Edge& edge : paper.sheet.edges()) {
        const auto [a, b] = edge.vertices;
        const auto& p = paper.sheet.flatPositions();
        if (max_edge > 0) {
          EXPECT_LE((p[a] - p[b]).norm(), max_edge * (1 + 1e-9));
        }
      }
    }
  }
}

TEST(ReadFold, creaseLengthDoesNotDependOnFineness) {
  for (const char* name : {"15_crane-cp", "34_os-birdBase", "41_os-curvedPleatSimple"}) {
    std::vector<double> lengths;
    for (const double max_edge : {0.0, 0.05, 0.01}) {
      const Sheet sheet = readFold(patternPath(name), {0.15, max_edge}).sheet;
      double length = 0;
      for (const Edge& edge : sheet.edges()) {
        const auto [a, b] = edge.vertices;
        if (edge.crease < 0) continue;
        length += (sheet.flatPositions()[a] - sheet.flatPositions()[b]).norm();
      }
      lengths.push_back(length);
    }
    EXPECT_NEAR(lengths[0], lengths[1], 1e-9) << name;
    EXPECT_NEAR(lengths[0], lengths[2], 1e-9) << name;
  }
}

TEST(ReadFold, aFoldedFormAloneIsRefused) {
  const std::string sentence = fileRefusal(patternPath("03_squaretwist-rigid-3d"));
  expectWithin(sentence, "03_squaretwist-rigid-3d.fold: holds only a folded form");
}

TEST(ReadFold, groupsEdgesIntoStraightLines) {
  const FoldPaper paper = read(cross());
  ASSERT_EQ(paper.sheet.creases().size(), 3u);
  // Two mountains in a row are one line; a mountain and a valley in a row are two.
  EXPECT_EQ(paper.sheet.creases()[0].vertices, (std::vector<int>{1, 8, 5}));
  EXPECT_EQ(paper.sheet.creases()[1].vertices, (std::vector<int>{8, 3}));
  EXPECT_EQ(paper.sheet.creases()[2].vertices, (std::vector<int>{7, 8}));
  EXPECT_EQ(paper.sheet.creases()[0].name, "crease_0");
  EXPECT_EQ(paper.sheet.creases()[2].name, "crease_2");
  EXPECT_EQ(paper.sheet.creases()[2].id, 2u);
  EXPECT_EQ(patternAngles(paper), (std::vector<double>{-M_PI, -M_PI, M_PI}));
  EXPECT_EQ(paper.sheet.vertexCount(), 9);
}

TEST(ReadFold, anglesAreInDegreesAndNullIsFree) {
  json document = cross();
  document["edges_foldAngle"] = {0, 0, 0, 0, 0, 0, 0, 0, -45, -90, nullptr, 30};
  const FoldPaper paper = read(document);
  ASSERT_EQ(patternAngles(paper).size(), 4u);  // -45 and -90 are no longer one line
  EXPECT_NEAR(patternAngles(paper)[0], -M_PI / 4, 1e-15);
  EXPECT_NEAR(patternAngles(paper)[1], -M_PI / 2, 1e-15);
  EXPECT_TRUE(std::isnan(patternAngles(paper)[2]));
  EXPECT_NEAR(patternAngles(paper)[3], M_PI / 6, 1e-15);

  document["edges_foldAngles"] = document["edges_foldAngle"];  // its name in FOLD 1.0
  document.erase("edges_foldAngle");
  EXPECT_NEAR(patternAngles(read(document))[0], -M_PI / 4, 1e-15);
}

TEST(ReadFold, flatAndUnassignedEdges) {
  json document = cross();
  document["edges_assignment"] = {"B", "B", "B", "B", "B", "B", "B", "B", "F", "J", "U", "U"};
  const FoldPaper paper = read(document);
  ASSERT_EQ(paper.sheet.creases().size(), 1u);  // flat ones are none, unassigned ones are free
  EXPECT_EQ(paper.sheet.creases()[0].vertices, (std::vector<int>{7, 8, 3}));
  EXPECT_TRUE(std::isnan(patternAngles(paper)[0]));
  // FOLD says 0 of what is unassigned.
  document["edges_foldAngle"] = std::vector<int>(12, 0);
  EXPECT_TRUE(std::isnan(patternAngles(read(document))[0]));
  // Without assignments the signs of the angles tell.
  document.erase("edges_assignment");
  document["edges_foldAngle"] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -10, 10};
  document["faces_vertices"] = {{0, 1, 8, 7}, {1, 2, 3, 8}, {8, 3, 4, 5}, {7, 8, 5, 6}};
  const FoldPaper signs = read(document);
  ASSERT_EQ(signs.sheet.creases().size(), 2u);
  EXPECT_NEAR(patternAngles(signs)[1], M_PI / 18, 1e-15);
}

TEST(ReadFold, unitsAndScale) {
  json document = diagonal();
  document["frame_unit"] = "cm";
  EXPECT_NEAR(area(read(document, 0)), 1e-4, 1e-18);
  document["frame_unit"] = "in";
  EXPECT_NEAR(area(read(document, 0)), 0.0254 * 0.0254, 1e-15);
  document["frame_unit"] = "pt";
  EXPECT_NEAR(area(read(document, 0)), std::pow(0.0254 / 72, 2), 1e-18);
  EXPECT_NEAR(area(read(document, 0.1)), 0.01, 1e-15);  // a scale given goes before the unit
  document["frame_unit"] = "unit";
  expectWithin(fileRefusal(scratch(document.dump()), {0, 0}), "give a scale");
  document["frame_unit"] = "ell";
  expectWithin(fileRefusal(scratch(document.dump()), {0, 0}), "unit (frame_unit is \"ell\"): give");
  document.erase("frame_unit");
  expectWithin(fileRefusal(scratch(document.dump()), {0, 0}), "give a scale");
  expectWithin(fileRefusal(scratch(document.dump()), {-1, 0}), "scale is -1");
  expectWithin(fileRefusal(scratch(document.dump()), {kNan, 0}), "scale is nan");
  expectWithin(fileRefusal(scratch(document.dump()), {1, -1}), "max_edge is -1");
  expectWithin(fileRefusal(scratch(document.dump()), {1, kNan}), "max_edge is nan");
}

TEST(ReadFold, theSheetMayLieInAnyPlane) {
  // The faces tell which side is up: in the xz plane (x, z) as they stand, seen from -y.
  const double s = std::sqrt(0.5);
  const json planes[] = {{{0, 0, 5}, {2, 0, 5}, {2, 1, 5}, {0, 1, 5}},    // xy
                         {{0, 5, 0}, {2, 5, 0}, {2, 5, 1}, {0, 5, 1}},    // xz, faces seen from -y
                         {{0, 5, 0}, {2, 5, 0}, {2, 5, -1}, {0, 5, -1}},  // xz, from +y
                         {{5, 0, 0}, {5, 2, 0}, {5, 2, 1}, {5, 0, 1}},    // yz
                         {{0, 0, 0}, {2, 0, 0}, {2, s, s}, {0, s, s}}};   // tilted about x
  for (const json& coordinates : planes) {
    SCOPED_TRACE(coordinates.dump());
    json document = diagonal();
    document["vertices_coords"] = coordinates;
    const FoldPaper paper = read(document);
    EXPECT_NEAR(area(paper), 2, 1e-12);
    const auto& p = paper.sheet.flatPositions();
    EXPECT_GT(doubleArea(p[0], p[1], p[2]), 0);  // not mirrored
    EXPECT_NEAR((p[1] - p[0]).norm(), 2, 1e-12);
  }
}

TEST(ReadFold, facesInAnyOrderAndNumberOfCorners) {
  json document = cross();
  document["faces_vertices"] = {{7, 8, 1, 0}, {1, 2, 3, 8}, {5, 4, 3, 8}, {7, 8, 5, 6}};
  EXPECT_EQ(read(document).sheet.triangles().size(), 8u);
  // In the xy plane coordinates say which side is up, not the order of a face's corners.
  document["faces_vertices"] = {{7, 8, 1, 0}, {8, 3, 2, 1}, {5, 4, 3, 8}, {6, 5, 8, 7}};
  EXPECT_EQ(read(document).sheet.flatPositions()[3], Vector2(2, 1));
  document = diagonal();
  document["faces_vertices"] = {{2, 1, 0}, {0, 2, 3}};
  EXPECT_EQ(read(document).sheet.triangles().size(), 2u);
  // Without assignments the border is what has one face.
  document["edges_assignment"] = {"U", "U", "U", "U", "V"};
  const FoldPaper paper = read(document);
  ASSERT_EQ(paper.sheet.creases().size(), 1u);
  EXPECT_EQ(patternAngles(paper)[0], M_PI);
  // Faces alone are a sheet without creases.
  document.erase("edges_assignment");
  document.erase("edges_vertices");
  EXPECT_EQ(read(document).sheet.creases().size(), 0u);
}

TEST(ReadFold, unusedAndDoubleVerticesAreDropped) {
  json document = diagonal();
  document["vertices_coords"] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {7, 7}, {1, 1}, {0.3, 0.2}};
  document["edges_vertices"] = {{0, 1}, {1, 2}, {5, 3}, {3, 0}, {0, 5}, {2, 0}};
  document["edges_assignment"] = {"B", "B", "B", "B", "V", "V"};
  const FoldPaper paper = read(document);
  EXPECT_EQ(paper.sheet.vertexCount(), 4);
  EXPECT_EQ(paper.sheet.creases().size(), 1u);
}

TEST(ReadFold, holesStayOpen) {
  json document = {
      {"vertices_coords", {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}}},
      {"edges_vertices",
       {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {2, 6}}},
      {"edges_assignment", {"B", "B", "B", "B", "B", "B", "B", "B", "M", "C"}}};
  document["edges_assignment"][9] = "V";
  EXPECT_NEAR(area(read(document)), 8, 1e-12);
  EXPECT_NEAR(area(read(document, 1, 0.2)), 8, 1e-12);
  // A crease across the hole lies on nothing.
  document["edges_vertices"].push_back({4, 6});
  document["edges_assignment"].push_back("M");
  expectWithin(refusal(document),
               "edges_vertices[10] from vertex 4 to vertex 6 lies off the paper");
}

TEST(ReadFold, cutsAreBorderOnlyWhereTheyCanBe) {
  json document = diagonal();
  document["edges_assignment"] = {"B", "C", "B", "B", "V"};
  EXPECT_NEAR(area(read(document)), 1, 1e-12);
  document["edges_assignment"] = {"B", "B", "B", "B", "C"};
  expectWithin(refusal(document), "its cuts part the paper into 2 pieces, but a sheet is one");
  document["edges_assignment"] = {"B", "B", "B", "B", "B"};
  expectWithin(refusal(document),
               "edges_vertices[4] from vertex 0 to vertex 2 is border (B) with paper");
  document["edges_assignment"] = {"B", "B", "B", "B", "C"};
  document.erase("faces_vertices");
  expectWithin(refusal(document), "its cuts part the paper into 2 pieces");
  document["edges_assignment"] = {"C", "C", "C", "C", "V"};
  EXPECT_NEAR(area(read(document)), 1, 1e-12);
}

TEST(ReadFold, thePatternMayBeALaterFrame) {
  // The key frame is a tent; its pattern inherits everything else.
  json document = diagonal();
  json pattern = {{"frame_inherit", true},
                  {"frame_classes", json::array({"creasePattern"})},
                  {"vertices_coords", document["vertices_coords"]}};
  document["vertices_coords"] = {{0, 0, 0}, {0.5, 0.5, 0.7071067811865476}, {1, 1, 0}, {0, 1, 0}};
  document["frame_classes"] = json::array({"foldedForm"});
  document["file_frames"] = json::array({pattern});
  const FoldPaper paper = read(document);
  EXPECT_NEAR(area(paper), 1, 1e-12);
  ASSERT_TRUE(paper.positions);
  EXPECT_EQ(paper.positions->col(1), Vector3(0.5, 0.5, 0.7071067811865476));
  // The flap of corner 1 stands upright over the diagonal: a valley of 90 degrees, measured.
  ASSERT_EQ(paper.rest_angles.size(), 1u);
  EXPECT_NEAR(paper.rest_angles[0], M_PI / 2, 1e-9);
  EXPECT_NEAR(read(document, 1, 0.3).rest_angles.at(0), M_PI / 2, 1e-9);
}

TEST(ReadFold, aFlatFoldedFormIsNoPlaceToStartFrom) {
  json document = diagonal();
  document["file_frames"] = json::array({{{"frame_inherit", true},
                                          {"frame_classes", json::array({"foldedForm"})},
                                          {"vertices_coords", {{0, 0}, {0, 1}, {1, 1}, {0, 1}}}}});
  document["frame_classes"] = json::array({"creasePattern"});
  EXPECT_FALSE(read(document).positions);
}

TEST(ReadFold, verticesThatCoincideByWayOfAnotherAreOne) {
  // The extent is 1: points closer than 1e-9 coincide. The first and the third do not, but both
  // coincide with the second.
  const std::vector<Vector2> points{{1.4e-9, 0}, {0.7e-9, 0}, {0, 0}, {1, 1}};
  EXPECT_EQ(mergeCoincident(points), (std::vector<int>{0, 0, 0, 3}));
  EXPECT_EQ(mergeCoincident({points[2], points[0], points[1], points[3]}),
            (std::vector<int>{0, 0, 0, 3}));
  EXPECT_EQ(mergeCoincident({points[1], points[0], points[2], points[3]}),
            (std::vector<int>{0, 0, 0, 3}));
}

TEST(ReadFold, aFormThatIsFoldedFlatIsNoPattern) {
  expectWithin(fileRefusal(patternPath("02_diagonal-folded")),
               "holds only a form that is folded flat, and no crease pattern to fold it from");
  json document = json::parse(std::ifstream(patternPath("02_diagonal-folded")));
  document.erase("faces_vertices");
  EXPECT_NE(refusal(document), "");
  document.erase("frame_classes");
  EXPECT_NE(refusal(document), "");
}

TEST(ReadFold, creasesMayNotBeNamedAsGroupsAre) {
  Sheet sheet(triangulateRectangle(1, 1, 0.5));
  makeFoldLine(sheet, {Vector2(0, 0), Vector2(1, 1)}, "spine");
  json document = writeFold(sheet, {{}}, flatInSpace(sheet), "");
  for (const std::string& name : {std::string("all"), std::string("mountains"),
                                  std::string("valleys"), std::string(), std::string(101, 'x')}) {
    document["shell_origami:creases"][0]["name"] = name;
    expectWithin(refusal(document), "crease");
    if (name.empty()) continue;  // asks for a name to be made up
    EXPECT_THROW(makeFoldLine(sheet, {Vector2(0, 1), Vector2(1, 0)}, name), std::invalid_argument);
  }
  document["shell_origami:creases"][0]["name"] = "alls";
  EXPECT_EQ(refusal(document), "");
}

}  // namespace
}  // namespace shell_origami
