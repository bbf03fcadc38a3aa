#include <shell_origami/origami/snapshot.h>

#include <shell_origami/base/bounded_json.h>
#include <shell_origami/base/error.h>
#include <shell_origami/origami/obstacle_json.h>
#include <shell_origami/origami/parameter_table.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// CBOR and shortest decimals, into which this is written, keep every bit of a number.

namespace shell_origami {
namespace {

using Json = nlohmann::json;

template <class Vector>
Json numbers(const Vector& values) {
  return std::vector<double>(values.data(), values.data() + values.size());
}

Vector3 vectorFrom(const Json& json) {
  const auto values = json.get<std::array<double, 3>>();
  return {values[0], values[1], values[2]};
}

Positions columns(const Json& json, int count) {
  const auto values = json.get<std::vector<double>>();
  if (values.size() != 3 * static_cast<std::size_t>(count)) {
    reject(count, " vertices, but ", values.size(), " coordinates");
  }
  Positions result = Eigen::Map<const Positions>(values.data(), 3, count);
  if (!result.allFinite()) reject("a coordinate is not finite");
  return result;
}

/// material/thickness lies at "thickness" within "material".
Json::json_pointer placeOf(const std::string& name) { return Json::json_pointer("/" + name); }

Json valueAt(const Place& place) {
  if (const auto* choice = std::get_if<Choice>(&place)) return choice->get();
  if (const auto* list = std::get_if<Vector3*>(&place)) return numbers(**list);
  if (const auto* number = std::get_if<double*>(&place)) return **number;
  if (const auto* count = std::get_if<int*>(&place)) return **count;
  if (const auto* truth = std::get_if<bool*>(&place)) return **truth;
  return *std::get<std::string*>(place);
}

void setValue(const Place& place, const Json& json) {
  if (const auto* choice = std::get_if<Choice>(&place)) {
    if (!choice->set(json.get<std::string>())) reject("unknown word ", describeJson(json));
  } else if (const auto* list = std::get_if<Vector3*>(&place)) {
    **list = vectorFrom(json);
  } else if (const auto* number = std::get_if<double*>(&place)) {
    **number = json;
  } else if (const auto* count = std::get_if<int*>(&place)) {
    **count = json;
  } else if (const auto* truth = std::get_if<bool*>(&place)) {
    **truth = json;
  } else {
    *std::get<std::string*>(place) = json.get<std::string>();
  }
}

Json write(SimulationConfig config) {
  Json json{{"curvature", config.rest.curvature}, {"axis", config.rest.axis}};
  for (const auto& parameter : simulationParameters()) {
    json[placeOf(parameter.name)] = valueAt(parameter.place(config));
  }
  return json;
}

SimulationConfig readConfig(const Json& json) {
  SimulationConfig config;
  for (const auto& parameter : simulationParameters()) {
    setValue(parameter.place(config), json.at(placeOf(parameter.name)));
  }
  config.rest.curvature = json.at("curvature");
  config.rest.axis = json.at("axis");
  return config;
}

Json write(const Sheet& sheet) {
  Json points = Json::array(), creases = Json::array();
  for (const Vector2& p : sheet.flatPositions()) {
    points.push_back(p.x());
    points.push_back(p.y());
  }
  for (const Crease& crease : sheet.creases()) {
    creases.push_back({{"id", crease.id},
                       {"name", crease.name},
                       {"vertices", crease.vertices},
                       {"pattern_angle", crease.pattern_angle}});
  }
  Json orders = Json::array();
  for (const LayerOrder& order : sheet.layerOrders()) {
    orders.push_back({order.first.x(), order.first.y(), order.second.x(), order.second.y(),
                      static_cast<double>(order.side)});
  }
  return {{"points", points},
          {"triangles", sheet.triangles()},
          {"creases", creases},
          {"layer_orders", orders},
          {"revision", sheet.revision()},
          {"next_crease_id", sheet.nextCreaseId()}};
}

void checkIds(const std::vector<int>& vertices, std::size_t count) {
  for (int v : vertices) {
    if (v < 0 || v >= static_cast<int>(count)) reject("there is no vertex ", v);
  }
}

std::vector<LayerOrder> readOrders(const Json& json, const Sheet& sheet) {
  std::vector<LayerOrder> orders;
  for (const Json& entry : json) {
    const auto n = entry.get<std::array<double, 5>>();
    const LayerOrder order{{n[0], n[1]}, {n[2], n[3]}, static_cast<int>(n[4])};
    for (const Vector2& p : {order.first, order.second}) {
      if (!sheet.triangulation().locate(p, 0)) reject("an order of layers off the paper");
    }
    if (order.side != n[4] || std::abs(order.side) > 1) reject("an order of layers to no side");
    orders.push_back(order);
  }
  return orders;
}

Sheet readSheet(const Json& json) {
  const auto coordinates = json.at("points").get<std::vector<double>>();
  std::vector<Vector2> points;
  for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2) {
    points.emplace_back(coordinates[i], coordinates[i + 1]);
  }
  std::vector<Crease> creases;
  for (const Json& entry : json.at("creases")) {
    Crease crease;
    crease.id = entry.at("id");
    crease.name = entry.at("name");
    crease.vertices = entry.at("vertices").get<std::vector<int>>();
    crease.pattern_angle = entry.at("pattern_angle");
    checkIds(crease.vertices, points.size());
    creases.push_back(std::move(crease));
  }
  Sheet sheet(Triangulation(std::move(points), json.at("triangles").get<std::vector<Triangle>>()),
              std::move(creases));
  sheet.restore(json.at("revision"), json.at("next_crease_id"));
  sheet.setLayerOrders(readOrders(json.at("layer_orders"), sheet));
  return sheet;
}

Json write(const FoldRamp& ramp) {
  return {
      ramp.driven ? 1 : 0, ramp.from,     ramp.target,    ramp.lead_from, ramp.lead_target,
      ramp.start,          ramp.duration, ramp.stiffness, ramp.set,       ramp.of_pattern ? 1 : 0};
}

FoldRamp readRamp(const Json& json) {
  const auto n = json.get<std::array<double, 10>>();
  for (double number : n) {
    if (!std::isfinite(number)) reject("a ramp is not finite");
  }
  return {n[0] != 0, n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9] != 0};
}

