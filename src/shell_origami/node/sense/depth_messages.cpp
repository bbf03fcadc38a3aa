#include <shell_origami/node/sense/depth_messages.h>

#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>

#include <cstring>

namespace shell_origami {

sensor_msgs::CameraInfo cameraInfoMessage(const PinholeCamera& camera,
                                          const std_msgs::Header& header) {
  const double f = camera.focal_length, cx = camera.centerColumn(), cy = camera.centerRow();
  sensor_msgs::CameraInfo message;
  message.header = header;
  message.width = static_cast<std::uint32_t>(camera.width);
  message.height = static_cast<std::uint32_t>(camera.height);
  message.distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
  message.D.assign(5, 0);
  message.K = {f, 0, cx, 0, f, cy, 0, 0, 1};
  message.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  message.P = {f, 0, cx, 0, 0, f, cy, 0, 0, 0, 1, 0};
  return message;
}

void writeImage(const PinholeCamera& camera, const std::vector<float>& numbers,
                const std_msgs::Header& header, sensor_msgs::Image& image) {
  const std::size_t bytes = numbers.size() * sizeof(float);
  const bool single = numbers.size() == static_cast<std::size_t>(camera.width) * camera.height;
  image.header = header;
  image.width = static_cast<std::uint32_t>(camera.width);
  image.height = static_cast<std::uint32_t>(camera.height);
  image.encoding =
      single ? sensor_msgs::image_encodings::TYPE_32FC1 : sensor_msgs::image_encodings::TYPE_32FC3;
  image.step = static_cast<std::uint32_t>(bytes / camera.height);
  image.data.resize(bytes);
  std::memcpy(image.data.data(), numbers.data(), bytes);
}

}  // namespace shell_origami
