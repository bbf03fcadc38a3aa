// What each pixel sees of planes, of layers, of paper without order and of bodies is compared with
// the rays' intersections in closed form.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/node/sense/depth_renderer.h>
#include <shell_origami/node/sense/material_points.h>
#include <shell_origami/sheet/fold_line.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

constexpr double kWide = 0.2, kHigh = 0.1;

Sheet sheetOf(double max_edge) { return Sheet(triangulateRectangle(kWide, kHigh, max_edge)); }

Positions placed(const Sheet& sheet, const std::function<Vector3(const Vector2&)>& place) {
  Positions positions(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) positions.col(v) = place(sheet.flatPositions()[v]);
  return positions;
}

struct Seen {
  Vector3 ray;  ///< at depth 1
  float depth, u, v, side;
};

/// What the pixels see, row by row.
std::vector<Seen> look(const PinholeCamera& camera, const Sheet& sheet, const Positions& points,
                       const std::vector<Body>& bodies = {}) {
  DepthRenderer renderer(camera);
  renderer.render(sheet, bodies, points);
  const std::vector<float> depths = renderer.depths(), labels = renderer.labels(sheet, points);
  std::vector<Seen> pixels;
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      const std::size_t i = pixels.size();
      const Vector3 ray((column - (camera.width - 1) / 2.0) / camera.focal_length,
                        (row - (camera.height - 1) / 2.0) / camera.focal_length, 1);
      pixels.push_back({ray, depths[i], labels[3 * i], labels[3 * i + 1], labels[3 * i + 2]});
    }
  }
  return pixels;
}

/// Compares with a paper that lies flat at a pose in the camera's frame.
void expectPlane(const PinholeCamera& camera, double max_edge, const Eigen::Isometry3d& pose) {
  const Sheet sheet = sheetOf(max_edge);
  const auto points =
      placed(sheet, [&](const Vector2& p) { return pose * Vector3(p.x(), p.y(), 0); });
  const Vector3 normal = pose.linear().col(2);
  int seen = 0;
  for (const Seen& pixel : look(camera, sheet, points)) {
    const double depth = normal.dot(pose.translation()) / normal.dot(pixel.ray);
    const Vector3 hit = pose.inverse() * (depth * pixel.ray);
    const double inside = std::min({hit.x(), kWide - hit.x(), hit.y(), kHigh - hit.y()});
    if (std::abs(inside) < 1e-12) continue;  // on the border to rounding
    if (inside < 0 || depth < 0) {
      EXPECT_TRUE(std::isnan(pixel.depth) && std::isnan(pixel.u) && std::isnan(pixel.side));
      continue;
    }
    ++seen;
    // Rounding to float, of depths below 1 m and coordinates below 0.25 m. That of doubles, of
    // triangles of 1e-5 m^2 at 1 m seen under 10 degrees, is a tenth of that.
    EXPECT_NEAR(pixel.depth, depth, 4e-8);
    EXPECT_NEAR(pixel.u, hit.x(), 1e-8);
    EXPECT_NEAR(pixel.v, hit.y(), 1e-8);
    EXPECT_EQ(pixel.side, normal.dot(pixel.ray) < 0 ? kFrontSide : kBackSide);
  }
  EXPECT_GT(seen, camera.width * camera.height / 50);
}

Eigen::Isometry3d poseAt(const Vector3& middle, double angle, const Vector3& axis) {
  return Eigen::Translation3d(middle) * Eigen::AngleAxisd(angle, axis.normalized()) *
         Eigen::Translation3d(-kWide / 2, -kHigh / 2, 0);
}

TEST(DepthRenderer, SeesPlanesWhereTheyAre) {
  const PinholeCamera camera;
  expectPlane(camera, 0.02, poseAt({0, 0, 0.3}, 0, Vector3::UnitX()));
  expectPlane(camera, 0.02, poseAt({0, 0, 0.3}, M_PI, Vector3::UnitX()));
  expectPlane(camera, 0.005, poseAt({0.01, -0.02, 0.4}, 1.0, {1, 2, 3}));
  expectPlane(camera, 0.01, poseAt({0.02, 0.03, 0.35}, 1.4, {0, 1, 0}));
}

TEST(DepthRenderer, HasPixelsOfAnyNumber) {
  for (const int width : {1, 2, 5, 101}) {
    PinholeCamera camera;
    camera.width = width;
    camera.height = width + 2;
    camera.focal_length = 100;
    expectPlane(camera, 0.02, poseAt({0, 0, 0.1}, 0.3, {1, 1, 0}));
  }
}