CreaseActuation readCreases(const Json& json, const Sheet& sheet) {
  std::vector<FoldRamp> ramps;
  for (const Json& entry : json.at("ramps")) ramps.push_back(readRamp(entry));
  if (ramps.size() != sheet.creases().size()) {
    reject(sheet.creases().size(), " creases, but ", ramps.size(), " ramps");
  }
  return CreaseActuation(std::move(ramps), json.at("stiffness").get<double>());
}

Compliance readCompliance(const Json& json) {
  const double factor = json.at("factor"), level = json.at("level");
  if (!(factor >= 1 && std::isfinite(factor) && level >= 0 && level <= 1)) {
    reject("a compliance of ", factor, " at ", level);
  }
  return Compliance(factor, level, json.at("folding"));
}

RestShape readRest(const Json& json, const NaturalCurvature& roll, const Sheet& sheet) {
  auto set = json.at("set").get<std::vector<double>>();
  auto plastic = json.at("plastic").get<std::vector<double>>();
  const std::size_t edges = sheet.edges().size();
  if (set.size() != edges || plastic.size() != edges) reject("bends of other edges");
  return RestShape(roll, sheet, std::move(set), std::move(plastic));
}

Json write(const InPlaneSet& set) {
  Json strains = Json::array();
  for (const GreenStrain& strain : set.strains()) {
    for (int k = 0; k < 3; ++k) strains.push_back(strain[k]);
  }
  return strains;
}

