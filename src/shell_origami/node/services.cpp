#include <shell_origami/node/services.h>

#include <shell_origami/base/error.h>
#include <shell_origami/base/files.h>
#include <shell_origami/node/conversions.h>
#include <shell_origami/node/request_answer.h>
#include <shell_origami/node/tf_utilities.h>
#include <shell_origami/origami/layer_stack.h>
#include <shell_origami/origami/recipe_writer.h>
#include <shell_origami/origami/report.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

constexpr std::uint32_t kMostSteps = 100000;
/// So many requests may wait at the same time.
constexpr std::uint32_t kWaitingThreads = 16;
/// How long a request waits for a frame that TF does not know yet [s], and how often it looks.
constexpr double kFrameWait = 0.5, kFrameLook = 0.01;
/// Where a crease rests that is folded to this angle [rad].
std::string restAngle(double angle) {
  const double rest = std::clamp(angle, -kLargestRestAngle, kLargestRestAngle);
  const std::string text = std::to_string(rest) + " rad";
  return rest == angle ? text : text + ", the most that a crease rests at";
}

/// The creases of several folds, each once.
std::vector<std::uint32_t> creaseIds(const std::vector<EditRecord>& folds) {
  std::vector<std::uint32_t> ids;
  for (const EditRecord& fold : folds) {
    for (std::uint32_t id : fold.crease_ids) {
      if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
    }
  }
  return ids;
}

/// Writes what was done as a recipe. Returns what is to be said of it.
std::string saveRecipe(const Session& session, const std::string& path) {
  const Journal& journal = session.journal();
  const auto steps = journal.written(session.simulation().folding());
  writeFiles({{path, recipeText(journal.origin(), steps)}});
  std::string frames;
  for (const std::string& frame : journal.frames()) frames += (frames.empty() ? "" : ", ") + frame;
  const std::string held = "; a recipe has no frames, and holds in place what was carried by ";
  return "wrote " + path + (frames.empty() ? "" : held + frames);
}

/// The path of a file on the node's machine. A relative one is relative to the node's working
/// directory, which messages then show.
std::string filePath(const std::string& path) {
  if (path.empty()) reject("path is empty");
  return std::filesystem::absolute(expandedPath(path)).string();
}

}  // namespace

Services::Services(ros::NodeHandle& node, OrigamiNode& origami, HeldFrames& held_frames,
                   const tf2_ros::Buffer& tf)
    : origami_(origami), held_frames_(held_frames), tf_(tf), spinner_(kWaitingThreads, &queue_) {
  ros::NodeHandle waiting(node);
  waiting.setCallbackQueue(&queue_);
  servers_ = {
      node.advertiseService("fold", &Services::fold, this),
      waiting.advertiseService("fold_through", &Services::foldThrough, this),
      waiting.advertiseService("layers", &Services::layers, this),
      node.advertiseService("turn_over", &Services::turnOver, this),
      waiting.advertiseService("pin", &Services::pin, this),
      node.advertiseService("unpin", &Services::unpin, this),
      waiting.advertiseService("grasp", &Services::grasp, this),
      node.advertiseService("release", &Services::release, this),
      node.advertiseService("add_vertex", &Services::addVertex, this),
      waiting.advertiseService("add_obstacle", &Services::addObstacle, this),
      node.advertiseService("remove_obstacle", &Services::removeObstacle, this),
      waiting.advertiseService("load", &Services::load, this),
      node.advertiseService("save", &Services::save, this),
      waiting.advertiseService("step", &Services::step, this),
      waiting.advertiseService("settle", &Services::settle, this),
      node.advertiseService("pause", &Services::pause, this),
      node.advertiseService("resume", &Services::resume, this),
      node.advertiseService("reset", &Services::reset, this),
      node.advertiseService("undo", &Services::undo, this),
  };
  spinner_.start();
}

Services::~Services() {
  ending_ = true;
  spinner_.stop();
}

std::string Services::whilePaused() const {
  return origami_.paused() ? "; the node is paused: call ~resume to let it move" : "";
}

/// A frame that was first heard of a moment ago may be on its way.
void Services::waitForFrame(const std::string& frame) const {
  if (frame.empty() || frame[0] == '/') return;
  const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(kFrameWait);
  while (!tf_.canTransform(origami_.config().world_frame, frame, ros::Time()) &&
         ros::SteadyTime::now() < end && !ending_) {
    ros::WallDuration(kFrameLook).sleep();
  }
}

bool Services::fold(msg::Fold::Request& request, msg::Fold::Response& response) {
  return answer("fold", response, [&] {
    const EditRecord fold = origami_.apply(foldEdit(request));
    response.crease_ids = fold.crease_ids;
    response.vertices = vertexIds(fold.vertices);
    response.revision = fold.revision;
    response.edit = fold.number;
    const std::string parts = fold.parts == 1 ? ""
                                              : ", the " + std::to_string(fold.parts) +
                                                    " parts of the line that lie on the paper,";
    return "folding " + count(fold.crease_ids.size(), "crease", "creases") + " of " +
           vertexCount(fold.vertices.size()) + parts + " to " + restAngle(request.angle) +
           whilePaused();
  });
}

RequestContext Services::context() const {
  return {origami_.session(), origami_.config().world_frame, tf_};
}

bool Services::foldThrough(msg::FoldThrough::Request& request,
                           msg::FoldThrough::Response& response) {
  return answer("fold_through", response, [&] {
    for (const std::string& frame : framesOf(request)) waitForFrame(frame);
    response = inNodeThread([this, request] { return foldThroughNow(request); });
    return response.message;
  });
}

