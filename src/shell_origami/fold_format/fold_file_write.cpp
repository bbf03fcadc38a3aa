#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/fold_format/layer_orders.h>

#include <cmath>
#include <sstream>

namespace shell_origami {
namespace {

using nlohmann::json;

double degrees(double radians) { return radians / M_PI * 180; }

/// JSON has no NaN.
json orNull(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

/// The fold angle of each crease in the flat pattern: of one that no fold has driven, what its
/// pattern asks for; of others, the angle they have.
std::vector<double> patternAngles(const Sheet& sheet, const std::vector<FoldCrease>& creases) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < sheet.creases().size(); ++i) {
    const double asked = sheet.creases()[i].pattern_angle;
    const bool is_free = std::isnan(creases.at(i).rest_angle);
    angles.push_back(is_free && std::isfinite(asked) ? asked : creases.at(i).angle);
  }
  return angles;
}

std::vector<double> anglesNow(const std::vector<FoldCrease>& creases) {
  std::vector<double> angles;
  for (const FoldCrease& crease : creases) angles.push_back(crease.angle);
  return angles;
}

/// Letter and fold angle of each edge.
void writeFoldAngles(const Sheet& sheet, const std::vector<double>& crease_angles, json& frame) {
  json kinds = json::array(), angles = json::array();
  for (const Edge& edge : sheet.edges()) {
    const double angle = edge.crease < 0 ? 0 : crease_angles.at(edge.crease);
    angles.push_back(orNull(degrees(angle)));
    if (edge.onBorder()) {
      kinds.push_back("B");
    } else if (edge.crease < 0) {
      kinds.push_back("F");
    } else {
      kinds.push_back(angle < 0 ? "M" : angle > 0 ? "V" : "U");
    }
  }
  frame["edges_assignment"] = std::move(kinds);
  frame["edges_foldAngle"] = std::move(angles);
}

void writeMesh(const Sheet& sheet, json& frame) {
  json edges = json::array();
  for (const Edge& edge : sheet.edges()) edges.push_back(edge.vertices);
  frame["edges_vertices"] = std::move(edges);
  frame["faces_vertices"] = sheet.triangles();
}

json noteCreases(const Sheet& sheet, const std::vector<FoldCrease>& creases) {
  json notes = json::array();
  for (std::size_t i = 0; i < sheet.creases().size(); ++i) {
    const Crease& crease = sheet.creases()[i];
    notes.push_back({{"id", crease.id},
                     {"name", crease.name},
                     {"vertices", crease.vertices},
                     {"rest_angle_deg", orNull(degrees(creases.at(i).rest_angle))}});
    // Without it the rest angle is what a reader asks of the crease.
    if (!std::isnan(crease.pattern_angle)) {
      notes.back()["pattern_angle_deg"] = degrees(crease.pattern_angle);
    }
  }
  return notes;
}

json foldedForm(const Positions& positions) {
  json coordinates = json::array();
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    coordinates.push_back(
        {orNull(positions(0, v)), orNull(positions(1, v)), orNull(positions(2, v))});
  }
  // The format calls what lies in the xy plane 2D, whether or not it says z = 0.
  const bool in_plane = (positions.row(2).array() == 0).all();
  return {{"frame_parent", 0},
          {"frame_inherit", true},
          {"frame_classes", {"foldedForm"}},
          {"frame_attributes", {in_plane ? "2D" : "3D", "manifold", "orientable"}},
          {"frame_unit", "m"},
          {"vertices_coords", std::move(coordinates)}};
}

}  // namespace

json writeFold(const Sheet& sheet, const std::vector<FoldCrease>& creases,
               const Positions& positions, const std::string& title) {
  json document{{"file_spec", 1.2},
                {"file_creator", "shell_origami"},
                {"file_classes", {"singleModel"}},
                {"frame_title", title},
                {"frame_classes", {"creasePattern"}},
                {"frame_attributes", {"2D", "manifold", "orientable"}},
                {"frame_unit", "m"}};
  if (!title.empty()) document["file_title"] = title;
  json coordinates = json::array();
  for (const Vector2& p : sheet.flatPositions()) coordinates.push_back({p.x(), p.y()});
  document["vertices_coords"] = std::move(coordinates);
  writeMesh(sheet, document);
  if (!sheet.layerOrders().empty()) document["faceOrders"] = layerOrdersOf(sheet);
  const std::vector<double> angles = patternAngles(sheet, creases), now = anglesNow(creases);
  writeFoldAngles(sheet, angles, document);
  document["shell_origami:creases"] = noteCreases(sheet, creases);
  json form = foldedForm(positions);
  if (angles != now) writeFoldAngles(sheet, now, form);
  form["frame_title"] = title.empty() ? "folded" : title + ", folded";
  document["file_frames"] = json::array({std::move(form)});
  return document;
}

json foldedFrame(const Sheet& sheet, const std::vector<FoldCrease>& creases,
                 const Positions& positions, double time, int mesh_frame) {
  json frame = foldedForm(positions);
  if (mesh_frame > 0) {
    frame["frame_parent"] = mesh_frame;
  } else {
    frame.erase("frame_parent");
    frame["frame_inherit"] = false;
    writeMesh(sheet, frame);
  }
  writeFoldAngles(sheet, anglesNow(creases), frame);
  std::ostringstream title;
  title << "t = " << time << " s";
  frame["frame_title"] = title.str();
  frame["shell_origami:time"] = orNull(time);
  return frame;
}

std::string foldText(const json& document) {
  // One line a word, so that a person can find the place and a diff shows what changed.
  std::string text = "{\n";
  for (auto item = document.begin(); item != document.end(); ++item) {
    const auto replace = json::error_handler_t::replace;
    text += json(item.key()).dump(-1, ' ', false, replace) + ": " +
            item.value().dump(-1, ' ', false, replace);
    text += std::next(item) == document.end() ? "\n" : ",\n";
  }
  return text + "}\n";
}

}  // namespace shell_origami