InPlaneSet readInPlane(const Json& json, int triangles) {
  const auto numbers = json.get<std::vector<double>>();
  if (numbers.size() != 3 * static_cast<std::size_t>(triangles)) reject("sets of other triangles");
  std::vector<GreenStrain> strains;
  for (int i = 0; i < triangles; ++i) {
    strains.emplace_back(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    const GreenStrain& e = strains.back();
    // The lengths that it leaves are real.
    if (!(e.allFinite() && e[0] > -0.5 && (1 + 2 * e[0]) * (1 + 2 * e[1]) > 4 * e[2] * e[2])) {
      reject("a triangle is set to nothing");
    }
  }
  return InPlaneSet(std::move(strains));
}

Json write(const HeldVertices& held) {
  Json grips = Json::object();
  for (const auto& [frame, grip] : held.grips()) {
    Json places = Json::array();
    for (const auto& [v, place] : grip.places) {
      places.push_back({{"vertex", v}, {"place", numbers(place)}});
    }
    grips[frame] = toJson(grip.pose);
    grips[frame]["places"] = places;
    if (!(grip.next == grip.pose)) grips[frame]["next"] = toJson(grip.next);
  }
  return {{"in_place", held.inPlace()}, {"grips", grips}};
}

HeldVertices readHeld(const Json& json, int vertex_count) {
  std::map<std::string, Grip> grips;
  for (const auto& [frame, entry] : json.at("grips").items()) {
    Grip& grip = grips[frame];
    grip.pose = poseFrom(entry);
    grip.next = entry.contains("next") ? poseFrom(entry.at("next")) : grip.pose;
    for (const Json& place : entry.at("places")) {
      const int v = place.at("vertex");
      checkIds({v}, vertex_count);
      grip.places[v] = vectorFrom(place.at("place"));
    }
  }
  const auto in_place = json.at("in_place").get<std::vector<int>>();
  checkIds(in_place, vertex_count);
  return HeldVertices(in_place, std::move(grips));
}

VertexGraph readPattern(const Json& json) {
  VertexGraph pattern;
  pattern.starts = json.at("starts").get<std::vector<int>>();
  pattern.indices = json.at("indices").get<std::vector<int>>();
  if (pattern.starts.empty()) reject("the matrix's pattern has no columns");
  return pattern;
}

std::vector<TrianglePair> readPairs(const Json& json, int triangles) {
  const auto pairs = json.get<std::vector<TrianglePair>>();
  for (const auto& [f, g] : pairs) {
    if (f < 0 || f >= g || g >= triangles) reject("no pair of triangles: ", f, " and ", g);
  }
  if (!std::is_sorted(pairs.begin(), pairs.end()))
    reject("the pairs of triangles are not in order");
  return pairs;
}

Snapshot read(const Json& json) {
  const SimulationConfig config = readConfig(json.at("config"));
  checkConfig(config);
  Sheet sheet = readSheet(json.at("sheet"));
  sheet.validate();
  const int count = sheet.vertexCount(), triangles = static_cast<int>(sheet.triangles().size());
  Motion motion{columns(json.at("positions"), count), columns(json.at("velocities"), count),
                columns(json.at("accelerations"), count), json.at("acceleration_persistence"),
                json.at("rough")};
  CreaseActuation creases = readCreases(json.at("creases"), sheet);
  RestShape rest = readRest(json.at("rest"), config.rest, sheet);
  const Json& memory = json.at("memory");
  return {config,
          std::move(sheet),
          std::move(motion),
          std::move(creases),
          readCompliance(json.at("compliance")),
          std::move(rest),
          readInPlane(json.at("in_plane"), triangles),
          readHeld(json.at("held"), count),
          obstaclesFrom(json.at("obstacles")),
          graspsFrom(json.at("grasps"), count),
          {memory.at("contraction"), memory.at("unchecked")},
          readPattern(memory.at("pattern")),
          countersFrom(json.at("counters")),
          json.at("time"),
          json.at("resting"),
          json.at("edited"),
          readPairs(json.at("left_out"), triangles)};
}

}  // namespace

Json toJson(const Counters& counters) {
  return {{"steps", counters.steps},
          {"newton_iterations", counters.newton_iterations},
          {"factorizations", counters.factorizations},
          {"retries", counters.retries}};
}

Json toJson(const SimulationConfig& config) { return write(config); }