msg::FoldThrough::Response Services::foldThroughNow(const msg::FoldThrough::Request& request) {
  const Session& session = origami_.session();
  const FoldThrough fold = foldThroughFrom(request, context());
  const Viewpoint view = viewFrom(request.viewer, session);
  msg::FoldThrough::Response response;
  const auto lines = [&](const FoldPlan& plan) {
    response.segments = segmentMessages(plan);
    return count(plan.layers.size(), "line", "lines");
  };
  if (request.dry_run) {
    response.message = "would fold along " + lines(planFold(fold, view, session.simulation())) +
                       " by " + restAngle(fold.angle) + "; nothing is changed";
  } else {
    const FoldThroughRecord made = origami_.foldThrough(fold, view);
    response.crease_ids = creaseIds(made.folds);
    response.message =
        "folding along " + lines(made.plan) + " by " + restAngle(fold.angle) + whilePaused();
  }
  response.revision = session.revision();
  response.edit = session.edits();
  return response;
}

bool Services::layers(msg::Layers::Request& request, msg::Layers::Response& response) {
  return answer("layers", response, [&] {
    waitForFrame(request.point.space.header.frame_id);
    response = inNodeThread([this, request] { return layersNow(request); });
    return count(response.panels.size(), "layer", "layers");
  });
}

msg::Layers::Response Services::layersNow(const msg::Layers::Request& request) const {
  const Session& session = origami_.session();
  const Landmark point = landmarkFrom("point", request.point, context());
  const Viewpoint view = viewFrom(request.viewer, session);
  msg::Layers::Response response;
  double before = 0;
  for (const StackedLayer& layer : layersAt(point, view, session.simulation())) {
    response.panels.push_back(static_cast<std::uint32_t>(layer.panel));
    response.flat_points.push_back(pointMessage({layer.flat.x(), layer.flat.y(), 0}));
    response.gaps.push_back(layer.depth - before);
    before = layer.depth;
  }
  return response;
}

bool Services::turnOver(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer("turn_over", response, [&] {
    origami_.turnOver();
    return std::string("the other side of the paper is looked at from now on");
  });
}

bool Services::addVertex(msg::AddVertex::Request& request, msg::AddVertex::Response& response) {
  return answer("add_vertex", response, [&] {
    const EditRecord added =
        origami_.apply(AddVertexEdit{{request.edge[0], request.edge[1]}, request.fraction});
    response.vertex = static_cast<std::uint32_t>(added.vertices.front());
    response.revision = added.revision;
    response.edit = added.number;
    return "added vertex " + std::to_string(response.vertex);
  });
}

bool Services::load(msg::Load::Request& request, msg::Load::Response& response) {
  return answer("load", response, [&] {
    const std::string path = filePath(request.path);
    if (!(request.scale >= 0 && std::isfinite(request.scale))) {
      reject("scale is ", request.scale, ", but must be positive, or 0 for the file's own unit");
    }
    response = wait(
        inNodeThread([this, path, scale = request.scale] { return origami_.load(path, scale); }));
    return "loaded " + path + ": " + vertexCount(response.vertices) + ", " +
           count(response.creases.size(), "crease", "creases") + response.message;
  });
}

bool Services::save(msg::Save::Request& request, msg::Save::Response& response) {
  return answer("save", response, [&] {
    const std::string path = filePath(request.path);
    if (isRecipe(path)) return saveRecipe(origami_.session(), path);
    savePaper(origami_.session().simulation(), path);
    return "wrote " + path;
  });
}

bool Services::step(msg::Step::Request& request, msg::Step::Response& response) {
  return answer("step", response, [&] {
    const std::uint32_t steps = request.steps;
    response.time = wait(inNodeThread([this, steps] {
      if (!origami_.paused()) reject("step needs the node to be paused");
      if (steps == 0 || steps > kMostSteps) {
        reject("steps is ", steps, ", but must be from 1 to ", kMostSteps);
      }
      return origami_.takeSteps(steps);
    }));
    return "took " + count(steps, "step", "steps");
  });
}

bool Services::settle(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer("settle", response, [&] {
    const EditRecord settled = wait(inNodeThread([this] { return origami_.settle(); }));
    return "the paper is at rest, after " +
           count(settled.report.newton_iterations, "iteration", "iterations");
  });
}

bool Services::pause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer("pause", response, [&] {
    origami_.pause();
    return std::string("paused");
  });
}

bool Services::resume(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer("resume", response, [&] {
    origami_.resume();
    return std::string("running");
  });
}

bool Services::reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer("reset", response, [&] {
    origami_.reset();
    return "the paper is as it was loaded" + whilePaused();
  });
}

bool Services::undo(msg::Undo::Request& request, msg::Undo::Response& response) {
  return answer("undo", response, [&] {
    if (request.since != 0 && request.edits != 0) {
      reject("edits is ", request.edits, " and since is ", request.since,
             ", but only one of them may be given");
    }
    const std::uint64_t edit = request.since != 0 ? origami_.undoFrom(request.since)
                                                  : origami_.undo(std::max(1U, request.edits));
    response.revision = origami_.session().revision();
    response.edit = origami_.session().edits();
    return "the paper is as it was before edit " + std::to_string(edit) + whilePaused();
  });
}

}  // namespace shell_origami
