#include <shell_origami/node/publishers.h>

#include <shell_origami/node/conversions.h>

#include <geometry_msgs/WrenchStamped.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <string>

namespace shell_origami {

Publishers::Publishers(ros::NodeHandle& node, const NodeConfig& config,
                       std::function<msg::Edit()> whole_paper)
    : world_frame_(config.world_frame),
      frame_prefix_(config.frame_prefix),
      sheet_(node.advertise<msg::Sheet>("sheet", 10, true)),
      state_(node.advertise<msg::SheetState>("state", 100)),
      energy_(node.advertise<msg::Energy>("energy", 100)),
      markers_(node, {config.markers, config.colouring}),
      cloud_(node, config.cloud_points),
      view_(node.advertise<msg::View>("view", 1, true)),
      node_(node) {
  const auto send_paper = [whole_paper](const ros::SingleSubscriberPublisher& subscriber) {
    subscriber.publish(whole_paper());
  };
  edit_ = node.advertise<msg::Edit>("edits", 1000, send_paper);
}

std_msgs::Header Publishers::header(const ros::Time& stamp) const {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = world_frame_;
  return header;
}

bool Publishers::recorded() const {
  return sheet_.getNumSubscribers() > 0 && state_.getNumSubscribers() > 0 &&
         edit_.getNumSubscribers() > 0;
}

void Publishers::publish(const Session& session, bool paused, const StepReport& step,
                         double real_time_factor, const ros::Time& stamp) {
  const Simulation& simulation = session.simulation();
  const bool same_obstacles = obstacles_.sameShapes(simulation.obstacles());
  if (revision_ != session.revision() || !same_obstacles) publishSheet(session, stamp);
  const bool draw = markers_.heard();
  if (draw || state_.getNumSubscribers() > 0) {
    msg::SheetState state = stateMessage(session, paused, header(stamp));
    const MarkerPainter& painter = markers_.painter();
    addContactForces(simulation, painter.showsPressures(), painter.showsContactPoints(), state);
    state_.publish(state);
    if (draw) markers_.publish(state);
  }
  cloud_.publish(simulation.sheet(), simulation.positions(), header(stamp));
  if (energy_.getNumSubscribers() > 0) {
    energy_.publish(energyMessage(session, step, real_time_factor, header(stamp)));
  }
  publishWrenches(session, stamp);
  publishNamedWrenches(simulation, stamp);
  publishFrames(session, stamp);
}

void Publishers::publishSheet(const Session& session, const ros::Time& stamp) {
  const msg::Sheet message = sheetMessage(session, header(stamp));
  sheet_.publish(message);
  markers_.setSheet(message);
  cloud_.changeSheet();
  panels_ = findPanels(session.simulation().sheet());
  revision_ = session.revision();
  obstacles_ = session.simulation().obstacles();
}

void Publishers::publishFrames(const Session& session, const ros::Time& stamp) {
  if (stamp == frames_stamp_) return;  // tf2 warns of repeated stamps
  frames_stamp_ = stamp;
  const Simulation& simulation = session.simulation();
  const Positions& positions = simulation.positions();
  auto frames = paperFrames(simulation.sheet(), panels_, positions, header(stamp), frame_prefix_);
  const Vector3& target = camera_target_.follow(positions, markers_.painter().size());
  frames.push_back(viewFrame(target, header(stamp), frame_prefix_));
  broadcaster_.sendTransform(frames);
}

namespace {

/// TF allows more letters than names of topics do. (Below ~wrench/ these may begin with any.)
std::string topicFor(std::string frame) {
  for (char& letter : frame) {
    if (!std::isalnum(static_cast<unsigned char>(letter)) && letter != '/') letter = '_';
  }
  return frame;
}

}  // namespace

void Publishers::publishWrenches(const Session& session, const ros::Time& stamp) {
  const HeldVertices& held = session.simulation().held();
  std::set<std::string> holding;
  for (const auto& [frame, grip] : held.grips()) holding.insert(frame);
  if (!held.inPlace().empty()) holding.insert(world_frame_);
  for (auto wrench = wrenches_.begin(); wrench != wrenches_.end();) {
    wrench = holding.count(wrench->first) ? std::next(wrench) : wrenches_.erase(wrench);
  }
  for (const std::string& frame : holding) advertiseWrench(frame);
  const bool heard = std::any_of(wrenches_.begin(), wrenches_.end(), [](const auto& entry) {
    return entry.second.getNumSubscribers() > 0;
  });
  if (!heard) return;
  for (const auto& [frame, wrench] : session.simulation().holdingWrenches()) {
    geometry_msgs::WrenchStamped message;
    message.header = header(stamp);
    if (!frame.empty()) message.header.frame_id = frame;
    message.wrench = wrenchMessage(wrench);
    wrenches_.at(message.header.frame_id).publish(message);
  }
}

/// Those of obstacles and grasps, in the frames that carry them.
void Publishers::publishNamedWrenches(const Simulation& simulation, const ros::Time& stamp) {
  std::map<std::string, std::string> frames;
  for (const auto& [id, obstacle] : simulation.obstacles().all()) frames[id] = obstacle.frame;
  for (const auto& [id, grasp] : simulation.grasps().all()) frames[id] = grasp.frame;
  for (auto topic = named_wrenches_.begin(); topic != named_wrenches_.end();) {
    topic = frames.count(topic->first) ? std::next(topic) : named_wrenches_.erase(topic);
  }
  bool heard = false;
  for (const auto& [id, frame] : frames) {
    ros::Publisher& topic = named_wrenches_[id];
    if (!topic) topic = node_.advertise<geometry_msgs::WrenchStamped>("wrench/" + id, 100);
    heard = heard || topic.getNumSubscribers() > 0;
  }
  if (!heard) return;
  std::map<std::string, Wrench> wrenches = simulation.obstacleWrenches();
  wrenches.merge(simulation.graspWrenches());
  for (const auto& [id, wrench] : wrenches) {
    geometry_msgs::WrenchStamped message;
    message.header = header(stamp);
    if (!frames.at(id).empty()) message.header.frame_id = frames.at(id);
    message.wrench = wrenchMessage(wrench);
    named_wrenches_.at(id).publish(message);
  }
}

void Publishers::advertiseWrench(const std::string& frame) {
  if (wrenches_.count(frame)) return;
  wrenches_[frame] =
      node_.advertise<geometry_msgs::WrenchStamped>("wrench/" + topicFor(frame), 100);
}

void Publishers::publishEdit(msg::Edit edit, const ros::Time& stamp) {
  edit.header = header(stamp);
  edit_.publish(edit);
}

bool Publishers::publishView(const View& view, const ros::Time& stamp) {
  if (published_view_ && same(view, *published_view_)) return false;
  published_view_ = view;
  msg::View message;
  message.header = header(stamp);
  message.target_frame = frame_prefix_ + kViewFrame;
  message.yaw = view.yaw;
  message.pitch = view.pitch;
  message.distance = view.distance;
  view_.publish(message);
  return true;
}

}  // namespace shell_origami
