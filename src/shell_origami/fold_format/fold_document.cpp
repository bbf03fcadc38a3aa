#include <shell_origami/fold_format/fold_document.h>

#include <shell_origami/base/bounded_json.h>
#include <shell_origami/base/error.h>
#include <shell_origami/base/files.h>
#include <shell_origami/sheet/sheet.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace shell_origami {
namespace {

using nlohmann::json;

/// Of a FOLD file. Its JSON takes up to some thirty times as much memory.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;

/// Returns the place in the file: key[index].
std::string place(const std::string& key, std::size_t index) {
  return key + "[" + std::to_string(index) + "]";
}

double readNumber(const json& value, const std::string& where) {
  if (!value.is_number()) reject(where, " is ", describeJson(value), ", not a number");
  return value.get<double>();
}

/// Whether it is an integer, at least `least` and less than `end`.
bool isIntegerWithin(const json& value, std::int64_t least, std::int64_t end) {
  // Beyond 64 bits the parser has made a float of it.
  if (!value.is_number_integer()) return false;
  const bool huge = value.is_number_unsigned() &&
                    value.get<std::uint64_t>() > std::numeric_limits<std::int32_t>::max();
  return !huge && value.get<std::int64_t>() >= least && value.get<std::int64_t>() < end;
}

int readVertex(const json& value, int vertex_count, const std::string& where) {
  if (!value.is_number_integer()) reject(where, " holds ", describeJson(value), ", not a vertex");
  if (!isIntegerWithin(value, 0, vertex_count)) {
    reject(where, " names vertex ", describeJson(value), ", but there are ", vertex_count);
  }
  return value.get<int>();
}

std::vector<int> readVertices(const json& value, int vertex_count, std::size_t least,
                              const std::string& where) {
  if (!value.is_array() || value.size() < least) {
    reject(where, " is no list of at least ", least, " vertices");
  }
  std::vector<int> vertices;
  for (const json& item : value) vertices.push_back(readVertex(item, vertex_count, where));
  return vertices;
}

double radians(double degrees) { return degrees / 180 * M_PI; }

/// \throws std::invalid_argument beyond a full fold
double readAngle(const json& value, const std::string& where) {
  if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
  const double degrees = readNumber(value, where);
  if (!(std::abs(degrees) <= 180)) reject(where, " is ", degrees, ", beyond 180 degrees");
  return radians(degrees);
}

}  // namespace

FoldDocument::FoldDocument(const std::string& path) : root_(parseJson(readFile(path, kMostBytes))) {
  if (!root_.is_object()) reject("is not a FOLD file: its JSON is no object");
  frames_.push_back(&root_);
  parents_.push_back(-1);
  const auto found = root_.find("file_frames");
  if (found == root_.end()) return;
  if (!found->is_array()) reject("file_frames is no list");
  const int count = 1 + static_cast<int>(found->size());
  for (const json& frame : *found) {
    const std::string name = frameName(frameCount());
    if (!frame.is_object()) reject(name, " is no object");
    const bool inherits = frame.contains("frame_inherit") && frame["frame_inherit"] == true;
    int parent = inherits ? 0 : -1;
    if (inherits && frame.contains("frame_parent")) {
      const json& value = frame["frame_parent"];
      if (!value.is_number_integer() || value < 0 || value >= count) {
        reject(name, " has frame_parent ", describeJson(value), ", which is no frame");
      }
      parent = value.get<int>();
    }
    frames_.push_back(&frame);
    parents_.push_back(parent);
  }
}

bool FoldDocument::descendsFrom(int frame, int ancestor) const {
  for (int steps = 0; frame >= 0 && steps <= frameCount(); ++steps) {
    if (frame == ancestor) return true;
    const auto parent = frames_[frame]->find("frame_parent");
    const bool is_frame =
        parent != frames_[frame]->end() && parent->is_number_integer() && *parent < frameCount();
    frame = is_frame ? parent->get<int>() : parents_[frame];
  }
  return false;
}

bool FoldDocument::sharesMesh(int frame, int other) const {
  for (const char* key : {"edges_vertices", "faces_vertices"}) {
    const json *mine = find(frame, key), *its = find(other, key);
    if (mine && its && mine != its && *mine != *its) return false;
  }
  return true;
}

const json* FoldDocument::find(int frame, const char* key) const {
  // As many steps as there are frames: more means that frames inherit in a circle.
  for (int steps = 0; frame >= 0; ++steps) {
    if (steps > frameCount()) reject(frameName(frame), " inherits from itself");
    const auto found = frames_[frame]->find(key);
    if (found != frames_[frame]->end()) return &*found;
    frame = parents_[frame];
  }
  return nullptr;
}

const json* FoldDocument::findArray(int frame, const char* key) const {
  const json* value = find(frame, key);
  if (value && !value->is_array()) reject(key, " is no list");
  return value;
}

namespace {

bool lists(const json* words, const char* word) {
  return words && words->is_array() &&
         std::find(words->begin(), words->end(), word) != words->end();
}

}  // namespace

bool FoldDocument::hasClass(int frame, const char* name) const {
  return lists(find(frame, "frame_classes"), name);
}

bool FoldDocument::isOfClass(const char* name) const {
  return lists(find(0, "file_classes"), name);
}

std::string FoldDocument::unit(int frame) const {
  const json* value = find(frame, "frame_unit");
  if (!value) return "unit";
  if (!value->is_string()) reject("frame_unit is ", describeJson(*value), ", not a word");
  return value->get<std::string>();
}

