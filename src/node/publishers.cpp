#include "node/publishers.h"

#include "node/conversions.h"

namespace shell_origami {

Publishers::Publishers(ros::NodeHandle& node, const NodeConfig& config)
    : world_frame_(config.world_frame),
      painter_(config.vertex_ids, config.colouring),
      sheet_(node.advertise<msg::Sheet>("sheet", 10, true)),
      state_(node.advertise<msg::SheetState>("state", 100)),
      energy_(node.advertise<msg::Energy>("energy", 100)),
      markers_(node.advertise<visualization_msgs::MarkerArray>("markers", 5)) {
  const auto send_edits = [this](const ros::SingleSubscriberPublisher& subscriber) {
    for (const msg::Edit& edit : edits_) subscriber.publish(edit);
  };
  edit_ = node.advertise<msg::Edit>("edits", 1000, send_edits);
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

void Publishers::publish(const Paper& paper, const StepReport& step, double real_time_factor,
                         const ros::Time& stamp) {
  if (revision_ != paper.revision()) publishSheet(paper, stamp);
  const bool draw = markers_.getNumSubscribers() > 0;
  if (draw || state_.getNumSubscribers() > 0) {
    const msg::SheetState state = stateMessage(paper, header(stamp));
    state_.publish(state);
    if (draw) markers_.publish(painter_.draw(state));
  }
  if (energy_.getNumSubscribers() > 0) {
    energy_.publish(energyMessage(paper, step, real_time_factor, header(stamp)));
  }
  publishFrames(paper, stamp);
}

void Publishers::publishSheet(const Paper& paper, const ros::Time& stamp) {
  const msg::Sheet message = sheetMessage(paper, header(stamp));
  sheet_.publish(message);
  painter_.setSheet(message);
  panels_ = findPanels(paper.simulation().sheet());
  revision_ = paper.revision();
}

void Publishers::publishFrames(const Paper& paper, const ros::Time& stamp) {
  if (stamp == frames_stamp_) return;  // tf2 warns of repeated stamps
  frames_stamp_ = stamp;
  const Simulation& simulation = paper.simulation();
  broadcaster_.sendTransform(
      paperFrames(simulation.sheet(), panels_, simulation.positions(), header(stamp)));
}

void Publishers::publishEdit(msg::Edit edit, const ros::Time& stamp) {
  edit.header = header(stamp);
  if (edit.kind == msg::Edit::LOAD || edit.kind == msg::Edit::RESET) edits_.clear();
  edits_.push_back(edit);
  edit_.publish(edit);
}

}  // namespace shell_origami
