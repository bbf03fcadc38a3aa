/// Random folds made while the paper is folding: the sheet stays whole, and the paper stays where
/// it is in space.
#include "origami/simulation.h"
#include "sheet/triangulate.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace shell_origami {
namespace {

/// Where points of the flat sheet are in space.
struct Material {
  Sheet sheet;
  Positions positions;

  Vector3 at(const Vector2& flat) const {
    const auto place = sheet.triangulation().locate(flat, 1e-6 * sheet.size());
    const Triangle& t = sheet.triangles()[place->triangle];
    Vector3 point = Vector3::Zero();
    for (int k = 0; k < 3; ++k) point += place->weights[k] * positions.col(t[k]);
    return point;
  }
};

TEST(EditsOnFoldedPaper, LeaveItWholeAndWhereItIs) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr double kMaxEdge = 0.02;
  int folds = 0, points = 0, moved = 0;
  double farthest = 0;
  while (folds < 60) {
    const double width = 0.1 + 0.1 * unit(random), height = 0.1 + 0.1 * unit(random);
    Simulation simulation(Sheet(triangulateRectangle(width, height, kMaxEdge)), {});
    for (int i = 0; i < 4; ++i) {
      FoldRequest request;
      request.where = Line{Vector2(width * unit(random), height * unit(random)),
                           Vector2(width * unit(random), height * unit(random))};
      request.angle = (2 * unit(random) - 1) * 175 * M_PI / 180;
      request.duration = 0.3;
      const Material before{simulation.sheet(), simulation.positions()};
      simulation.fold(request);
      ++folds;
      ASSERT_NO_THROW(simulation.sheet().validate());
      ASSERT_NEAR(simulation.sheet().area() / (width * height), 1, 1e-12);
      const Material after{simulation.sheet(), simulation.positions()};
      for (const Vector2& flat : before.sheet.flatPositions()) {
        const double distance = (after.at(flat) - before.at(flat)).norm();
        farthest = std::max(farthest, distance);
        ++points;
        moved += distance > 1e-9 * width;
      }
      for (int k = 0; k < 6; ++k) ASSERT_TRUE(simulation.step().converged);
      for (const Triangle& t : simulation.sheet().triangles()) {
        const Vector3 a = simulation.positions().col(t[0]);
        const double area = (Vector3(simulation.positions().col(t[1])) - a)
                                .cross(Vector3(simulation.positions().col(t[2])) - a)
                                .norm();
        ASSERT_GT(area, 0);
      }
    }
  }
  // Only where an edge was flipped or a vertex shifted on paper that is bent there, by 0.02 rad at
  // most: a quarter of the quadrilateral's diagonal times that, once for each flip on top of
  // another, of which four are seen.
  EXPECT_LT(farthest, 4 * 0.25 * std::sqrt(3.0) * kMaxEdge * 0.02);
  EXPECT_LT(moved, points / 20);
  RecordProperty("moved_points", moved);
  RecordProperty("farthest_um", static_cast<int>(farthest * 1e6));
}

}  // namespace
}  // namespace shell_origami
