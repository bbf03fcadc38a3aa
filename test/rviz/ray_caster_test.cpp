#include <shell_origami/rviz/ray_caster.h>

#include <shell_origami/mesh/triangulate.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test/contact/scenes.h"

namespace shell_origami {
namespace {

using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Kernel>
typename Kernel::Point_3 pointOf(const Vector3& p) {
  return {p.x(), p.y(), p.z()};
}

/// Part of the way from the ray's origin at which it meets a triangle, exactly; none where not, or
/// where it meets one of its edges.
std::optional<Exact::FT> exactWay(const Ray& ray, const std::array<Vector3, 3>& corners) {
  const Vector3 ahead = ray.origin + ray.direction;  // without rounding
  const auto o = pointOf<Predicates>(ray.origin), q = pointOf<Predicates>(ahead);
  int sum = 0;
  for (int k = 0; k < 3; ++k) {
    sum += CGAL::orientation(o, q, pointOf<Predicates>(corners[k]),
                             pointOf<Predicates>(corners[(k + 1) % 3]));
  }
  if (std::abs(sum) != 3) return std::nullopt;
  const Exact::Plane_3 plane(pointOf<Exact>(corners[0]), pointOf<Exact>(corners[1]),
                             pointOf<Exact>(corners[2]));
  const Exact::Vector_3 normal = plane.orthogonal_vector();
  const Exact::Vector_3 way(pointOf<Exact>(ray.origin), pointOf<Exact>(ahead));
  const Exact::Vector_3 to_plane(pointOf<Exact>(ray.origin), pointOf<Exact>(corners[0]));
  const Exact::FT part = (to_plane * normal) / (way * normal);
  if (part < 0) return std::nullopt;
  return part;
}

struct ExactHit {
  int triangle = -1;
  Exact::FT part = 0;
};

ExactHit exactHit(const Ray& ray, const std::vector<Triangle>& triangles, const Positions& x) {
  ExactHit nearest;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const auto part = exactWay(ray, {x.col(a), x.col(b), x.col(c)});
    if (part && (nearest.triangle < 0 || *part < nearest.part)) {
      nearest = {static_cast<int>(t), *part};
    }
  }
  return nearest;
}

/// From around the paper towards it. Coordinates are multiples of 2^-20 m, which add up exactly.
Ray randomRay(const Positions& x, std::mt19937& random) {
  std::normal_distribution<double> any;
  const auto rounded = [](const Vector3& p) -> Vector3 {
    return (p * 1048576).array().round() / 1048576;
  };
  const Vector3 from(any(random), any(random), any(random));
  const Vector3 target =
      x.col(std::uniform_int_distribution<int>(0, static_cast<int>(x.cols()) - 1)(random)) +
      0.005 * Vector3(any(random), any(random), any(random));
  const Vector3 origin = rounded(0.5 * from.normalized());
  return {origin, rounded(target) - origin};
}

TEST(RayCaster, MeetsTheTriangleThatExactNumbersSay) {
  std::mt19937 random(1);
  Random folds(1);
  int hits = 0;
  for (int paper = 0; paper < 10; ++paper) {
    const Sheet sheet(triangulateRectangle(0.15, 0.15, 0.012));
    const Positions x = folded(sheet, 4, folds);
    RayCaster caster(sheet.flatPositions(), sheet.triangles());
    caster.follow(x);
    for (int i = 0; i < 1000; ++i) {
      const Ray ray = randomRay(x, random);
      const ExactHit exact = exactHit(ray, sheet.triangles(), x);
      const auto hit = caster.cast(ray);
      ASSERT_EQ(hit ? hit->triangle : -1, exact.triangle) << "paper " << paper << ", ray " << i;
      if (!hit) continue;
      ++hits;
      const Vector3 point = ray.origin + CGAL::to_double(exact.part) * ray.direction;
      EXPECT_LT((hit->point - point).norm(), 1e-9);
      EXPECT_NEAR(hit->distance, (point - ray.origin).norm(), 1e-9);
      Vector3 weighed = Vector3::Zero();
      for (int k = 0; k < 3; ++k) {
        weighed += hit->weights[k] * x.col(sheet.triangles()[hit->triangle][k]);
      }
      EXPECT_LT((weighed - point).norm(), 1e-9);
    }
  }
  EXPECT_GT(hits, 5000);
}

TEST(RayCaster, NoRayPassesBetweenTriangles) {
  const Sheet sheet(triangulateRectangle(0.15, 0.15, 0.015));
  Random random(3);
  Positions x(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const Vector2& p = sheet.flatPositions()[v];
    x.col(v) = Vector3(p.x(), p.y(), random.between(0, 0.002));  // rough: no edge hides another
  }
  RayCaster caster(sheet.flatPositions(), sheet.triangles());
  caster.follow(x);
  const Vector3 eye(0.07, 0.08, 1);
  for (const Edge& edge : sheet.edges()) {
    if (edge.onBorder()) continue;
    const auto [a, b] = edge.vertices;
    for (double at : {0.25, 0.5, random.between(0.01, 0.99)}) {
      const Vector3 way = (1 - at) * x.col(a) + at * x.col(b) - eye;
      const auto hit = caster.cast({eye, way});
      ASSERT_TRUE(hit) << a << ", " << b << ", " << at;
      EXPECT_NEAR(hit->distance, way.norm(), 1e-12);
    }
  }
}

TEST(RayCaster, LooksForwardOnly) {
  const Sheet sheet(triangulateRectangle(0.15, 0.15, 0.05));
  RayCaster caster(sheet.flatPositions(), sheet.triangles());
  Positions flat = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) flat.col(v).head<2>() = sheet.flatPositions()[v];
  caster.follow(flat);
  EXPECT_TRUE(caster.cast({{0.05, 0.06, 1}, {0, 0, -3}}));
  EXPECT_FALSE(caster.cast({{0.05, 0.06, 1}, {0, 0, 3}}));
  EXPECT_FALSE(caster.cast({{0.05, 0.06, 0.1}, {1, 0, 0}}));
  EXPECT_TRUE(caster.cast({{0.05, 0.06, -1}, {0, 0, 1}})) << "the back counts, too";
}

}  // namespace
}  // namespace shell_origami
