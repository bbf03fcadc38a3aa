/// \file
/// The parameters depth/...
#pragma once

#include <shell_origami/node/sense/depth_renderer.h>

#include <string>

namespace shell_origami {

struct DepthConfig {
  std::string frame = "depth_optical_frame";  ///< of the camera
  double rate = 10;                           ///< of images, in ROS time [Hz]
  PinholeCamera camera;
};

}  // namespace shell_origami