std::string FoldDocument::frameName(int frame) {
  return frame == 0 ? "the key frame" : place("file_frames", frame - 1);
}

std::vector<Vector3> FoldDocument::points(int frame) const {
  return coordinates(frame, "vertices_coords");
}

std::vector<Vector3> FoldDocument::flatCoordinates(int frame) const {
  return coordinates(frame, kFlatCoordinates);
}

std::vector<Vector3> FoldDocument::coordinates(int frame, const char* key) const {
  std::vector<Vector3> points;
  const json* list = findArray(frame, key);
  if (!list) return points;
  for (const json& item : *list) {
    const std::string where = place(key, points.size());
    if (!item.is_array() || item.size() < 2 || item.size() > 3) {
      reject(where, " is ", describeJson(item), ", not two or three numbers");
    }
    Vector3 p = Vector3::Zero();
    for (std::size_t k = 0; k < item.size(); ++k) p[k] = readNumber(item[k], where);
    if (!(p.cwiseAbs().maxCoeff() < 1e100)) {
      reject(where, " has a coordinate of 1e100 or more");
    }
    points.push_back(p);
  }
  return points;
}

std::vector<std::array<int, 2>> FoldDocument::edges(int frame, int vertex_count) const {
  std::vector<std::array<int, 2>> edges;
  const json* list = findArray(frame, "edges_vertices");
  if (!list) return edges;
  for (const json& item : *list) {
    const std::string where = place("edges_vertices", edges.size());
    if (!item.is_array() || item.size() != 2)
      reject(where, " is ", describeJson(item), ", not a pair");
    edges.push_back(
        {readVertex(item[0], vertex_count, where), readVertex(item[1], vertex_count, where)});
  }
  return edges;
}

std::string FoldDocument::assignments(int frame, std::size_t edge_count) const {
  std::string letters;
  const json* list = findArray(frame, "edges_assignment");
  if (!list) return letters;
  for (const json& item : *list) {
    const std::string word = item.is_string() ? item.get<std::string>() : "";
    if (word.size() != 1 || std::strchr("BMVFUCJ", word[0]) == nullptr) {
      reject(place("edges_assignment", letters.size()), " is ", describeJson(item),
             ", not one of B M V F U C J");
    }
    letters += word;
  }
  if (letters.size() != edge_count) {
    reject("edges_assignment has ", letters.size(), " entries for ", edge_count, " edges");
  }
  return letters;
}

std::vector<double> FoldDocument::foldAngles(int frame, std::size_t edge_count) const {
  std::vector<double> angles;
  const json* list = findArray(frame, "edges_foldAngle");
  if (!list) list = findArray(frame, "edges_foldAngles");  // so called by FOLD 1.0
  if (!list) return angles;
  for (const json& item : *list) {
    angles.push_back(readAngle(item, place("edges_foldAngle", angles.size())));
  }
  if (angles.size() != edge_count) {
    reject("edges_foldAngle has ", angles.size(), " entries for ", edge_count, " edges");
  }
  return angles;
}

std::vector<std::vector<int>> FoldDocument::faces(int frame, int vertex_count) const {
  std::vector<std::vector<int>> faces;
  const json* list = findArray(frame, "faces_vertices");
  if (!list) return faces;
  for (const json& item : *list) {
    faces.push_back(readVertices(item, vertex_count, 3, place("faces_vertices", faces.size())));
  }
  return faces;
}

std::vector<std::array<int, 3>> FoldDocument::faceOrders(int frame, std::size_t face_count) const {
  std::vector<std::array<int, 3>> orders;
  const json* list = findArray(frame, "faceOrders");
  if (!list) return orders;
  const auto faces = static_cast<std::int64_t>(face_count);
  for (const json& item : *list) {
    if (!item.is_array() || item.size() != 3 || !isIntegerWithin(item[0], 0, faces) ||
        !isIntegerWithin(item[1], 0, faces) || !isIntegerWithin(item[2], -1, 2)) {
      reject(place("faceOrders", orders.size()), " is ", describeJson(item), ", not two of ",
             face_count, " faces and -1, 0 or 1");
    }
    orders.push_back(item.get<std::array<int, 3>>());
  }
  return orders;
}

std::vector<NotedCrease> FoldDocument::notedCreases(int frame, int vertex_count) const {
  std::vector<NotedCrease> creases;
  const json* list = findArray(frame, "shell_origami:creases");
  if (!list) return creases;
  for (const json& item : *list) {
    const std::string where = place("shell_origami:creases", creases.size());
    for (const char* key : {"id", "name", "vertices", "rest_angle_deg"}) {
      if (!item.is_object() || !item.contains(key)) reject(where, " has no ", key);
    }
    const json &id = item["id"], &name = item["name"];
    if (!id.is_number_unsigned() || id >= std::numeric_limits<std::uint32_t>::max()) {
      reject(where, " has id ", describeJson(id), ", not a number from 0 to 2^32 - 2");
    }
    if (!name.is_string()) reject(where, " has name ", describeJson(name), ", not a word");
    checkCreaseName(name.get<std::string>());
    NotedCrease crease{id.get<std::uint32_t>(), name.get<std::string>(),
                       readVertices(item["vertices"], vertex_count, 2, where),
                       readAngle(item["rest_angle_deg"], where + " rest_angle_deg")};
    crease.pattern_angle = crease.rest_angle;
    const auto asked = item.find("pattern_angle_deg");
    if (asked != item.end()) {
      crease.pattern_angle = readAngle(*asked, where + " pattern_angle_deg");
    }
    creases.push_back(std::move(crease));
  }
  return creases;
}

}  // namespace shell_origami
