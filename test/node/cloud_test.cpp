// Points of flat and of folded sheets: that they are evenly spread, that they stay the same while
// the sheet is divided anew, and what a cloud says of them.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/node/sense/cloud.h>
#include <shell_origami/sheet/fold_line.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

Sheet rectangle() { return Sheet(triangulateRectangle(0.2, 0.1, 0.02)); }

/// An L whose corner is at the origin, with a square hole.
Sheet angular() {
  PlanarGraph graph;
  graph.points = {{0, 0},   {0.1, 0},     {0.1, 0.04},  {0.04, 0.04}, {0.04, 0.1},
                  {0, 0.1}, {0.01, 0.01}, {0.03, 0.01}, {0.03, 0.03}, {0.01, 0.03}};
  graph.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {6, 7}, {7, 8}, {8, 9}, {9, 6}};
  graph.holes = {{0.02, 0.02}};
  return Sheet(triangulate(graph, 0.01));
}

void expectInTheirTriangles(const std::vector<MaterialPoint>& points, const Sheet& sheet) {
  Positions flat = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) flat.col(v).head<2>() = sheet.flatPositions()[v];
  for (const MaterialPoint& point : points) {
    EXPECT_GE(point.place.weights.minCoeff(), -1e-9);
    // Rounding of coordinates of 0.2 m.
    EXPECT_LT((inSpace(point, sheet, flat).head<2>() - point.flat).norm(), 1e-15);
  }
}

TEST(MaterialPoints, FormALattice) {
  const Sheet sheet = rectangle();
  const std::vector<MaterialPoint> points = sampleSheet(sheet, 5000);
  ASSERT_EQ(points.size(), 5000u);
  expectInTheirTriangles(points, sheet);
  for (int row = 0; row < 50; ++row) {
    for (int column = 0; column < 100; ++column) {
      const Vector2 wanted = 0.002 * Vector2(column + 0.5, row + 0.5);
      EXPECT_LT((points[100 * row + column].flat - wanted).norm(), 1e-15);
    }
  }
}

TEST(MaterialPoints, AreAsManyAsWanted) {
  const Sheet sheet = rectangle();
  for (const double count : {1.0, 10.0, 123.0, 7777.0, 2e5}) {
    const std::vector<MaterialPoint> points = sampleSheet(sheet, count);
    // The last row and the last column may be there or not: half of each is on the average.
    const double spacing = std::sqrt(0.02 / count);
    EXPECT_NEAR(points.size(), count, 1 + 0.5 * 0.3 / spacing) << count;
  }
}

TEST(MaterialPoints, KeepToThePaper) {
  const Sheet sheet = angular();
  const double area = 0.1 * 0.04 + 0.04 * 0.06 - 0.02 * 0.02;
  const std::vector<MaterialPoint> points = sampleSheet(sheet, area / 0.0005 / 0.0005);
  EXPECT_EQ(points.size(), 24000u);
  expectInTheirTriangles(points, sheet);
  for (const MaterialPoint& point : points) {
    const Vector2& p = point.flat;
    EXPECT_GT((p - Vector2(0.02, 0.02)).cwiseAbs().maxCoeff(), 0.01);
    EXPECT_LT(std::min(p.x(), p.y()), 0.04);
  }
}

/// Points at 2 mm, 6 mm and so on: at 10 and at 30 mm they are on the border of the hole.
TEST(MaterialPoints, OnABorderAreOnPaper) {
  const Sheet sheet = angular();
  expectInTheirTriangles(sampleSheet(sheet, sheet.area() / 0.004 / 0.004), sheet);
}

TEST(MaterialPoints, AreTheSameAfterFolds) {
  Sheet sheet = rectangle();
  const std::vector<MaterialPoint> before = sampleSheet(sheet, 10000);
  // Along a column of points, across, and from inside the paper.
  const std::vector<Segment> lines = {Segment{Vector2(0.0212132, 0), Vector2(0.0212132, 0.1)},
                                      Segment{Vector2(0, 0.013), Vector2(0.2, 0.087)},
                                      Segment{Vector2(0.05, 0.05), Vector2(0.2, 0.1)}};
  for (const Segment& line : lines) {
    makeFoldLine(sheet, line, "fold");
    const std::vector<MaterialPoint> after = sampleSheet(sheet, 10000);
    expectInTheirTriangles(after, sheet);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i].flat, before[i].flat);
  }
}

using CloudPoint = std::array<float, 9>;

std::vector<CloudPoint> pointsOf(const sensor_msgs::PointCloud2& cloud) {
  EXPECT_EQ(cloud.point_step, sizeof(CloudPoint));
  EXPECT_EQ(cloud.data.size(), cloud.row_step);
  std::vector<CloudPoint> points(cloud.width);
  EXPECT_EQ(cloud.data.size(), points.size() * sizeof(CloudPoint));
  std::memcpy(points.data(), cloud.data.data(), cloud.data.size());
  return points;
}

TEST(Cloud, ShowsBothSidesOfFoldedPaper) {
  Sheet sheet = rectangle();
  makeFoldLine(sheet, Segment{Vector2(0.1, 0), Vector2(0.1, 0.1)}, "fold");
  // A valley of 1.1 rad: the right half rises.
  const Eigen::AngleAxisd turn(1.1, -Vector3::UnitY());
  const auto place = [&](const Vector2& p) {
    const Vector3 from_crease(p.x() - 0.1, p.y(), 0);
    return p.x() > 0.1 ? Vector3(turn * from_crease) : from_crease;
  };
  Positions positions(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    positions.col(v) = place(sheet.flatPositions()[v]);
  }
  sensor_msgs::PointCloud2 cloud;
  // A message that was used before is written anew.
  for (const int count : {2000, 1000}) {
    writeCloud(sampleSheet(sheet, count), sheet, positions, cloud);
  }
  std::string names;
  for (const auto& field : cloud.fields) names += field.name + " ";
  EXPECT_EQ(names, "x y z normal_x normal_y normal_z u v side ");
  const std::vector<CloudPoint> points = pointsOf(cloud);
  ASSERT_GT(points.size(), 1900u);
  const std::size_t half = points.size() / 2;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CloudPoint& p = points[i];
    const Vector2 flat(p[6], p[7]);
    const double sign = i < half ? 1 : -1;
    const Vector3 up = flat.x() > 0.1 ? turn * Vector3::UnitZ() : Vector3::UnitZ();
    // Half of the step of float is 7.5e-9 below 0.25 and 3e-8 below 1, in each of three numbers;
    // that of u and v moves the point along the paper as well.
    EXPECT_LT((Vector3(p[0], p[1], p[2]) - place(flat)).norm(), 4e-8);
    EXPECT_LT((Vector3(p[3], p[4], p[5]) - sign * up).norm(), 1e-7);
    EXPECT_EQ(p[8], i < half ? 0 : 1);
    EXPECT_EQ(flat, Vector2(points[i % half][6], points[i % half][7]));
  }
}

}  // namespace
}  // namespace shell_origami