/// Its triangles reach from behind the camera to far ahead.
TEST(DepthRenderer, SeesPaperThatPassesBelowIt) {
  PinholeCamera camera;
  camera.width = camera.height = 120;
  camera.focal_length = 60;
  camera.near = 0;
  const Eigen::Isometry3d pose =
      Eigen::Translation3d(-0.1, 0.005, -0.02) * Eigen::AngleAxisd(M_PI / 2, Vector3::UnitX());
  expectPlane(camera, 0.1, pose);
  expectPlane(camera, 0.01, pose);
}

TEST(DepthRenderer, SeesTheNearestLayer) {
  Sheet sheet = sheetOf(0.01);
  makeFoldLine(sheet, {Vector2(kWide / 2, 0), Vector2(kWide / 2, kHigh)});
  // The right half lies on the left one, 0.01 mm nearer.
  const auto points = placed(sheet, [](const Vector2& p) {
    const bool folded = p.x() > kWide / 2 + 1e-9;
    return Vector3(folded ? kWide - p.x() : p.x(), p.y(), folded ? 0.29999 : 0.3);
  });
  int on_both = 0;
  for (const Seen& pixel : look(PinholeCamera(), sheet, points)) {
    if (std::isnan(pixel.depth)) continue;
    const double x = pixel.ray.x() * pixel.depth;
    // Beside the crease the upper layer comes down to it.
    if (x > kWide / 2 - 0.02) continue;
    ++on_both;
    EXPECT_NEAR(pixel.depth, 0.29999, 3e-8);
    EXPECT_NEAR(pixel.u, kWide - x, 3e-8);
    EXPECT_EQ(pixel.side, kFrontSide);
  }
  EXPECT_GT(on_both, 20000);
}

TEST(DepthRenderer, MeasuresBetweenNearAndFar) {
  PinholeCamera camera;
  camera.near = 0.25;
  camera.far = 0.35;
  const Sheet sheet = sheetOf(0.02);
  const Eigen::Isometry3d pose = poseAt({0, 0, 0.3}, 1.2, Vector3::UnitY());
  const auto points =
      placed(sheet, [&](const Vector2& p) { return pose * Vector3(p.x(), p.y(), 0); });
  int near = 0, far = 0;
  const auto limited = look(camera, sheet, points);
  const auto all = look(PinholeCamera(), sheet, points);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const float depth = all[i].depth, shown = limited[i].depth;
    near += depth < camera.near;
    far += depth > camera.far;
    if (std::isnan(depth)) EXPECT_TRUE(std::isnan(shown));
    else if (depth < camera.near) EXPECT_EQ(shown, -HUGE_VALF);
    else if (depth > camera.far) EXPECT_EQ(shown, HUGE_VALF);
    else EXPECT_EQ(shown, depth);
    EXPECT_EQ(std::isnan(limited[i].u), !std::isfinite(shown));
    EXPECT_EQ(std::isnan(limited[i].side), !std::isfinite(shown));
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(far, 1000);
}

/// Triangles all over the camera, before, beside and behind it, solved for one by one.
TEST(DepthRenderer, SeesWhatRaysMeet) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  PinholeCamera camera;
  camera.width = 32;
  camera.height = 24;
  camera.focal_length = 20;
  camera.near = 0;
  const Sheet sheet = sheetOf(0.05);
  int compared = 0;
  for (int scene = 0; scene < 20; ++scene) {
    const auto points = placed(sheet, [&](const Vector2&) {
      return Vector3(coordinate(random), coordinate(random), coordinate(random) + 0.5);
    });
    for (const Seen& pixel : look(camera, sheet, points)) {
      double nearest = HUGE_VAL;
      bool sure = true;
      for (const Triangle& triangle : sheet.triangles()) {
        Eigen::Matrix3d corners;
        for (int k = 0; k < 3; ++k) corners.col(k) = points.col(triangle[k]);
        const Vector3 shares = corners.partialPivLu().solve(pixel.ray);
        const double least = shares.minCoeff() / shares.cwiseAbs().maxCoeff();
        sure = sure && std::abs(least) > 1e-9;
        if (least > 0) nearest = std::min(nearest, 1 / shares.sum());
      }
      if (!sure) continue;
      ++compared;
      if (nearest == HUGE_VAL) EXPECT_TRUE(std::isnan(pixel.depth));
      else EXPECT_NEAR(pixel.depth, nearest, 1e-7);
    }
  }
  EXPECT_GT(compared, 15000);
}

/// The points of a paper, and after them those of bodies at poses in the camera's frame.
Positions withBodies(const Positions& paper, const std::vector<Body>& bodies,
                     const std::vector<Eigen::Isometry3d>& poses) {
  Positions points = paper;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Positions& own = bodies[i].surface->vertices;
    points.conservativeResize(3, points.cols() + own.cols());
    points.rightCols(own.cols()) = (poses[i] * own.colwise().homogeneous()).topRows(3);
  }
  return points;
}

