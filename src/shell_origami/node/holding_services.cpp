#include <shell_origami/node/conversions.h>
#include <shell_origami/node/obstacle_requests.h>
#include <shell_origami/node/request_answer.h>
#include <shell_origami/node/tf_utilities.h>

#include <string>

// The services by which paper is held, and obstacles put beside it.

namespace shell_origami {
namespace {

/// The choice of vertices of a grasp, as that of a pin.
msg::Pin::Request pinRequest(const msg::Grasp::Request& request) {
  msg::Pin::Request pin;
  pin.vertices = request.vertices;
  pin.points = request.points;
  pin.region = request.region;
  pin.center = request.center;
  pin.radius = request.radius;
  return pin;
}

/// Zeros stand for what is by default.
Firmness firmnessOf(const msg::Grasp::Request& request) {
  Firmness firmness;
  if (request.stiffness != 0) firmness.stiffness = request.stiffness;
  if (request.max_force != 0) firmness.max_force = request.max_force;
  if (request.reach != 0) firmness.reach = request.reach;
  checkFirmness(firmness);
  return firmness;
}

}  // namespace

/// Returns whether a frame is to carry something, and then waits for it.
/// \throws std::invalid_argument where it is the paper's own
bool Services::waitForCarrier(const std::string& frame) const {
  if (frame.empty() || frame == origami_.config().world_frame) return false;
  held_frames_.requireForeign(frame);
  waitForFrame(frame);
  return true;
}

/// Takes the center of a ball into the world.
PinWhere Services::inWorld(PinWhere where, const std_msgs::Header& header) const {
  if (auto* ball = std::get_if<Ball>(&where)) {
    ball->center = toWorld("center", ball->center, header, origami_.config().world_frame, tf_);
  }
  return where;
}

bool Services::pin(msg::Pin::Request& request, msg::Pin::Response& response) {
  return answer("pin", response, [&] {
    const bool carried = waitForCarrier(request.frame_id);
    PinWhere where = pinWhere(request);
    if (std::holds_alternative<Ball>(where)) waitForFrame(request.center.header.frame_id);
    const EditRecord pin = inNodeThread(
        [this, carried, where, header = request.center.header, frame = request.frame_id] {
          const PinWhere there = inWorld(where, header);
          return carried ? held_frames_.pin(there, frame) : origami_.apply(PinEdit{there});
        });
    response.vertices = vertexIds(pin.vertices);
    response.edit = pin.number;
    return "holding " + vertexCount(pin.vertices.size()) +
           (carried ? " by frame " + request.frame_id : "");
  });
}

bool Services::unpin(msg::Unpin::Request& request, msg::Unpin::Response& response) {
  return answer("unpin", response, [&] {
    UnpinEdit edit;
    if (!request.vertices.empty()) edit.where = vertexIds(request.vertices);
    const EditRecord unpin = origami_.apply(edit);
    response.vertices = vertexIds(unpin.vertices);
    response.edit = unpin.number;
    return "let go of " + vertexCount(unpin.vertices.size());
  });
}

bool Services::grasp(msg::Grasp::Request& request, msg::Grasp::Response& response) {
  return answer("grasp", response, [&] {
    const bool carried = waitForCarrier(request.frame_id);
    GraspEdit edit{request.id, pinWhere(pinRequest(request)), firmnessOf(request), "", {}};
    if (std::holds_alternative<Ball>(edit.where)) waitForFrame(request.center.header.frame_id);
    const EditRecord grasp = inNodeThread(
        [this, carried, edit, header = request.center.header, frame = request.frame_id]() mutable {
          edit.where = inWorld(edit.where, header);
          return carried ? held_frames_.grasp(edit, frame) : origami_.apply(edit);
        });
    response.vertices = vertexIds(grasp.vertices);
    response.edit = grasp.number;
    return "grasping " + vertexCount(grasp.vertices.size()) +
           (carried ? " by frame " + request.frame_id : "");
  });
}

bool Services::release(msg::Release::Request& request, msg::Release::Response& response) {
  return answer("release", response, [&] {
    const EditRecord released = origami_.apply(ReleaseEdit{request.ids});
    response.ids = released.ids;
    response.edit = released.number;
    return "let go " + count(released.ids.size(), "grasp", "grasps");
  });
}

bool Services::addObstacle(msg::AddObstacle::Request& request,
                           msg::AddObstacle::Response& response) {
  return answer("add_obstacle", response, [&] {
    const AddObstacleEdit obstacle = obstacleEdit(request);
    const std::string& frame = request.pose.header.frame_id;
    const bool carried = waitForCarrier(frame);
    const EditRecord added = inNodeThread([this, carried, obstacle, frame] {
      return carried ? held_frames_.add(obstacle, frame) : origami_.apply(obstacle);
    });
    response.edit = added.number;
    return "added obstacle " + request.id + (carried ? ", carried by frame " + frame : "");
  });
}

bool Services::removeObstacle(msg::RemoveObstacle::Request& request,
                              msg::RemoveObstacle::Response& response) {
  return answer("remove_obstacle", response, [&] {
    const EditRecord removed = origami_.apply(RemoveObstacleEdit{request.ids});
    response.ids = removed.ids;
    response.edit = removed.number;
    return "took away " + count(removed.ids.size(), "obstacle", "obstacles");
  });
}

}  // namespace shell_origami
