/// \file
/// A depth camera's messages.
#pragma once

#include <shell_origami/node/sense/depth_renderer.h>

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <vector>

namespace shell_origami {

sensor_msgs::CameraInfo cameraInfoMessage(const PinholeCamera& camera,
                                          const std_msgs::Header& header);

/// Writes an image of one or three numbers for each pixel: 32FC1 or 32FC3.
/// \param image  whose memory is used again: fresh memory costs as much as drawing
void writeImage(const PinholeCamera& camera, const std::vector<float>& numbers,
                const std_msgs::Header& header, sensor_msgs::Image& image);

}  // namespace shell_origami
