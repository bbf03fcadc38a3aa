/// Patterns as people draw them: lines that cross, without faces, in several formats.
#include <shell_origami/fold_format/crease_pattern.h>
#include "test/fold_format/fold_samples.h"
#include "test/mesh/lattice.h"
#include "test/sheet/random_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace shell_origami {
namespace {

/// Border of a square of 4 x 4 units as lines of a .cp file.
const std::string kSquare = "1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n";

FoldPaper readText(const std::string& text, const std::string& extension, double max_edge = 0) {
  return readPatternFile(scratch(text, extension), {1, max_edge});
}

/// A drawing of 4 x 4 units with a border and more elements.
std::string drawnWith(const std::string& elements) {
  return "<svg>\n<rect width='4' height='4' stroke='black'/>\n" + elements + "\n</svg>\n";
}

void expectNote(const FoldPaper& paper, const std::string& part) {
  std::string all;
  for (const std::string& note : paper.notes) all += note + "\n";
  EXPECT_NE(all.find(part), std::string::npos) << "'" << all << "' lacks '" << part << "'";
}

TEST(Drawing, theSamePatternInEveryFormatIsTheSameSheet) {
  for (const double max_edge : {0.0, 0.02}) {
    const FoldReadOptions options{0, max_edge, FoldForm::kFolded, 0.125};
    const FoldPaper fold = readPatternFile(dataPath("80_windmill.fold"), options);
    EXPECT_NEAR(fold.sheet.area(), 0.125 * 0.125, 1e-15);
    EXPECT_EQ(fold.sheet.creases().size(), 6u);
    for (const char* extension : {".cp", ".opx", ".svg"}) {
      const FoldPaper other =
          readPatternFile(dataPath(std::string("80_windmill") + extension), options);
      ASSERT_EQ(other.sheet.vertexCount(), fold.sheet.vertexCount()) << extension;
      for (int v = 0; v < fold.sheet.vertexCount(); ++v) {
        // The units differ, and with them the last bits where lines cross.
        EXPECT_LT((other.sheet.flatPositions()[v] - fold.sheet.flatPositions()[v]).norm(), 1e-16);
      }
      EXPECT_EQ(other.sheet.triangles(), fold.sheet.triangles()) << extension;
      EXPECT_EQ(patternAngles(other), patternAngles(fold)) << extension;
      for (std::size_t i = 0; i < fold.sheet.creases().size(); ++i) {
        EXPECT_EQ(other.sheet.creases()[i].vertices, fold.sheet.creases()[i].vertices);
      }
      EXPECT_EQ(other.notes, fold.notes) << extension;
    }
  }
}

TEST(Drawing, OrigamiSimulatorsDrawingsAreThePatternsConvertedFromThem) {
  // Lines of the crane end up to a thousandth of its size off each other and off its border.
  for (const auto& [name, precision] :
       {std::pair{"34_os-birdBase", 1e-9}, {"36_os-traditionalCrane", 1e-3}}) {
    const FoldReadOptions options{0, 0, FoldForm::kFolded, 1};
    const FoldPaper drawing = readPatternFile(dataPath(name + std::string(".svg")), options);
    const FoldPaper fold = readPatternFile(patternPath(name), options);
    EXPECT_EQ(drawing.sheet.vertexCount(), fold.sheet.vertexCount());
    EXPECT_NEAR(creaseLength(drawing.sheet), creaseLength(fold.sheet), 10 * precision);
    for (const Vector2& p : fold.sheet.flatPositions()) {
      const int nearest = drawing.sheet.nearestVertex(p);
      EXPECT_LT((drawing.sheet.flatPositions()[nearest] - p).norm(), precision);
    }
  }
}

TEST(Drawing, edgesWithoutFacesAreDividedWhereTheyCross) {
  json document = diagonal();
  document["edges_vertices"].push_back({1, 3});
  document["edges_assignment"].push_back("M");
  document.erase("faces_vertices");
  const FoldPaper paper = read(document);
  EXPECT_EQ(paper.sheet.vertexCount(), 5);
  EXPECT_EQ(paper.sheet.flatPositions()[4], Vector2(0.5, 0.5));
  EXPECT_EQ(patternAngles(paper), (std::vector<double>{M_PI, -M_PI}));
  EXPECT_EQ(paper.sheet.creases()[0].vertices, (std::vector<int>{0, 4, 2}));
  EXPECT_EQ(paper.notes,
            std::vector<std::string>{"2 edges were divided at crossings and at points of others"});
  EXPECT_TRUE(read(diagonal()).notes.empty());
}

TEST(Drawing, linesThroughOnePointMeetInOneVertex) {
  // Eight lines through a point that no double is, and their crossings all a little off it.
  std::string text = kSquare;
  for (const double angle : {0.1, 0.4, 0.8, 1.1, 1.7, 2.1, 2.5, 2.9}) {
    const Vector2 center(1.1, 2.3), along(std::cos(angle), std::sin(angle));
    text += "2";
    for (const double sign : {-1.0, 1.0}) {
      const Vector2 to = sign * along;
      const double reach = std::min(((to.x() > 0 ? 4 : 0) - center.x()) / to.x(),
                                    ((to.y() > 0 ? 4 : 0) - center.y()) / to.y());
      const Vector2 end = center + reach * to;
      std::ostringstream numbers;
      numbers << std::setprecision(12) << " " << end.x() << " " << end.y();
      text += numbers.str();
    }
    text += "\n";
  }
  const FoldPaper paper = readText(text, ".cp");
  EXPECT_EQ(paper.sheet.vertexCount(), 4 + 16 + 1);
  EXPECT_EQ(paper.sheet.creases().size(), 8u);
}

TEST(Drawing, pointsAndEdgesThatAreNearlyTogetherAreTogether) {
  // The crease ends short of the border, and another one beside its middle.
  const FoldPaper paper =
      readText(kSquare + "2 1 0.0003 3 3.9998\n3 2.0002 2 4.0003 2.0001\n", ".cp");
  EXPECT_EQ(paper.sheet.vertexCount(), 4 + 4);
  expectNote(paper, "4 edges were divided");
  const FoldPaper corner = readText(kSquare + "2 0.0002 0.0001 4 3.9997\n", ".cp");
  EXPECT_EQ(corner.sheet.vertexCount(), 4);
  expectNote(corner,
             "2 points were merged with others closer than a thousandth of the pattern's size");
  EXPECT_EQ(corner.sheet.creases().size(), 1u);
  // What is farther away is no mistake.
  EXPECT_EQ(readText(kSquare + "2 1 0.005 3 3.995\n", ".cp").sheet.vertexCount(), 4 + 2);
}

TEST(Drawing, aLineThatPassesAPointStaysStraight) {
  const FoldPaper paper = readText(kSquare + "2 0 1 4 1\n3 2 1.0003 2 4\n", ".cp");
  ASSERT_EQ(paper.sheet.creases().size(), 2u);
  EXPECT_EQ(paper.sheet.creases()[0].vertices.size(), 3u);
  EXPECT_EQ(paper.sheet.flatPositions()[paper.sheet.creases()[0].vertices[1]], Vector2(2, 3));
}

TEST(Drawing, whatSticksOutOfThePaperIsCutOff) {
  const FoldPaper paper = readText(kSquare + "2 -0.02 2 4.3 2\n2 0.5 0.5 1 1\n", ".cp");
  EXPECT_NEAR(creaseLength(paper.sheet), 4 + std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(paper.sheet.area(), 16, 1e-12);
  EXPECT_EQ(lowerLeft(paper.sheet.flatPositions()), Vector2(0, 0));
  expectNote(paper, "1 edge that stuck out of the paper ended at its border");
}

TEST(Drawing, creasesThatOverlapALittleAreNoContradiction) {
  const std::string mountain = kSquare + "2 0 2 2 2\n";
  EXPECT_EQ(readText(mountain + "3 1.99 2 4 2\n", ".cp").sheet.creases().size(), 2u);
  expectWithin(fileRefusal(scratch(mountain + "3 1.9 2 4 2\n", ".cp")),
               "line 5 and line 6 lie on each other, but fold differently");
}

TEST(Drawing, linesOnEachOtherAreOne) {
  // A border drawn twice, in parts; a crease twice; a crease and an auxiliary line on the border.
  const std::string twice =
      kSquare + "1 1 0 4 0\n1 4 0 4 3\n2 0 0 4 4\n2 1 1 3 3\n3 0 0 0 4\n4 4 1 4 2\n";
  const FoldPaper paper = readText(twice, ".cp");
  EXPECT_NEAR(paper.sheet.area(), 16, 1e-12);
  EXPECT_EQ(paper.sheet.creases().size(), 1u);
  expectNote(paper, "lie on others at least in part");
  // An auxiliary line goes on where a crease ends.
  EXPECT_EQ(readText(kSquare + "4 0 2 4 2\n2 1 2 3 2\n", ".cp").sheet.creases().size(), 1u);
}

TEST(Drawing, withoutABorderWhatSurroundsAllEdgesIsOne) {
  // A square of creases with a cross in it, and a line within that touches nothing.
  for (const double max_edge : {0.0, 0.7}) {
    const FoldPaper paper =
        readText("2 0 0 4 0\n2 4 0 4 4\n3 4 4 0 4\n4 0 4 0 0\n2 0 2 4 2\n3 2 0 2 4\n3 3 3 3.5 3\n",
                 ".cp", max_edge);
    EXPECT_NEAR(paper.sheet.area(), 16, 1e-12);
    EXPECT_NEAR(creaseLength(paper.sheet), 8.5, 1e-12);
    expectNote(paper, "it has no border");
  }
  json document = diagonal();
  document["edges_assignment"] = {"M", "M", "F", "U", "V"};
  document.erase("faces_vertices");
  const FoldPaper paper = read(document);
  EXPECT_EQ(area(paper), 1);
  EXPECT_EQ(paper.sheet.creases().size(), 1u);
  document["edges_vertices"].erase(3);
  document["edges_assignment"].erase(3);
  expectWithin(refusal(document), "edges_vertices[2] from vertex 2 to vertex 3 lies off the paper");
}

TEST(Drawing, aBorderThatEndsInThePaperIsACut) {
  const std::string crease = "2 0 2 4 2\n";
  // From the border inwards, within the paper, and a closed line, which is a hole.
  EXPECT_NEAR(borderLength(readText(kSquare + crease + "1 1 0 1 1\n", ".cp").sheet), 16 + 2, 1e-12);
  EXPECT_NEAR(borderLength(readText(kSquare + "1 1 1 2 1\n1 2 1 2 2\n", ".cp").sheet), 16 + 4,
              1e-12);
  const FoldPaper hole = readText(kSquare + "1 1 1 2 1\n1 2 1 2 2\n1 2 2 1 1\n", ".cp");
  EXPECT_NEAR(hole.sheet.area(), 15.5, 1e-12);
  // Green around all is border, green inside a cut.
  const std::string green =
      "<svg stroke='#0f0'><polygon points='0,0 4,0 4,4 0,4'/><path d='M1 1 2 1V2'/></svg>";
  EXPECT_NEAR(borderLength(readText(green, ".svg").sheet), 16 + 4, 1e-12);
}

TEST(Drawing, auxiliaryLinesLeaveNoVerticesOnAFinerMesh) {
  const std::string aux = "4 1 0 1 4\n4 1.01 0 1.01 4\n";
  EXPECT_EQ(readText(kSquare + "2 0 2 4 2\n" + aux, ".cp", 0.5).sheet.flatPositions(),
            readText(kSquare + "2 0 2 4 2\n", ".cp", 0.5).sheet.flatPositions());
  EXPECT_GT(readText(kSquare + "2 0 2 4 2\n" + aux, ".cp").sheet.vertexCount(),
            readText(kSquare + "2 0 2 4 2\n", ".cp").sheet.vertexCount());
}

TEST(Drawing, theLowerLeftCornerIsTheOrigin) {
  const Sheet sheet = readText("1 -5 7 3 7\n1 3 7 3 3\n1 3 3 -5 3\n1 -5 3 -5 7\n", ".cp").sheet;
  EXPECT_EQ(sheet.flatPositions()[0], Vector2(0, 0));
  EXPECT_EQ(sheet.flatPositions()[2], Vector2(8, 4));
}

TEST(Drawing, widthStandsForAScale) {
  const std::string path = scratch(kSquare, ".cp");
  EXPECT_NEAR(readPatternFile(path, {0, 0, FoldForm::kFolded, 0.1}).sheet.area(), 0.01, 1e-15);
  expectWithin(fileRefusal(path, {0, 0}),
               path + ": states no physical unit: give a scale in meters per unit, or a width");
  expectWithin(fileRefusal(path, {1, 0, FoldForm::kFolded, 0.1}), "a scale and a width");
  expectWithin(fileRefusal(path, {0, 0, FoldForm::kFolded, -1}), "width is -1");
  expectWithin(fileRefusal(path, {0, 0, FoldForm::kFolded, kNan}), "width is nan");
  json document = diagonal();
  document["frame_unit"] = "cm";
  EXPECT_NEAR(readPatternFile(scratch(document.dump()), {0, 0, FoldForm::kFolded, 2}).sheet.area(),
              4, 1e-12);
}

TEST(Drawing, aFoldedFormWithoutVerticesAtCrossingsIsPassedOver) {
  json document = diagonal();
  document["edges_vertices"].push_back({1, 3});
  document["edges_assignment"].push_back("M");
  document.erase("faces_vertices");
  document["frame_classes"] = {"creasePattern"};
  document["file_frames"] = json::array({{{"frame_inherit", true},
                                          {"frame_classes", {"foldedForm"}},
                                          {"vertices_coords", document["vertices_coords"]}}});
  const FoldPaper paper = read(document);
  EXPECT_FALSE(paper.positions);
  expectNote(paper, "file_frames[0] was passed over");
}

TEST(Drawing, formatsAreToldByTheirExtensions) {
  EXPECT_EQ(fileRefusal(scratch("\xef\xbb\xbf" + kSquare + "\r\n  \r\n3 0 0\t4 4\r\n", ".CP")), "");
  EXPECT_EQ(fileRefusal(scratch(drawnWith(""), ".Svg")), "");
  EXPECT_EQ(fileRefusal(scratch(diagonal().dump(), ".json")), "");
  EXPECT_EQ(fileRefusal(dataPath("70_ff-pinwheel.opx")), "");
}

TEST(Svg, colorsAndOpacitiesAreKindsAndAngles) {
  const struct {
    const char* style;
    double angle;
  } styles[] = {{"stroke='red'", -M_PI},
                {"stroke='#F00' opacity='0.5'", -M_PI / 2},
                {"stroke='#ff0000' stroke-opacity='25%'", -M_PI / 4},
                {"style='stroke:rgb(255, 0, 0); opacity: .5; stroke-opacity: 0.5'", -M_PI / 4},
                {"stroke='#ED1C24'", -M_PI},
                {"stroke='red' opacity='0'", 0},
                {"stroke='blue'", M_PI},
                {"stroke='rgb(0%,0%,100%)' opacity='1'", M_PI},
                {"stroke='black' style='stroke : #00f'", M_PI},
                {"stroke='magenta'", kNan},
                {"class='a v'", M_PI},
                {"class='v' style='stroke:red'", -M_PI}};
  for (const auto& [style, angle] : styles) {
    const FoldPaper paper = readText(
        drawnWith(
            "<style>.b{} .v { stroke: #00f } /* .v {stroke: red} */</style>\n<line x2='4' y2='4' " +
            std::string(style) + "/>"),
        ".svg");
    ASSERT_EQ(paper.sheet.creases().size(), 1u) << style;
    EXPECT_TRUE(paper.notes.empty()) << style;
    if (std::isnan(angle)) {
      EXPECT_TRUE(std::isnan(patternAngles(paper)[0])) << style;
    } else {
      EXPECT_NEAR(patternAngles(paper)[0], angle, 1e-15) << style;
      EXPECT_FALSE(angle == 0 && std::signbit(patternAngles(paper)[0])) << style;
    }
  }
  for (const char* none : {"", "stroke='none'", "stroke='yellow'", "stroke='red' display='none'",
                           "stroke='red' visibility='hidden'"}) {
    const FoldPaper paper =
        readText(drawnWith("<line x2='4' y2='4' " + std::string(none) + "/>"), ".svg");
    EXPECT_TRUE(paper.sheet.creases().empty()) << none;
  }
}

TEST(Svg, groupsHandDownTheirStyleAndTransform) {
  const FoldPaper paper = readText(
      drawnWith("<g stroke='blue' opacity='0.5' transform='translate(1,2)'>\n"
                "<g transform='rotate(90 1 0) scale(2, 1)' opacity='.5'><line x2='1'/></g>\n"
                "<g display='none'><g display='inline'><line x2='1'/></g></g></g>"),
      ".svg");
  ASSERT_EQ(paper.sheet.creases().size(), 1u);
  EXPECT_NEAR(patternAngles(paper)[0], M_PI / 4, 1e-15);
  // (0, 0) and (1, 0) become (0, 0) and (2, 0), (1, -1) and (1, 1), (2, 1) and (2, 3); y turns.
  const Crease& crease = paper.sheet.creases()[0];
  const Vector2 from = paper.sheet.flatPositions()[crease.vertices.front()],
                to = paper.sheet.flatPositions()[crease.vertices.back()];
  EXPECT_LT((from - Vector2(2, 3)).norm(), 1e-12);
  EXPECT_LT((to - Vector2(2, 1)).norm(), 1e-12);
}

TEST(Svg, pathsAreReadInEveryNotation) {
  for (const char* path :
       {"M1 1 L3 1 L3 3 Z", "m1,1 2,0 0,2z", "M1 1H3V3L1 1", "M1 1h2v2l-2-2",
        "M 1.0e0.1e1 h+2.v2 Z", "M1 1 3 1M3,1v2 M3 3 1 1", "m 1 1 h 1 1 v 1 l 0 1 -2 -2"}) {
    const FoldPaper paper =
        readText(drawnWith("<path stroke='red' d='" + std::string(path) + "'/>"), ".svg");
    EXPECT_NEAR(creaseLength(paper.sheet), 4 + std::sqrt(8), 1e-12) << path;
    EXPECT_EQ(paper.sheet.creases().size(), 3u) << path;
  }
}

TEST(Svg, whatIsPassedOverIsTold) {
  const FoldPaper paper =
      readText(drawnWith("<line x2='4' y2='4' stroke='#808080'/><circle r='3' stroke='red'/>"
                         "<text stroke='red'>x</text><line x2='4' y2='4' stroke='url(#a)'/>"),
               ".svg");
  expectNote(paper,
             "lines of other colors than those of creases were passed over: #808080, url(#a)");
  expectNote(paper, "elements that are not straight lines were passed over: circle, text");
}

TEST(Svg, entitiesAreNotExpanded) {
  std::string text = "<!DOCTYPE svg [\n<!ENTITY a0 \"red\">\n";
  for (int i = 1; i < 30; ++i) {
    text += "<!ENTITY a" + std::to_string(i) + " \"";
    for (int k = 0; k < 10; ++k) text += "&a" + std::to_string(i - 1) + ";";
    text += "\">\n";
  }
  text += "]>\n" + drawnWith("<line x2='4' y2='4' stroke='&a29;'/><text>&a29;</text>");
  expectNote(readText(text, ".svg"), "passed over: &a29;");
}

TEST(Drawing, whatIsTooLargeIsRefusedAtOnce) {
  const auto seconds = [](const auto& action) {
    const auto start = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (const char* extension : {".fold", ".cp", ".opx", ".svg"}) {
    const std::string path = scratch("", extension);
    std::filesystem::resize_file(path, 100000000);  // takes no room on the disk
    std::string message;
    EXPECT_LT(seconds([&] { message = fileRefusal(path); }), 1) << extension;
    expectWithin(message, path + ": cannot be read: it has 100000000 bytes, more than the ");
  }
  std::string deep;
  for (int i = 0; i < 200000; ++i) deep += "<g>";
  expectWithin(fileRefusal(scratch(drawnWith(deep), ".svg")), "nest too deep in line 3");
  std::string many;
  for (int i = 0; i < 100001; ++i) many += "2 0 0 4 " + std::to_string(i) + "\n";
  expectWithin(fileRefusal(scratch(many, ".cp")), "holds more than 100000 lines");
}

}  // namespace
}  // namespace shell_origami
