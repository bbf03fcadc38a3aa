/// \file
/// Reads obstacles from requests.
#pragma once

#include <shell_origami/node/messages.h>
#include <shell_origami/origami/edit.h>

namespace shell_origami {

/// Returns the obstacle of a request, in the frame that its pose is given in.
/// \throws std::invalid_argument with a message that names the field and its value
AddObstacleEdit obstacleEdit(const msg::AddObstacle::Request& request);

}  // namespace shell_origami
