#include <shell_origami/node/draw/marker_publisher.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Less than a tenth of a pixel where the paper fills the window, over the paper's size.
constexpr double kStill = 1e-5;
/// How often a drawing is sent again.
constexpr int kRepeats = 5;
constexpr double kSameColor = 0.01;

bool near(const geometry_msgs::Point& p, const geometry_msgs::Point& q, double distance) {
  return std::max({std::abs(p.x - q.x), std::abs(p.y - q.y), std::abs(p.z - q.z)}) <= distance;
}

bool near(const std_msgs::ColorRGBA& a, const std_msgs::ColorRGBA& b, double difference) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b),
                   std::abs(a.a - b.a)}) <= difference;
}

template <class Entry>
bool allNear(const std::vector<Entry>& a, const std::vector<Entry>& b, double difference) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const Entry& p, const Entry& q) { return near(p, q, difference); });
}

bool looksTheSame(const Marker& a, const Marker& b, double distance) {
  return a.ns == b.ns && a.id == b.id && a.action == b.action && a.text == b.text &&
         a.header.frame_id == b.header.frame_id && a.scale == b.scale &&
         near(a.pose.position, b.pose.position, distance) && near(a.color, b.color, kSameColor) &&
         allNear(a.points, b.points, distance) && allNear(a.colors, b.colors, kSameColor);
}

}  // namespace

bool looksTheSame(const MarkerArray& a, const MarkerArray& b, double distance) {
  return std::equal(a.markers.begin(), a.markers.end(), b.markers.begin(), b.markers.end(),
                    [&](const Marker& p, const Marker& q) { return looksTheSame(p, q, distance); });
}

MarkerPublisher::MarkerPublisher(ros::NodeHandle& node, MarkerPainter painter)
    : painter_(std::move(painter)) {
  const auto begin = [this](const ros::SingleSubscriberPublisher&) { beginToSend(); };
  markers_ = node.advertise<MarkerArray>("markers", 5, begin, {}, {}, true);
}

void MarkerPublisher::beginToSend() {
  heard_since_ = ros::SteadyTime::now();
  sent_.reset();
}

void MarkerPublisher::setSheet(const msg::Sheet& sheet) {
  painter_.setSheet(sheet);
  sent_.reset();
}

void MarkerPublisher::publish(const msg::SheetState& state) {
  MarkerArray drawing = painter_.draw(state);
  if (sent_ && looksTheSame(drawing, *sent_, kStill * painter_.size())) {
    if (repeats_ == kRepeats) return;
    ++repeats_;
  } else {
    repeats_ = 0;
  }
  markers_.publish(drawing);
  sent_ = std::move(drawing);
}

}  // namespace shell_origami
