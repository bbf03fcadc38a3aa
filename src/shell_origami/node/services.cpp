#include <shell_origami/node/services.h>

#include <shell_origami/base/error.h>
#include <shell_origami/node/conversions.h>
#include <shell_origami/node/message_text.h>
#include <shell_origami/node/tf_utilities.h>
#include <shell_origami/origami/report.h>

#include <filesystem>
#include <string>

namespace shell_origami {
namespace {

/// The node answers no other request while it takes steps for one.
constexpr std::uint32_t kMostSteps = 100000;

/// Answers with the sentence that the action returns, or with why it refuses.
template <class Response, class Action>
bool answer(const char* service, Response& response, Action action) {
  try {
    response.message = asMessageText(action());
    response.success = true;
    ROS_INFO("%s: %s", service, response.message.c_str());
  } catch (const std::exception& error) {
    response = Response();
    response.message = asMessageText(error.what());
    ROS_WARN("%s refused: %s", service, response.message.c_str());
  }
  return true;
}

std::string count(std::size_t number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

std::string vertexCount(std::size_t number) { return count(number, "vertex", "vertices"); }

void requirePath(const std::string& path) {
  if (path.empty()) reject("path is empty");
}

}  // namespace

Services::Services(ros::NodeHandle& node, OrigamiNode& origami, HeldFrames& held_frames,
                   const tf2_ros::Buffer& tf)
    : origami_(origami), held_frames_(held_frames), tf_(tf) {
  servers_ = {
      node.advertiseService("fold", &Services::fold, this),
      node.advertiseService("pin", &Services::pin, this),
      node.advertiseService("unpin", &Services::unpin, this),
      node.advertiseService("add_vertex", &Services::addVertex, this),
      node.advertiseService("load", &Services::load, this),
      node.advertiseService("save", &Services::save, this),
      node.advertiseService("step", &Services::step, this),
      node.advertiseService("settle", &Services::settle, this),
      node.advertiseService("pause", &Services::pause, this),
      node.advertiseService("resume", &Services::resume, this),
      node.advertiseService("reset", &Services::reset, this),
  };
}

bool Services::fold(msg::Fold::Request& request, msg::Fold::Response& response) {
  return answer("fold", response, [&] {
    Simulation& simulation = origami_.session().simulation();
    const FoldResult result = simulation.fold(foldRequest(request));
    response.crease_ids = result.crease_ids;
    response.vertices = vertexIds(result.vertices);
    response.revision = origami_.session().revision();
    const std::string parts = result.parts == 1 ? ""
                                                : ", the " + std::to_string(result.parts) +
                                                      " parts of the line that lie on the paper,";
    return "folding " + count(result.crease_ids.size(), "crease", "creases") + " of " +
           vertexCount(result.vertices.size()) + parts + " to " + std::to_string(request.angle) +
           " rad";
  });
}

bool Services::pin(msg::Pin::Request& request, msg::Pin::Response& response) {
  return answer("pin", response, [&] {
    PinWhere where = pinWhere(request);
    if (auto* ball = std::get_if<Ball>(&where)) {
      ball->center = toWorld("center", ball->center, request.center.header,
                             origami_.config().world_frame, tf_);
    }
    const bool carried =
        !request.frame_id.empty() && request.frame_id != origami_.config().world_frame;
    const std::vector<int> vertices = carried ? held_frames_.pin(where, request.frame_id)
                                              : origami_.session().simulation().pin(where);
    response.vertices = vertexIds(vertices);
    return "holding " + vertexCount(vertices.size()) +
           (carried ? " by frame " + request.frame_id : "");
  });
}

bool Services::unpin(msg::Unpin::Request& request, msg::Unpin::Response& response) {
  return answer("unpin", response, [&] {
    const std::vector<int> vertices =
        origami_.session().simulation().unpin(vertexIds(request.vertices));
    response.vertices = vertexIds(vertices);
    return "let go of " + vertexCount(vertices.size());
  });
}

bool Services::addVertex(msg::AddVertex::Request& request, msg::AddVertex::Response& response) {
  return answer("add_vertex", response, [&] {
    const int vertex = origami_.session().simulation().addVertex(request.edge[0], request.edge[1],
                                                                 request.fraction);
    response.vertex = static_cast<std::uint32_t>(vertex);
    response.revision = origami_.session().revision();
    return "added vertex " + std::to_string(vertex);
  });
}

bool Services::load(msg::Load::Request& request, msg::Load::Response& response) {
  return answer("load", response, [&] {
    requirePath(request.path);
    origami_.load(request.path);
    const Sheet& sheet = origami_.session().simulation().sheet();
    response.vertices = static_cast<std::uint32_t>(sheet.vertexCount());
    response.triangles = static_cast<std::uint32_t>(sheet.triangles().size());
    for (const Crease& crease : sheet.creases()) response.creases.push_back(crease.name);
    response.revision = origami_.session().revision();
    return "loaded " + request.path + ": " + vertexCount(response.vertices) + ", " +
           count(response.creases.size(), "crease", "creases");
  });
}

bool Services::save(msg::Save::Request& request, msg::Save::Response& response) {
  return answer("save", response, [&] {
    requirePath(request.path);
    savePaper(origami_.session().simulation(), request.path);
    return "wrote " + std::filesystem::absolute(request.path).string();
  });
}

bool Services::step(msg::Step::Request& request, msg::Step::Response& response) {
  return answer("step", response, [&] {
    if (!origami_.paused()) reject("step needs the node to be paused");
    if (request.steps == 0 || request.steps > kMostSteps) {
      reject("steps is ", request.steps, ", but must be from 1 to ", kMostSteps);
    }
    const std::uint32_t taken = origami_.takeSteps(request.steps);
    if (taken < request.steps) {
      reject("stopped after ", count(taken, "step", "steps"), ": ", origami_.lastStep().failure);
    }
    response.time = origami_.session().time();
    return "took " + count(taken, "step", "steps");
  });
}

bool Services::settle(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer("settle", response, [&] {
    const StepReport report = origami_.session().simulation().settle();
    if (!report.converged) reject(report.failure);
    return "the paper is at rest, after " +
           count(report.newton_iterations, "iteration", "iterations");
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
    return std::string("the paper is as it was loaded");
  });
}

}  // namespace shell_origami
