/// Malformed texts of every format: each is rejected with a message that names file and place.
#include "test/fold_format/fold_samples.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace shell_origami {
namespace {

struct Malformed {
  std::string text;
  const char* place;  ///< part of the message
};

void expectRejected(const std::vector<Malformed>& cases, const std::string& extension) {
  EXPECT_GE(cases.size(), 30u);
  for (const auto& [text, place] : cases) {
    const std::string path = scratch(text, extension);
    const std::string message = fileRefusal(path);
    expectWithin(message, place);
    EXPECT_EQ(message.rfind(path + ": ", 0), 0u) << message;
    EXPECT_LT(message.size(), path.size() + 300) << message;
  }
}

/// The square with a diagonal, with one entry changed.
std::string changed(const char* pointer, const json& value) {
  json document = diagonal();
  document[json::json_pointer(pointer)] = value;
  return document.dump();
}

TEST(Malformed, fold) {
  const json nested = json::array({json::array({json::array({0, 1})})});
  expectRejected(
      {{"", "line 1"},
       {"\n\n{\"vertices_coords\": [[0, 0], }", "line 3"},
       {"{\"vertices_coords\": [[NaN, 0]]}", "line 1"},
       {"{\"vertices_coords\": [[Infinity, 0]]}", "line 1"},
       {"{\"vertices_coords\": [[1e999, 0]]}", "a number is out of range"},
       {"{\"vertices_coords\": [[0, 0]]} {}", "line 1"},
       {"{'vertices_coords': []}", "line 1"},
       {std::string("{\"a\": \"\0\"}", 10), "line 1"},
       {"\xff\xfe{\0}\0", "line 1"},
       {std::string(1000000, '['), "nest deeper than 100"},
       {"[]", "no object"},
       {"7", "no object"},
       {"{\"vertices_coords\": []}", "vertices_coords"},
       {changed("/vertices_coords", "x"), "vertices_coords is no list"},
       {changed("/faceOrders", 1), "faceOrders is no list"},
       {changed("/faceOrders", json::array({json::array({0, 2, 1})})), "faceOrders[0]"},
       {changed("/faceOrders", json::array({json::array({0, 1, 2})})), "faceOrders[0]"},
       {changed("/faceOrders", json::array({json::array({0, 1})})), "faceOrders[0]"},
       {changed("/vertices_coords/1", json::array()), "vertices_coords[1]"},
       {changed("/vertices_coords/1", {1, 2, 3, 4}), "vertices_coords[1]"},
       {changed("/vertices_coords/1/0", "1"), "vertices_coords[1] is \"1\", not a number"},
       {changed("/vertices_coords/1/0", nested), "vertices_coords[1] is a list of 1"},
       {changed("/vertices_coords/1/0", 1e100), "vertices_coords[1] has a coordinate"},
       {changed("/edges_vertices", 7), "edges_vertices is no list"},
       {changed("/edges_vertices/2", nullptr), "edges_vertices[2] is null"},
       {changed("/edges_vertices/2", {0, 1, 2}), "edges_vertices[2] is a list of 3"},
       {changed("/edges_vertices/2", {0, "1"}), "edges_vertices[2] holds \"1\""},
       {changed("/edges_vertices/2", {0, 4}), "edges_vertices[2] names vertex 4"},
       {changed("/edges_vertices/2", {0, 1e30}), "edges_vertices[2]"},
       {changed("/edges_assignment/2", "BB"), "edges_assignment[2] is \"BB\""},
       {changed("/edges_assignment/2", "b"), "edges_assignment[2] is \"b\""},
       {changed("/edges_assignment/5", "B"), "edges_assignment has 6 entries for 5 edges"},
       {changed("/edges_foldAngle", {0, 0, 0, 0, "x"}), "edges_foldAngle[4]"},
       {changed("/edges_foldAngle", {0, 0, 0, 0, 1e300}), "edges_foldAngle[4]"},
       {changed("/faces_vertices/0", {0, 1}), "faces_vertices[0]"},
       {changed("/faces_vertices/0", {0, 1, -2}), "faces_vertices[0] names vertex -2"},
       {changed("/faces_vertices/1", {0, 1, 2, 3, 1}), "edges_vertices[0]"},
       {changed("/frame_unit", 3), "frame_unit is 3"},
       {changed("/file_frames", {{{"frame_inherit", true}, {"frame_parent", "x"}}}),
        "file_frames[0] has frame_parent \"x\""},
       {changed("/file_frames", {{{"frame_inherit", true}, {"frame_parent", -1}}}),
        "file_frames[0] has frame_parent -1"}},
      ".fold");
}

TEST(Malformed, cp) {
  const std::string square = "1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n";
  expectRejected({{"1", "line 1 does not hold five numbers"},
                  {"1 0 0 1", "line 1 does not hold five numbers"},
                  {"1 0 0 1 0 0", "line 1 does not hold five numbers"},
                  {"1 0 0 1 0 # border", "line 1 does not hold five numbers"},
                  {"1,0,0,1,0", "line 1 does not hold five numbers"},
                  {square + "\n\r\n2 0 0", "line 7 does not hold"},
                  {"{\"vertices_coords\": []}", "line 1 does not hold"},
                  {"5 0 0 1 0", "line 1 has type 5"},
                  {"-1 0 0 1 0", "line 1 has type -1"},
                  {"1.5 0 0 1 0", "line 1 has type 1.5"},
                  {"1e20 0 0 1 0", "line 1 has type 1e+20"},
                  {square + "9 0 0 1 0", "line 5 has type 9"},
                  {"x 0 0 1 0", "line 1 holds 'x'"},
                  {"M 0 0 1 0", "line 1 holds 'M'"},
                  {"1 nan 0 1 0", "line 1 holds 'nan'"},
                  {"1 0 NaN 1 0", "line 1 holds 'NaN'"},
                  {"1 0 0 inf 0", "line 1 holds 'inf'"},
                  {"1 0 0 1 -inf", "line 1 holds '-inf'"},
                  {"1 0 0 1 infinity", "line 1 holds 'infinity'"},
                  {"1 1e999 0 1 0", "line 1 holds '1e999'"},
                  {"1 1e100 0 1 0", "line 1 has a coordinate"},
                  {"1 0 0 -1e300 0", "line 1 has a coordinate"},
                  {"1 0x10 0 1 0", "line 1 holds '0x10'"},
                  {"1 0 0,5 1 0", "line 1 holds '0,5'"},
                  {"1 0 0 1 1e", "line 1 holds '1e'"},
                  {"1 0 0 1 1e+", "line 1 holds '1e+'"},
                  {"1 0 0 1 .", "line 1 holds '.'"},
                  {"1 0 0 1 -", "line 1 holds '-'"},
                  {"1 0 0 1 1.2.3", "line 1 holds '1.2.3'"},
                  {"1 0 0 1 --1", "line 1 holds '--1'"},
                  {"1 0 0 1 " + std::string(100000, '1'), "line 1 holds '1111"},
                  {square + std::string("2 0 0 1 1\0", 10), "line 5 holds a zero byte"},
                  {"\xff\xfe 0 0 1 0", "line 1 holds"},
                  {"", "holds no lines"},
                  {" \n\r\n\t\n", "holds no lines"},
                  {"2 1 1 1 1", "enclose no paper"},
                  {"2 0 0 1 1\n3 1 1 2 0", "enclose no paper"},
                  {"1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4", "the outline ends at a point of line"},
                  {square + "1 4 4 8 4\n1 8 4 8 8\n1 8 8 4 8\n1 4 8 4 4\n",
                   "the outline meets itself at a point of line 2"},
                  {square + "2 0 0 4 4\n3 1 1 3 3", "line 5 and line 6 lie on each other"},
                  {square + "2 5 5 6 6", "line 5 lies off the paper"},
                  {square + "1 0 2 4 2", "the outline meets itself at a point of line"}},
                 ".cp");
}

TEST(Malformed, opx) {
  const auto object = [](const std::string& properties) {
    return "<java>\n<object class='oripa.OriLineProxy'>\n" + properties + "\n</object></java>";
  };
  const auto property = [](const std::string& name, const std::string& value) {
    return "<void property='" + name + "'><double>" + value + "</double></void>";
  };
  const std::vector<Malformed> cases{
      {"", "line 1"},
      {"1 0 0 1 0", "line 1"},
      {"<java>", "line 1"},
      {"<java/>", "holds no lines"},
      {object("<void property='type'/>"), "<void> in line 3 is no property with a value"},
      {object("<void><int>1</int></void>"), "<void> in line 3 is no property with a value"},
      {object(property("type", "7")), "<object> in line 2 has type 7"},
      {object(property("type", "")), "<double> in line 3 holds ''"},
      {object(property("x0", "nan")), "<double> in line 3 holds 'nan'"},
      {object(property("y1", "1e999")), "<double> in line 3 holds '1e999'"},
      {object(property("y1", "1e200")), "<object> in line 2 has a coordinate"},
      {object(property("x0", "&lt;")), "<double> in line 3 holds '<'"}};
  for (const auto& [text, place] : cases) {
    expectWithin(fileRefusal(scratch(text, ".opx")), place);
  }
}

/// A drawing with a border of 4 x 4 units and an element in line 3.
std::string svg(const std::string& element) {
  return "<svg>\n<rect width='4' height='4' stroke='#000'/>\n" + element + "\n</svg>\n";
}

std::string path(const std::string& data) { return svg("<path stroke='red' d='" + data + "'/>"); }

TEST(Malformed, svg) {
  const std::string line = "<line stroke='red' x2='1' y2='1' ";
  expectRejected(
      {{"", "line 1"},
       {"M 0 0 L 1 1", "line 1"},
       {"<svg", "line 1"},
       {"<svg>\n<g>\n</svg>", "is not XML from line 2"},
       {"<svg>\n<line x1='0'\n</svg>", "is not XML from line"},
       {"<svg>\n<!-- ", "is not XML from line 2"},
       {"<svg a='1' a='2'", "line 1"},
       {"<svg a=1></svg>", "line 1"},
       {std::string("<svg>\n\0</svg>", 13), "line 2 holds a zero byte"},
       {"<html>\n<svg/></html>", "<html> in line 1 is its root"},
       {"<svg/>", "holds no lines"},
       {"<svg><circle r='3' stroke='red'/></svg>", "holds no lines"},
       {svg(line + "x1='a'/>"), "<line> in line 3 has x1 'a'"},
       {svg(line + "x1=''/>"), "<line> in line 3 has x1 ''"},
       {svg(line + "x1='nan'/>"), "<line> in line 3 has x1 'nan'"},
       {svg(line + "y1='-inf'/>"), "<line> in line 3 has y1 '-inf'"},
       {svg(line + "y1='1e999'/>"), "<line> in line 3 has y1 '1e999'"},
       {svg(line + "y1='1e200'/>"), "<line> in line 3 has a coordinate"},
       {svg(line + "x1='5mm'/>"), "<line> in line 3 has x1 '5mm'"},
       {svg(line + "x1='50%'/>"), "<line> in line 3 has x1 '50%'"},
       {svg(line + "x1='1 2'/>"), "<line> in line 3 has x1 '1 2'"},
       {svg(line + "x1='" + std::string(100000, 'x') + "'/>"), "<line> in line 3 has x1 'xxx"},
       {svg("<rect stroke='red' x='1'/>"), "<rect> in line 3 has no positive width"},
       {svg("<rect stroke='red' width='-1' height='1'/>"), "<rect> in line 3"},
       {svg("<rect stroke='red' width='1' height='auto'/>"), "<rect> in line 3 has height 'auto'"},
       {svg("<polyline stroke='red'/>"), "<polyline> in line 3 has fewer than two points"},
       {svg("<polyline stroke='red' points='1,1'/>"), "<polyline> in line 3 has fewer"},
       {svg("<polyline stroke='red' points='1,1 2'/>"), "<polyline> in line 3 has points"},
       {svg("<polyline stroke='red' points='1,1 a,b'/>"), "from 'a,b' on"},
       {svg("<polygon stroke='red' points='0 0 1 1 nan 1'/>"), "from 'nan 1' on"},
       {path("1 1 L 2 2"), "<path> in line 3 holds no command before '1 1 L 2 2'"},
       {path("L 1 1"), "<path> in line 3 holds 'L' before it has moved"},
       {path("Z"), "<path> in line 3 holds 'Z' before it has moved"},
       {path("M 1 1 C 1 2 2 1 2 2"), "<path> in line 3 holds a curve (C)"},
       {path("M 1 1 a 1 1 0 0 1 1 1"), "<path> in line 3 holds a curve (a)"},
       {path("M 1 1 X 2 2"), "<path> in line 3 holds the unknown command 'X'"},
       {path("M 1 1 L 2"), "<path> in line 3 lacks a finite number for L at its end"},
       {path("M"), "<path> in line 3 lacks a finite number for M at its end"},
       {path("M 1 1 L 2 #"), "lacks a finite number for L before '#'"},
       {path("M 1 1 L 1e999 2"), "lacks a finite number for L before '1e999 2'"},
       {path("M 1 1 L nan 2"), "lacks a finite number for L before 'nan 2'"},
       {path("M 1 1 h"), "lacks a finite number for h at its end"},
       {path("M 1 1 L 2 2 Z 3"), "<path> in line 3 holds no command before '3'"},
       {svg(line + "transform='skewX(3)'/>"), "<line> in line 3 has the transform 'skewX(3)'"},
       {svg(line + "transform='rotate(1 2)'/>"), "<line> in line 3 has the transform"},
       {svg(line + "transform='matrix(1 0 0 1)'/>"), "<line> in line 3 has the transform"},
       {svg(line + "transform='translate(1'/>"), "<line> in line 3 has the transform"},
       {svg(line + "transform='scale(inf)'/>"), "<line> in line 3 has the transform"},
       {svg(line + "transform='1 2'/>"), "<line> in line 3 has the transform"},
       {svg("<g transform='scale()'/>"), "<g> in line 3 has the transform"},
       {svg("<g opacity='2'/>"), "<g> in line 3 has opacity '2'"},
       {svg(line + "opacity='x'/>"), "<line> in line 3 has opacity 'x'"},
       {svg(line + "style='stroke-opacity: -1'/>"), "<line> in line 3 has stroke-opacity '-1'"},
       {svg(line + "stroke-opacity='nan'/>"), "<line> in line 3 has stroke-opacity 'nan'"},
       {svg("<line stroke='red' x2='4' y2='4'/>\n<line stroke='blue' x2='4' y2='4'/>"),
        "<line> in line 3 and <line> in line 4 lie on each other, but fold differently"},
       {svg("<line stroke='red' x1='5' x2='6' y2='1'/>"), "<line> in line 3 lies off the paper"},
       {"<svg stroke='black'>\n<path d='M0 0H4V4H0'/></svg>",
        "the outline ends at a point of <path>"}},
      ".svg");
}

}  // namespace
}  // namespace shell_origami
