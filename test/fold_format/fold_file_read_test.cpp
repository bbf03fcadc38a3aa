#include <shell_origami/fold_format/crease_pattern.h>
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/report.h>
#include <shell_origami/sheet/fold_line.h>
#include "test/fold_format/fold_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

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

/// A folded paper with awkward numbers throughout.
struct Sample {
  Sheet sheet;
  std::vector<FoldCrease> creases;
  Positions positions;
};

Sample sample() {
  PlanarGraph graph;
  graph.points = {{0.1, 0}, {0.25, 0}, {0.25, 0.15}, {0.1, 0.15}};
  graph.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}};
  graph.segments.pop_back();
  const GraphMesh mesh = meshGraph(graph, 0.02);
  const std::vector<int>& chain = mesh.chains[4];
  // Ids with a gap, a name twice, one free and one driven.
  const std::vector<int> first(chain.begin(), chain.begin() + 3);
  const std::vector<int> rest(chain.begin() + 2, chain.end());
  Sheet sheet(mesh.triangulation, {{7, "spine", first}, {3, "spine", rest}});
  Positions positions(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const Vector2& p = sheet.flatPositions()[v];
    positions.col(v) = Vector3(p.x() / 3 * 3.01, p.y(), 0.1 * std::sin(p.x() / 0.3));
  }
  return {sheet, {{0.1, 1.0 / 3}, {-2.5, kNan}}, positions};
}

TEST(WriteFold, isReadBackToTheSamePaper) {
  const Sample before = sample();
  const json document = writeFold(before.sheet, before.creases, before.positions, "a paper");
  for (const std::string& text : {document.dump(), foldText(document)}) {
    const FoldPaper after = readFold(scratch(text));
    EXPECT_EQ(after.sheet.flatPositions(), before.sheet.flatPositions());
    EXPECT_EQ(after.sheet.triangles(), before.sheet.triangles());
    ASSERT_EQ(after.sheet.creases().size(), 2u);
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(after.sheet.creases()[i].id, before.sheet.creases()[i].id);
      EXPECT_EQ(after.sheet.creases()[i].name, before.sheet.creases()[i].name);
      EXPECT_EQ(after.sheet.creases()[i].vertices, before.sheet.creases()[i].vertices);
    }
    ASSERT_TRUE(after.positions);
    EXPECT_EQ(*after.positions, before.positions);
    ASSERT_EQ(after.rest_angles.size(), 2u);
    EXPECT_NEAR(after.rest_angles[0], 1.0 / 3, 1e-15);
    EXPECT_TRUE(std::isnan(after.rest_angles[1]));
  }
}

TEST(WriteFold, isReadBackAtAnotherFineness) {
  const Sample before = sample();
  const json document = writeFold(before.sheet, before.creases, before.positions, "");
  const FoldPaper after = read(document, 0, 0.007);
  ASSERT_EQ(after.sheet.creases().size(), 2u);
  EXPECT_EQ(after.sheet.creases()[0].id, 7u);
  EXPECT_GT(after.sheet.creases()[1].vertices.size(), before.sheet.creases()[1].vertices.size());
  EXPECT_NEAR(patternAngles(after)[0], 1.0 / 3, 1e-15);
  EXPECT_NEAR(after.sheet.area(), before.sheet.area(), 1e-15);
  ASSERT_TRUE(after.positions);
  EXPECT_NEAR(after.rest_angles[0], 1.0 / 3, 1e-15);
}

TEST(WriteFold, followsTheSpecification) {
  const Sample paper = sample();
  const json document = writeFold(paper.sheet, paper.creases, paper.positions, "a paper");
  EXPECT_EQ(document["file_spec"], 1.2);
  EXPECT_EQ(document["file_creator"], "shell_origami");
  EXPECT_EQ(document["frame_unit"], "m");
  EXPECT_EQ(document["frame_classes"], json::array({"creasePattern"}));
  EXPECT_EQ(document["vertices_coords"].size(), paper.sheet.flatPositions().size());
  EXPECT_EQ(document["faces_vertices"].size(), paper.sheet.triangles().size());
  const auto& edges = paper.sheet.edges();
  ASSERT_EQ(document["edges_vertices"].size(), edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double angle = document["edges_foldAngle"][i];
    const std::string kind = document["edges_assignment"][i];
    const bool border = edges[i].onBorder();
    EXPECT_EQ(kind, border ? "B" : edges[i].crease < 0 ? "F" : edges[i].crease == 0 ? "V" : "M");
    const double expected = edges[i].crease < 0 ? 0 : edges[i].crease == 0 ? 0.1 : -2.5;
    EXPECT_NEAR(angle, expected * 180 / M_PI, 1e-12);
  }
  const json& frame = document["file_frames"][0];
  EXPECT_EQ(frame["frame_inherit"], true);
  EXPECT_EQ(frame["frame_parent"], 0);
  EXPECT_EQ(frame["frame_classes"], json::array({"foldedForm"}));
  EXPECT_EQ(frame["frame_attributes"], json::array({"3D", "manifold", "orientable"}));
  EXPECT_EQ(frame["vertices_coords"][1].size(), 3u);
}