Body bodyOf(Surface surface) { return {std::make_shared<const Surface>(std::move(surface)), 0}; }

/// The depth at which a ray meets a box in its frame, or infinity (Kay and Kajiya 1986).
double boxDepth(const Vector3& size, const Eigen::Isometry3d& pose, const Vector3& ray) {
  const Vector3 from = pose.inverse().translation(), along = pose.linear().transpose() * ray;
  double first = -HUGE_VAL, last = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const double a = (-size[k] / 2 - from[k]) / along[k], b = (size[k] / 2 - from[k]) / along[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first < last && first > 0 ? first : HUGE_VAL;
}

TEST(DepthRenderer, SeesPaperOnATableBesideABox) {
  const Sheet sheet = sheetOf(0.02);
  const Eigen::Isometry3d paper = poseAt({0, 0.02, 0.4}, 2.5, {1, 0.1, 0});
  // The table is below the paper's back, and the camera above it; its patch is far smaller than
  // the image.
  const Eigen::Isometry3d table = paper * Eigen::Translation3d(0, 0, -0.01);
  const Eigen::Isometry3d box = poseAt({0.08, 0, 0.35}, 0.7, {3, 2, 1});
  Surface patch = planePatch(Vector3::Zero(), 0.01);
  patch.half_space = true;
  const Vector3 size(0.05, 0.04, 0.03);
  const std::vector<Body> bodies{bodyOf(boxSurface(size)), bodyOf(patch)};
  const auto points =
      withBodies(placed(sheet, [&](const Vector2& p) { return paper * Vector3(p.x(), p.y(), 0); }),
                 bodies, {box, table});
  const auto planeDepth = [](const Eigen::Isometry3d& pose, const Vector3& ray) {
    const Vector3 normal = pose.linear().col(2);
    const double depth = normal.dot(pose.translation()) / normal.dot(ray);
    return depth > 0 ? depth : HUGE_VAL;
  };
  int seen[4]{};  // of nothing near enough, the paper, the box, the table
  PinholeCamera camera;
  camera.far = 0.5;
  for (const Seen& pixel : look(camera, sheet, points, bodies)) {
    double of_paper = planeDepth(paper, pixel.ray);
    const Vector3 hit = paper.inverse() * (of_paper * pixel.ray);
    const double inside = std::min({hit.x(), kWide - hit.x(), hit.y(), kHigh - hit.y()});
    if (std::abs(inside) < 1e-9) continue;  // on the border to rounding
    if (!(inside > 0)) of_paper = HUGE_VAL;
    const double of_box = boxDepth(size, box, pixel.ray), of_table = planeDepth(table, pixel.ray);
    const double nearest = std::min({of_paper, of_box, of_table});
    if (nearest > camera.far) {
      EXPECT_EQ(pixel.depth, HUGE_VALF);
      EXPECT_TRUE(std::isnan(pixel.side));
      ++seen[0];
      continue;
    }
    // Rounding to float: half of its step.
    EXPECT_NEAR(pixel.depth, nearest, 6e-8 * nearest);
    const int what = nearest == of_paper ? 1 : nearest == of_box ? 2 : 3;
    ++seen[what];
    if (what == 1) EXPECT_LE(pixel.side, kBackSide);
    else EXPECT_EQ(pixel.side, kFirstObstacle + what - 2);
    EXPECT_EQ(std::isnan(pixel.u), what != 1);
    EXPECT_EQ(std::isnan(pixel.v), what != 1);
  }
  for (const int pixels : seen) EXPECT_GT(pixels, 1000);
}

TEST(DepthRenderer, SeesPaperThatIsPressedOntoABody) {
  const Sheet sheet = sheetOf(0.02);
  const Eigen::Isometry3d pose = poseAt({0, 0, 0.3}, M_PI, Vector3::UnitX());
  const auto paper =
      placed(sheet, [&](const Vector2& p) { return pose * Vector3(p.x(), p.y(), 0); });
  Surface patch = planePatch(Vector3::Zero(), 1);
  patch.half_space = true;
  const std::vector<Body> bodies{bodyOf(patch)};
  // Nearer than the steps of float.
  const Eigen::Isometry3d below = pose * Eigen::Translation3d(0, 0, -1e-9);
  for (const Seen& pixel :
       look(PinholeCamera(), sheet, withBodies(paper, bodies, {below}), bodies)) {
    const Vector2 hit = 0.3 * pixel.ray.head<2>();
    const double inside = std::min(kWide / 2 - std::abs(hit.x()), kHigh / 2 - std::abs(hit.y()));
    if (std::abs(inside) < 1e-9) continue;
    EXPECT_EQ(pixel.side, inside > 0 ? kFrontSide : kFirstObstacle);
  }
}

}  // namespace
}  // namespace shell_origami
