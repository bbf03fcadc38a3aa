/// FOLD files that are written, and read back.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/report.h>
#include <shell_origami/sheet/fold_line.h>
#include "test/fold_format/fold_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

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

TEST(WriteFold, readAgainTheSheetKeepsItsTriangles) {
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

}  // namespace
}  // namespace shell_origami
