#include <shell_origami/mesh/intersections.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace shell_origami {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle3 = Kernel::Triangle_3;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Triangle3*>;

Triangle3 triangleAt(const Positions& x, const Triangle& t) {
  const auto point = [&x](int v) { return Kernel::Point_3(x(0, v), x(1, v), x(2, v)); };
  return {point(t[0]), point(t[1]), point(t[2])};
}

}  // namespace

std::vector<std::array<int, 2>> intersections(const Positions& positions,
                                              const std::vector<Triangle>& triangles,
                                              const std::vector<int>& names) {
  std::vector<Triangle3> in_space;
  in_space.reserve(triangles.size());
  for (const Triangle& t : triangles) in_space.push_back(triangleAt(positions, t));
  std::vector<Box> boxes;
  for (const Triangle3& t : in_space) {
    if (!t.is_degenerate()) boxes.emplace_back(t.bbox(), &t);
  }
  const auto shareVertex = [&](int f, int g) {
    for (int v : triangles[f]) {
      for (int w : triangles[g]) {
        if (names[v] == names[w]) return true;
      }
    }
    return false;
  };
  std::vector<std::array<int, 2>> found;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    int f = static_cast<int>(a.handle() - in_space.data());
    int g = static_cast<int>(b.handle() - in_space.data());
    if (f > g) std::swap(f, g);
    if (!shareVertex(f, g) && CGAL::do_intersect(*a.handle(), *b.handle())) found.push_back({f, g});
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace shell_origami
