/// \file
/// Reads places on folded paper, and folds through its layers, from requests.
#pragma once

#include <shell_origami/node/messages.h>
#include <shell_origami/node/session.h>

#include <tf2_ros/buffer.h>

#include <string>
#include <vector>

namespace shell_origami {

/// Where the places of a request are.
struct RequestContext {
  const Session& session;
  const std::string& world;  ///< the frame of the paper's positions
  const tf2_ros::Buffer& tf;
};

// Each throws std::invalid_argument with a message that names the field and its value.

/// \param field  that holds the landmark, for messages
Landmark landmarkFrom(const std::string& field, const msg::Landmark& message,
                      const RequestContext& context);
FoldThrough foldThroughFrom(const msg::FoldThrough::Request& request,
                            const RequestContext& context);
/// Returns the viewpoint of a request: the session's own where the direction is zero.
Viewpoint viewFrom(const geometry_msgs::Vector3& viewer, const Session& session);
/// Returns the frames in which points of a request are given.
std::vector<std::string> framesOf(const msg::FoldThrough::Request& request);

std::vector<msg::FlatSegment> segmentMessages(const FoldPlan& plan);

}  // namespace shell_origami