SimulationConfig configFrom(const Json& json) { return readConfig(json); }

Counters countersFrom(const Json& json) {
  Counters counters;
  counters.steps = json.at("steps");
  counters.newton_iterations = json.at("newton_iterations");
  counters.factorizations = json.at("factorizations");
  counters.retries = json.at("retries");
  return counters;
}

Counters& Counters::operator+=(const Counters& other) {
  steps += other.steps;
  newton_iterations += other.newton_iterations;
  factorizations += other.factorizations;
  retries += other.retries;
  times += other.times;
  return *this;
}

Counters& Counters::operator-=(const Counters& other) {
  steps -= other.steps;
  newton_iterations -= other.newton_iterations;
  factorizations -= other.factorizations;
  retries -= other.retries;
  times -= other.times;
  return *this;
}

std::size_t memoryOf(const Snapshot& snapshot) {
  const auto bytes = [](const auto& list) { return list.size() * sizeof(list[0]); };
  const auto columns = static_cast<std::size_t>(snapshot.motion.positions.cols());
  const Sheet& sheet = snapshot.sheet;
  // A triangle has three numbers each for its vertices, neighbors, labels and edges.
  std::size_t sum = sizeof(Snapshot) + 3 * 3 * columns * sizeof(double) +
                    bytes(sheet.flatPositions()) + 4 * bytes(sheet.triangles()) +
                    bytes(sheet.edges()) + bytes(sheet.creases()) + bytes(sheet.layerOrders()) +
                    bytes(snapshot.creases.ramps()) + bytes(snapshot.in_plane.strains()) +
                    bytes(snapshot.rest.set()) + bytes(snapshot.rest.plastic()) +
                    bytes(snapshot.pattern.starts) + bytes(snapshot.pattern.indices) +
                    bytes(snapshot.left_out);
  for (const Crease& crease : sheet.creases()) sum += bytes(crease.vertices);
  // Nodes of maps and sets.
  constexpr std::size_t kHeldVertex = 150, kObstacle = 1000;
  sum += kObstacle * snapshot.obstacles.all().size();
  return sum + kHeldVertex * snapshot.held.all().size();
}

Json toJson(const Snapshot& snapshot) {
  Json ramps = Json::array();
  for (const FoldRamp& ramp : snapshot.creases.ramps()) ramps.push_back(write(ramp));
  return {
      {"config", write(snapshot.config)},
      {"sheet", write(snapshot.sheet)},
      {"positions", numbers(snapshot.motion.positions)},
      {"velocities", numbers(snapshot.motion.velocities)},
      {"accelerations", numbers(snapshot.motion.accelerations)},
      {"acceleration_persistence", snapshot.motion.acceleration_persistence},
      {"rough", snapshot.motion.rough},
      {"creases", {{"ramps", ramps}, {"stiffness", snapshot.creases.stiffness()}}},
      {"compliance",
       {{"factor", snapshot.compliance.factor()},
        {"level", snapshot.compliance.level()},
        {"folding", snapshot.compliance.folding()}}},
      {"rest", {{"set", snapshot.rest.set()}, {"plastic", snapshot.rest.plastic()}}},
      {"in_plane", write(snapshot.in_plane)},
      {"held", write(snapshot.held)},
      {"obstacles", toJson(snapshot.obstacles)},
      {"grasps", toJson(snapshot.grasps)},
      {"memory",
       {{"contraction", snapshot.solver.contraction},
        {"unchecked", snapshot.solver.unchecked},
        {"pattern", {{"starts", snapshot.pattern.starts}, {"indices", snapshot.pattern.indices}}}}},
      {"counters", toJson(snapshot.counters)},
      {"time", snapshot.time},
      {"resting", snapshot.resting},
      {"edited", snapshot.edited},
      {"left_out", snapshot.left_out}};
}

Snapshot snapshotFrom(const Json& json) {
  try {
    return read(json);
  } catch (const std::exception& error) {
    reject("the snapshot is of no paper: ", error.what());
  }
}

}  // namespace shell_origami
