/// Folding sequences: what the frames of a FOLD file of class "diagrams" ask of the creases.
#include "test/fold_format/fold_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180;

/// A square of two units with the creases x = 1 (two edges, the first pattern edges) and, on its
/// right half, y = 1.
json sequence() {
  json document{
      {"file_spec", 1.2},
      {"file_classes", {"diagrams"}},
      {"frame_classes", {"creasePattern"}},
      {"vertices_coords", {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {1, 1}}},
      {"edges_vertices",
       {{1, 7}, {7, 5}, {7, 3}, {0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 0}}},
      {"edges_assignment", {"V", "V", "M", "B", "B", "B", "B", "B", "B", "B"}},
      {"faces_vertices", {{0, 1, 7, 5, 6}, {1, 2, 3, 7}, {7, 3, 4, 5}}}};
  document["file_frames"] = json::array();
  return document;
}

/// A frame over the pattern's own edges.
json frame(double first, json second) {
  return {{"frame_inherit", true},
          {"frame_parent", 0},
          {"edges_foldAngle", {first, first, std::move(second), 0, 0, 0, 0, 0, 0, 0}}};
}

TEST(FoldStages, areTheAnglesOfTheFrames) {
  json document = sequence();
  document["file_frames"] = {frame(90, nullptr), frame(30, -45)};
  for (const double max_edge : {0.0, 0.3}) {
    const FoldPaper paper = read(document, 1, max_edge);
    EXPECT_TRUE(paper.notes.empty());
    ASSERT_EQ(paper.sheet.creases().size(), 2u);
    ASSERT_EQ(paper.stages.size(), 2u);
    EXPECT_NEAR(paper.stages[0][0], 90 * kDegree, 1e-12);
    EXPECT_TRUE(std::isnan(paper.stages[0][1]));
    EXPECT_NEAR(paper.stages[1][0], 30 * kDegree, 1e-12);
    EXPECT_NEAR(paper.stages[1][1], -45 * kDegree, 1e-12);
  }
}

TEST(FoldStages, ofAnotherMeshAreFoundByFlatCoordinates) {
  json document = sequence();
  // Before y = 1 is creased: another mesh, in which x = 1 is one edge.
  document["file_frames"] = {
      {{"vertices_coords", {{0, 0}, {1, 0}, {1, 0, 1}, {1, 2, 1}, {1, 2}, {0, 2}}},
       {"vertices_shell_origami:flat_coords", {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}}},
       {"edges_vertices", {{1, 4}, {0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}}},
       {"edges_assignment", {"V", "B", "B", "B", "B", "B", "B"}},
       {"edges_foldAngle", {90, 0, 0, 0, 0, 0, 0}}},
      frame(90, -120)};
  const FoldPaper paper = read(document, 0.5, 0.2);
  EXPECT_TRUE(paper.notes.empty());
  ASSERT_EQ(paper.stages.size(), 2u);
  EXPECT_NEAR(paper.stages[0][0], 90 * kDegree, 1e-12);
  EXPECT_EQ(paper.stages[0][1], 0);
  EXPECT_NEAR(paper.stages[1][1], -120 * kDegree, 1e-12);
}

TEST(FoldStages, framesThatCannotBeUsedAreNoted) {
  json document = sequence();
  json no_angles = frame(90, -45), other_mesh = frame(90, -45), short_list = frame(90, -45);
  no_angles.erase("edges_foldAngle");
  other_mesh["edges_vertices"] = document["edges_vertices"];
  other_mesh["edges_vertices"][2] = {7, 2};
  short_list["edges_foldAngle"] = {90};
  document["file_frames"] = {no_angles, other_mesh, short_list, frame(30, -45)};
  const FoldPaper paper = read(document);
  ASSERT_EQ(paper.stages.size(), 1u);
  EXPECT_NEAR(paper.stages[0][0], 30 * kDegree, 1e-12);
  ASSERT_EQ(paper.notes.size(), 3u);
  expectWithin(paper.notes[0], "file_frames[0] was passed over: it has no edges_foldAngle");
  expectWithin(paper.notes[1], "file_frames[1] was passed over: its mesh is not the pattern's");
  expectWithin(paper.notes[2], "file_frames[2] was passed over: edges_foldAngle has 1 entries");
}

TEST(FoldStages, belongToSequencesAlone) {
  json document = sequence();
  document["file_frames"] = {frame(90, -45)};
  document["file_classes"] = {"animation"};
  EXPECT_TRUE(read(document).stages.empty());
  EXPECT_FALSE(isFoldSequence(scratch(document.dump())));
  document["file_classes"] = {"diagrams"};
  EXPECT_TRUE(isFoldSequence(scratch(document.dump())));
  EXPECT_FALSE(isFoldSequence(scratch("1 0 0 1 1\n", ".cp")));
}

}  // namespace
}  // namespace shell_origami
