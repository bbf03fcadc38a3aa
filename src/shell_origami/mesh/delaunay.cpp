#include <shell_origami/mesh/delaunay.h>

#include <shell_origami/base/error.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

namespace shell_origami {
namespace {

enum class Cover { kUnknown, kPaper, kOff };
struct Mark {
  Cover cover = Cover::kUnknown;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using PlainFaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<Mark, Kernel, PlainFaceBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

/// One after the other from the last one's face: the order is ours, so the result is too.
std::vector<Cdt::Vertex_handle> insertPoints(Cdt& cdt, const std::vector<Vector2>& points) {
  std::vector<Cdt::Vertex_handle> handles;
  handles.reserve(points.size());
  Cdt::Face_handle near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Cdt::Vertex_handle vertex = cdt.insert({points[i].x(), points[i].y()}, near);
    if (cdt.number_of_vertices() == i) {
      reject("points ", vertex->info(), " and ", i, " coincide");
    }
    vertex->info() = static_cast<int>(i);
    handles.push_back(vertex);
    near = vertex->face();
  }
  return handles;
}

/// Marks as off the paper what can be reached from `start` without stepping over a segment.
void markOff(const Cdt& cdt, Cdt::Face_handle start) {
  std::vector<Cdt::Face_handle> stack{start};
  while (!stack.empty()) {
    const Cdt::Face_handle face = stack.back();
    stack.pop_back();
    if (face->info().cover == Cover::kOff) continue;
    face->info().cover = Cover::kOff;
    for (int k = 0; k < 3; ++k) {
      if (!cdt.is_constrained({face, k})) stack.push_back(face->neighbor(k));
    }
  }
}

}  // namespace

std::vector<Triangle> constrainedDelaunay(const PlanarGraph& graph) {
  Cdt cdt;
  const auto vertices = insertPoints(cdt, graph.points);
  for (const auto& segment : graph.segments) {
    cdt.insert_constraint(vertices[segment[0]], vertices[segment[1]]);
  }
  if (cdt.number_of_vertices() != graph.points.size()) reject("two segments cross");
  if (cdt.dimension() < 2) reject("all points lie on one line");

  markOff(cdt, cdt.infinite_face());
  for (const Vector2& hole : graph.holes) markOff(cdt, cdt.locate({hole.x(), hole.y()}));

  std::vector<Triangle> triangles;
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    if (face->info().cover == Cover::kOff) continue;
    Triangle t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  if (triangles.empty()) reject("the segments enclose no paper");
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace shell_origami
