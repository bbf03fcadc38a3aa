#include <shell_origami/node/conversions.h>
#include <shell_origami/node/obstacle_requests.h>
#include <shell_origami/node/request_answer.h>
#include <shell_origami/node/tf_utilities.h>

#include <string>

// The services by which paper is held, and obstacles put beside it.

namespace shell_origami {
namespace {

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

/// Holds the vertices that a request chooses, by `carried` along with the frame that it names or by
/// `still` in the world. Returns its answer: that it is `doing` so.
template <class Request, class Response, class Still, class Carried>
std::string Services::hold(const Request& request, Response& response, const std::string& doing,
                           Still still, Carried carried) {
  const std::string& frame = request.frame_id;
  const bool moves = waitForCarrier(frame);
  PinWhere where = pinWhere(request);
  const std_msgs::Header& header = request.center.header;
  if (std::holds_alternative<Ball>(where)) waitForFrame(header.frame_id);
  const EditRecord held = inNodeThread([=]() mutable {
    if (auto* ball = std::get_if<Ball>(&where)) {
      ball->center = toWorld("center", ball->center, header, origami_.config().world_frame, tf_);
    }
    return moves ? carried(where, frame) : still(where);
  });
  response.vertices = vertexIds(held.vertices);
  response.edit = held.number;
  return doing + " " + vertexCount(held.vertices.size()) + (moves ? " by frame " + frame : "");
}

bool Services::pin(msg::Pin::Request& request, msg::Pin::Response& response) {
  return answer("pin", response, [&] {
    return hold(
        request, response, "holding",
        [this](const PinWhere& where) { return origami_.apply(PinEdit{where}); },
        [this](const PinWhere& where, const std::string& frame) {
          return held_frames_.pin(where, frame);
        });
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
    const auto edit = [id = request.id, firmness = firmnessOf(request)](const PinWhere& where) {
      return GraspEdit{id, where, firmness, "", {}};
    };
    return hold(
        request, response, "grasping",
        [this, edit](const PinWhere& where) { return origami_.apply(edit(where)); },
        [this, edit](const PinWhere& where, const std::string& frame) {
          return held_frames_.grasp(edit(where), frame);
        });
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
