#include <shell_origami/node/draw/labels.h>

#include <shell_origami/energy/material.h>
#include <shell_origami/node/draw/coloring.h>
#include <shell_origami/node/draw/marker.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace shell_origami {
namespace {

using visualization_msgs::Marker;
using Points = Eigen::Matrix3Xd;

const std_msgs::ColorRGBA kText = color(0.10, 0.10, 0.10);
/// Heights of letters over the paper's size.
constexpr double kVertexId = 1.0 / 60;
constexpr double kCreaseLabel = 1.0 / 35;
constexpr double kPressureLabel = 1.0 / 28;
constexpr double kWarningText = 1.0 / 18;

Marker newText(const char* name, std::size_t id, const std_msgs::Header& header, double height) {
  Marker marker = newMarker(name, Marker::TEXT_VIEW_FACING, header);
  marker.id = static_cast<int>(id);
  marker.scale.z = height;
  marker.color = kText;
  return marker;
}

/// `wanted` texts, which `write` completes, and the deletion of those beyond them.
template <class Write>
void addTexts(const char* name, std::size_t wanted, std::size_t& shown, double height,
              const std_msgs::Header& header, visualization_msgs::MarkerArray& array,
              const Write& write) {
  for (std::size_t i = 0; i < std::max(wanted, shown); ++i) {
    Marker marker = newText(name, i, header, height);
    if (i < wanted) write(i, marker);
    else marker.action = Marker::DELETE;
    array.markers.push_back(marker);
  }
  shown = wanted;
}

std::string creaseLabel(const msg::Crease& crease, double angle) {
  char degrees[32];
  std::snprintf(degrees, sizeof degrees, "  %.0f deg", angle * 180 / M_PI);
  return (crease.name.empty() ? "crease " + std::to_string(crease.id) : crease.name) + degrees;
}

/// Above the middle of the paper.
geometry_msgs::Point placeAbove(const Points& points, double height) {
  Eigen::Vector3d place = (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2;
  place.z() = points.row(2).maxCoeff() + height;
  return markerPoint(place);
}

Marker strainWarning(const msg::SheetState& state, const Points& points, double size,
                     const std_msgs::Header& header) {
  Marker marker = newText("warning", 0, header, kWarningText * size);
  if (state.soft || !(state.max_strain > kBearableStrain)) {
    marker.action = Marker::DELETE;
    return marker;
  }
  char text[80];
  std::snprintf(text, sizeof text, "stretched by %.0f %%, further than paper bears",
                100 * state.max_strain);
  marker.text = text;
  marker.pose.position = placeAbove(points, 2 * kWarningText * size);
  return marker;
}

}  // namespace

void Labels::draw(const msg::Sheet& sheet, const msg::SheetState& state, const Points& points,
                  const Points& normals, double size, visualization_msgs::MarkerArray& array) {
  std_msgs::Header header = state.header;
  header.seq = 0;
  const auto vertices = static_cast<std::size_t>(points.cols());
  addTexts("vertex_ids", options_.vertex_ids ? vertices : 0, vertices_, kVertexId * size, header,
           array, [&](std::size_t i, Marker& marker) {
             const auto v = static_cast<Eigen::Index>(i);
             marker.pose.position = markerPoint(points.col(v) + kVertexId * size * normals.col(v));
             marker.text = std::to_string(i);
           });
  addTexts("crease_labels", options_.crease_labels ? sheet.creases.size() : 0, creases_,
           kCreaseLabel * size, header, array, [&](std::size_t i, Marker& marker) {
             const msg::Crease& crease = sheet.creases[i];
             const double angle = state.creases[i].angle;
             if (crease.vertices.empty()) {
               marker.action = Marker::DELETE;
               return;
             }
             // Outside the fold, where no flap hides it.
             const std::uint32_t v = crease.vertices[crease.vertices.size() / 2];
             const double side = angle > 0 ? -1 : 1;
             marker.pose.position =
                 markerPoint(points.col(v) + side * kCreaseLabel * size * normals.col(v));
             marker.text = creaseLabel(crease, angle);
           });
  array.markers.push_back(strainWarning(state, points, size, header));
}

Marker pressureLabel(const msg::SheetState& state, const Points& points, double size,
                     const std_msgs::Header& header) {
  Marker marker = newText("pressure", 0, header, kPressureLabel * size);
  marker.pose.position = placeAbove(points, 1.5 * kPressureLabel * size);
  if (state.pressures.empty()) {
    marker.text = "no pressures are recorded";
    return marker;
  }
  char text[80];
  std::snprintf(text, sizeof text, "pressed with up to %.0f Pa, red from %.0f Pa",
                *std::max_element(state.pressures.begin(), state.pressures.end()),
                SheetColours::kFullPressure);
  marker.text = text;
  return marker;
}

}  // namespace shell_origami
