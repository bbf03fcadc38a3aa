#include "test/fold_format/fold_samples.h"

#include <gtest/gtest.h>

#include <string>

namespace shell_origami {
namespace {

TEST(ReadFold, refusesWhatIsNoPattern) {
  expectWithin(fileRefusal("/nowhere/x.fold"),
               "/nowhere/x.fold: cannot be read: there is no such file");
  expectWithin(fileRefusal("/tmp"), "folder");
  expectWithin(fileRefusal("/dev/zero"), "not a regular file");
  expectWithin(fileRefusal(scratch("{\"a\": 1,\n\n \"b\": nope}")), "is not JSON from line 3");
  expectWithin(fileRefusal(scratch("")), "is not JSON from line 1");
  expectWithin(fileRefusal(scratch("{\"a\": 1e999}")), "is not JSON that can be read");
  expectWithin(fileRefusal(scratch("{\"a\": NaN}")), "is not JSON");
  expectWithin(fileRefusal(scratch("[1, 2]")), "no object");
  expectWithin(fileRefusal(scratch("{}")), "holds no vertices_coords");
  expectWithin(fileRefusal(scratch(std::string(200000, '['))), "nest deeper than 100");
}

TEST(ReadFold, namesTheEntryThatIsWrong) {
  const struct {
    const char* pointer;
    json value;
    const char* sentence;
  } cases[] = {
      {"/vertices_coords/2", {1}, "vertices_coords[2] is a list of 1, not two or three numbers"},
      {"/vertices_coords/2/0", nullptr, "vertices_coords[2] is null, not a number"},
      {"/vertices_coords/2/0", 1e300, "vertices_coords[2]"},
      {"/vertices_coords", 7, "vertices_coords is no list"},
      {"/edges_vertices/4", {0, 9}, "edges_vertices[4] names vertex 9, but there are 4"},
      {"/edges_vertices/4", {0, -1}, "edges_vertices[4] names vertex -1"},
      {"/edges_vertices/4", {0, 1.5}, "edges_vertices[4] holds 1.5, not a vertex"},
      {"/edges_vertices/4", {0, 4294967296}, "edges_vertices[4] names vertex 4294967296"},
      {"/edges_vertices/4", {0, 18446744073709551615u}, "names vertex 18446744073709551615"},
      {"/edges_vertices/4", {0}, "edges_vertices[4] is a list of 1, not a pair"},
      {"/edges_vertices/4", {2, 2}, "edges_vertices[4] has no length"},
      {"/edges_vertices/4", {0, 1}, "edges_vertices[4] from vertex 0 to vertex 1 join the same"},
      {"/edges_assignment/4", "X", "edges_assignment[4] is \"X\", not one of"},
      {"/edges_assignment/4", 3, "edges_assignment[4] is 3, not one of"},
      {"/edges_assignment", {"B"}, "edges_assignment has 1 entries for 5 edges"},
      {"/edges_foldAngle", {1, 2}, "edges_foldAngle has 2 entries for 5 edges"},
      {"/edges_foldAngle", {0, 0, 0, 0, 181}, "edges_foldAngle[4] is 181"},
      {"/edges_foldAngle", {0, 0, 0, 0, -90}, "edges_vertices[4] is assigned V"},
      {"/faces_vertices/1", {0, 2}, "faces_vertices[1] is no list of at least 3 vertices"},
      {"/faces_vertices/1", {0, 2, 8}, "faces_vertices[1] names vertex 8"},
      {"/faces_vertices/1", {0, 2, 2}, "faces_vertices[1] has no area"},
      {"/faces_vertices/2", {0, 2, 1}, "more than two faces"},
      {"/file_frames", 1, "file_frames is no list"},
      {"/file_frames/0", 1, "file_frames[0] is no object"},
      {"/shell_origami:creases", {1}, "shell_origami:creases[0] has no id"}};
  for (const auto& [pointer, value, sentence] : cases) {
    json document = diagonal();
    if (std::string(pointer) == "/file_frames/0") document["file_frames"] = json::array();
    const json::json_pointer at(pointer);
    document[at] = value;
    expectWithin(refusal(document), sentence);
  }
}

TEST(ReadFold, refusesImpossibleSheets) {
  json document = diagonal();
  document["edges_vertices"].push_back({1, 3});
  document["edges_assignment"].push_back("M");
  expectWithin(fileRefusal(scratch(document.dump()), {1, 0.3}),
               "edges_vertices[4] from vertex 0 to vertex 2 and edges_vertices[5] from vertex 1 to "
               "vertex 3 cross or touch");
  document = diagonal();
  document["edges_vertices"] = {{0, 1}, {1, 2}, {2, 3}};
  document["edges_assignment"] = {"M", "M", "V"};
  document.erase("faces_vertices");
  expectWithin(refusal(document), "has no outline");
  document = diagonal();
  document.erase("faces_vertices");
  document["edges_assignment"] = {"B", "B", "B", "M", "V"};
  expectWithin(refusal(document), "the outline ends at vertex 0");
  // Two faces of a bow tie that overlap.
  document = {{"vertices_coords", {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.2, 0.9}}},
              {"faces_vertices", {{0, 1, 2}, {0, 2, 3}, {2, 3, 4}}}};
  EXPECT_NE(refusal(document), "");
  document = {{"vertices_coords", {{0, 0}, {2, 0}, {0, 2}, {3, 0.1}, {0.1, 3}}},
              {"faces_vertices", {{0, 1, 2}, {0, 3, 4}}}};
  EXPECT_NE(refusal(document), "");
  // Two sheets beside each other.
  document = {{"vertices_coords", {{0, 0}, {1, 0}, {0, 1}, {5, 0}, {6, 0}, {5, 1}}},
              {"faces_vertices", {{0, 1, 2}, {3, 4, 5}}}};
  expectWithin(refusal(document), "more than one sheet");
  document = diagonal();
  document["vertices_coords"] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  EXPECT_NE(refusal(document), "");
}

TEST(ReadFold, refusesFramesThatDoNotFit) {
  json document = diagonal();
  document["frame_classes"] = json::array({"creasePattern"});
  json form = {{"frame_inherit", true},
               {"frame_classes", json::array({"foldedForm"})},
               {"vertices_coords", {{0, 0, 0}, {1, 0, 0}, {5, 1, 0}, {0, 1, 0}}}};
  document["file_frames"] = json::array({form});
  expectWithin(refusal(document), "file_frames[0] is no folded form of the pattern");
  document["file_frames"][0]["vertices_coords"] = {{0, 0, 0}, {1, 0, 0}};
  expectWithin(refusal(document), "file_frames[0] has 2 vertices, fewer than the pattern");
  document = {{"file_frames", json::array({{{"frame_inherit", true}, {"frame_parent", 2}},
                                           {{"frame_inherit", true}, {"frame_parent", 1}}})}};
  expectWithin(refusal(document), "inherits from itself");
  document["file_frames"][0]["frame_parent"] = 7;
  expectWithin(refusal(document), "frame_parent 7, which is no frame");
  document = diagonal();
  document["frame_classes"] = json::array({"creasePattern"});
  document["vertices_coords"] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  expectWithin(refusal(document), "do not span one plane");
}

}  // namespace
}  // namespace shell_origami