TEST(WriteFold, laterFramesAreWhereThePaperEnds) {
  const Sample paper = sample();
  json document = writeFold(paper.sheet, paper.creases, paper.positions, "film");
  const Positions moved = paper.positions.array() + 0.01;
  document["file_frames"].push_back(foldedFrame(paper.sheet, paper.creases, moved, 0.25, 1));
  EXPECT_EQ(document["file_frames"][1]["edges_foldAngle"], document["edges_foldAngle"]);
  EXPECT_EQ(document["file_frames"][1]["shell_origami:time"], 0.25);
  EXPECT_EQ(*read(document, 0).positions, moved);
}

TEST(WriteFold, whatIsNotFiniteIsNull) {
  Sample paper = sample();
  paper.positions(1, 2) = kNan;
  paper.creases[0].angle = std::numeric_limits<double>::infinity();
  const std::string text =
      foldText(writeFold(paper.sheet, paper.creases, paper.positions, "a \xff title"));
  const json document = json::parse(text);
  EXPECT_TRUE(document["file_frames"][0]["vertices_coords"][2][1].is_null());
  expectWithin(fileRefusal(scratch(text), {}), "vertices_coords[2] is null, not a number");
}

TEST(WriteFold, damagedNotesAreRefused) {
  const Sample paper = sample();
  const json good = writeFold(paper.sheet, paper.creases, paper.positions, "");
  const auto damaged = [&good](const char* pointer, const json& value) {
    json document = good;
    document[json::json_pointer(pointer)] = value;
    return fileRefusal(scratch(document.dump()), {});
  };
  EXPECT_EQ(fileRefusal(scratch(good.dump()), {}), "");
  const std::string first = "/shell_origami:creases/0";
  expectWithin(damaged("/shell_origami:creases/0/vertices", {0, 1000}), "names vertex 1000");
  expectWithin(damaged("/shell_origami:creases/0/vertices", {0, 1}), "crease spine");
  expectWithin(damaged("/shell_origami:creases/0/id", 3), "two creases have id 3");
  expectWithin(damaged("/shell_origami:creases/0/id", -3), "has id -3");
  expectWithin(damaged("/shell_origami:creases/0/id", 4294967295u), "has id 4294967295");
  expectWithin(damaged("/shell_origami:creases/0/name", 5), "has name 5");
  expectWithin(damaged("/shell_origami:creases/1/rest_angle_deg", "x"), "is \"x\", not a number");
}

TEST(WriteFold, keepsWhatThePatternAsksOfCreasesThatNoFoldHasDriven) {
  const FoldPaper paper = readFold(patternPath("34_os-birdBase"), {0.15, 0.02});
  const Simulation simulation(paper.sheet, {});
  const json document = foldDocument(simulation, "unfolded");
  const FoldPaper again = readFold(scratch(document.dump()), {0, 0.02});
  const std::vector<double> before = patternAngles(paper), after = patternAngles(again);
  ASSERT_EQ(before.size(), after.size());
  int mountains = 0, valleys = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(std::isnan(before[i]), std::isnan(after[i]));
    if (std::isfinite(before[i])) {
      EXPECT_NEAR(before[i], after[i], 1e-15);
    }
    mountains += before[i] < 0;
    valleys += before[i] > 0;
    EXPECT_TRUE(std::isnan(again.rest_angles.at(i))) << "no fold has driven it";
  }
  EXPECT_GT(mountains, 0);
  EXPECT_GT(valleys, 0);
  const json& kinds = document["edges_assignment"];
  EXPECT_GT(std::count(kinds.begin(), kinds.end(), "M"), 0);
  EXPECT_GT(std::count(kinds.begin(), kinds.end(), "V"), 0);
  Simulation reloaded(again.sheet, {}, *again.positions, again.rest_angles);
  for (const char* group : {"mountains", "valleys", "all"}) {
    FoldEdit fold;
    fold.where = CreaseName{group};
    fold.angle = 0.1;
    EXPECT_FALSE(reloaded.fold(fold).crease_ids.empty()) << group;
  }
}

TEST(WriteFold, aPatternThatWasFoldedStillAsksForItsAngles) {
  json document = diagonal();
  document["edges_foldAngle"] = {0, 0, 0, 0, 180};
  const FoldPaper paper = read(document);
  const json written = writeFold(paper.sheet, {{0.5, 0.6}}, flatInSpace(paper.sheet), "");
  const FoldPaper again = read(written);
  EXPECT_NEAR(again.sheet.creases()[0].pattern_angle, M_PI, 1e-15);
  EXPECT_NEAR(again.rest_angles.at(0), 0.6, 1e-15);
}

TEST(ReadFold, aFileOfOurOwnKeepsItsTriangles) {
  Sheet sheet(triangulateRectangle(0.15, 0.15, 0.01));
  const auto round_trip = [&](double max_edge) {
    const json document =
        writeFold(sheet, std::vector<FoldCrease>(sheet.creases().size()), flatInSpace(sheet), "");
    return readFold(scratch(document.dump()), {0, max_edge}).sheet;
  };
  for (int edit = 0; edit < 2; ++edit) {
    const Sheet again = round_trip(0.01);
    EXPECT_EQ(again.flatPositions(), sheet.flatPositions());
    EXPECT_EQ(again.triangles(), sheet.triangles());
    makeFoldLine(sheet, {Vector2(0, 0.04), Vector2(0.15, 0.11)});
  }
  EXPECT_GT(round_trip(0.005).vertexCount(), 2 * sheet.vertexCount());
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
