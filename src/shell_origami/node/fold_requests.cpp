#include <shell_origami/node/fold_requests.h>

#include <shell_origami/base/error.h>
#include <shell_origami/node/conversions.h>
#include <shell_origami/node/tf_utilities.h>
#include <shell_origami/origami/layer_stack.h>

#include <cmath>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

/// More layers than that no paper has.
constexpr std::uint32_t kMostLayers = 1000000;

bool isZero(const geometry_msgs::Point& p) { return p.x == 0 && p.y == 0 && p.z == 0; }

bool isGiven(const msg::Landmark& message) {
  return !message.name.empty() || !message.space.header.frame_id.empty() || !isZero(message.flat) ||
         !isZero(message.space.point);
}

/// The words that a field may be; an empty one is the first of them.
std::string wordOf(const std::string& field, const std::string& given,
                   const std::vector<std::string>& words) {
  if (given.empty()) return words.front();
  std::string all;
  for (const std::string& word : words) {
    if (given == word) return word;
    all += (all.empty() ? "" : " or ") + word;
  }
  reject(field, " is \"", given, "\", but must be ", all);
}

Landmark named(const std::string& field, const std::string& name, const LandmarkNames& names) {
  const auto found = names.find(name);
  if (found != names.end()) return {found->second.place, name};
  std::string all;
  for (const auto& entry : names) all += (all.empty() ? "" : ", ") + entry.first;
  reject(field, " is \"", name, "\", which is no name on this paper: ",
         all.empty() ? "no recipe has given any" : "the recipe's names are " + all);
}

FoldAxiom axiomFrom(const msg::FoldThrough::Request& request, const RequestContext& context) {
  static const std::map<std::string, std::size_t> kPoints{
      {"bring", 2}, {"edges", 4}, {"across", 4}, {"through", 3}};
  const auto axiom = kPoints.find(request.axiom);
  if (axiom == kPoints.end()) {
    reject("axiom is \"", request.axiom, "\", but must be bring or edges or across or through");
  }
  if (request.points.size() != axiom->second) {
    reject("points must hold ", axiom->second, " entries for ", request.axiom, ", but holds ",
           request.points.size());
  }
  std::vector<Landmark> p;
  for (const msg::Landmark& point : request.points) {
    p.push_back(landmarkFrom("points[" + std::to_string(p.size()) + "]", point, context));
  }
  if (request.axiom == "bring") return BringPoint{p[0], p[1]};
  if (request.axiom == "edges") return BringEdge{{p[0], p[1]}, {p[2], p[3]}};
  if (request.axiom == "across") return FoldAcross{{p[0], p[1]}, p[2], p[3]};
  return FoldAlong{{p[0], p[1]}, p[2]};
}

/// Rejects what has no effect as well: somebody meant something by it.
void readLayers(const msg::FoldThrough::Request& request, const RequestContext& context,
                FoldThrough& fold) {
  const std::string layers = wordOf("layers", request.layers, {"all", "top", "flap"});
  if (layers != "top" && request.count != 0) {
    reject("count is ", request.count, ", but belongs to layers \"top\", not \"", layers, "\"");
  }
  if (layers != "flap" && isGiven(request.flap)) {
    reject("flap belongs to layers \"flap\", not \"", layers, "\"");
  }
  if (layers == "top") {
    if (request.count == 0 || request.count > kMostLayers) {
      reject("count is ", request.count, ", but must be from 1 to ", kMostLayers);
    }
    fold.layers = FoldLayers::kTop;
    fold.count = static_cast<int>(request.count);
  } else if (layers == "flap") {
    fold.layers = FoldLayers::kFlap;
    fold.flap = landmarkFrom("flap", request.flap, context);
  }
}

}  // namespace

Landmark landmarkFrom(const std::string& field, const msg::Landmark& message,
                      const RequestContext& context) {
  const geometry_msgs::Point &flat = message.flat, &space = message.space.point;
  const std::string& frame = message.space.header.frame_id;
  requireFinite(field + ".flat", flat);
  requireFinite(field + ".space", space);
  if (frame.empty() && !isZero(space)) {
    reject(field, ".space is (", space.x, ", ", space.y, ", ", space.z,
           "), but its header names no frame");
  }
  if ((message.name.empty() ? 0 : 1) + (frame.empty() ? 0 : 1) + (isZero(flat) ? 0 : 1) > 1) {
    reject(field, " takes one of name, flat and space, not more");
  }
  if (!message.name.empty())
    return named(field, message.name, context.session.journal().origin().names);
  if (!frame.empty()) {
    const Simulation& simulation = context.session.simulation();
    const Vector3 point = toWorld(field, {space.x, space.y, space.z}, message.space.header,
                                  context.world, context.tf);
    return {nearestFlatPoint(point, simulation.sheet(), simulation.positions())};
  }
  if (flat.z != 0) {
    reject(field, ".flat is (", flat.x, ", ", flat.y, ", ", flat.z,
           "), but its z must be 0: it is on the flat sheet, not on folded paper");
  }
  return {Vector2(flat.x, flat.y)};
}

FoldThrough foldThroughFrom(const msg::FoldThrough::Request& request,
                            const RequestContext& context) {
  FoldThrough fold;
  fold.axiom = axiomFrom(request, context);
  readLayers(request, context, fold);
  fold.behind = wordOf("way", request.way, {"front", "behind"}) == "behind";
  if (request.angle != 0) fold.angle = request.angle;
  if (!(fold.angle > 0 && fold.angle < M_PI)) {
    reject("angle is ", request.angle, " rad, but must be inside (0, pi), or 0 for 178 degrees");
  }
  if (!(request.duration >= 0 && std::isfinite(request.duration))) {
    reject("duration is ", request.duration, " s, but must be positive, or 0 for fold_duration");
  }
  if (request.duration != 0) fold.duration = request.duration;
  if (!request.name.empty()) checkCreaseName(request.name);
  fold.name = request.name;
  return fold;
}

Viewpoint viewFrom(const geometry_msgs::Vector3& viewer, const Session& session) {
  const Vector3 from(viewer.x, viewer.y, viewer.z);
  return from.isZero(0) ? session.view() : viewFrom(from, session.simulation());
}

std::vector<std::string> framesOf(const msg::FoldThrough::Request& request) {
  std::vector<std::string> frames{request.flap.space.header.frame_id};
  for (const msg::Landmark& point : request.points) {
    frames.push_back(point.space.header.frame_id);
  }
  return frames;
}

std::vector<msg::FlatSegment> segmentMessages(const FoldPlan& plan) {
  std::vector<msg::FlatSegment> segments;
  for (const LayerFold& layer : plan.layers) {
    msg::FlatSegment segment;
    segment.start = pointMessage({layer.line[0].x(), layer.line[0].y(), 0});
    segment.end = pointMessage({layer.line[1].x(), layer.line[1].y(), 0});
    segment.angle = layer.angle;
    segment.panel = static_cast<std::uint32_t>(layer.panel);
    segments.push_back(segment);
  }
  return segments;
}

}  // namespace shell_origami
