#include <shell_origami/sheet/vertex_grid.h>

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/pins.h>
#include "test/sheet/random_sheets.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace shell_origami {
namespace {

TEST(VertexGrid, findsTheVertexThatAComparisonOfAllFinds) {
  RandomSheets random(3);
  for (int i = 0; i < 10; ++i) {
    const Sheet sheet(random.mesh(0.02));
    const VertexGrid grid(sheet);
    for (int k = 0; k < 300; ++k) {
      const Vector2 p(random.between(-0.1, 0.3), random.between(-0.1, 0.3));
      EXPECT_EQ(grid.nearest(p), sheet.nearestVertex(p));
    }
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      EXPECT_EQ(grid.nearest(sheet.flatPositions()[v]),
                sheet.nearestVertex(sheet.flatPositions()[v]));
    }
  }
}

TEST(VertexGrid, aStripFewCellsHigh) {
  const Sheet sheet(triangulateRectangle(1, 0.001, 0.01));
  const VertexGrid grid(sheet);
  for (int i = 0; i <= 1000; ++i) {
    const Vector2 p(0.001 * i, 0.0004);
    EXPECT_EQ(grid.nearest(p), sheet.nearestVertex(p));
  }
}

TEST(Pins, aQuarterOfAMillionPointsAreFoundOneByOne) {
  // A search through all triangles for each would take minutes.
  const Sheet sheet(triangulateRectangle(0.15, 0.15, 0.0015));
  const Positions none;
  std::vector<Vector2> points;
  for (int x = 0; x < 500; ++x) {
    for (int y = 0; y < 500; ++y) points.emplace_back(0.0003 * x, 0.0003 * y);
  }
  EXPECT_EQ(static_cast<int>(verticesAt(points, sheet, none).size()), sheet.vertexCount());
  points.emplace_back(0.1500002, 0.1);
  EXPECT_THROW(verticesAt(points, sheet, none), std::invalid_argument);
}

}  // namespace
}  // namespace shell_origami
