/// \file
/// TF frames that hold the paper and carry it along.
#pragma once

#include <shell_origami/node/origami_node.h>

#include <tf2_ros/buffer.h>

#include <map>
#include <string>

namespace shell_origami {

/// Before each step the vertices that a frame holds are carried to where the frame is when the step
/// ends. Transforms come late and seldom, so the paper follows a little behind: by as much as news
/// of the frame were late in the last second or so, so that the steps between two transforms fall
/// between these. A frame that TF does not know any more, or has not heard of for a while, holds
/// the paper where it is. Where a frame jumps, be it because time did or the paper was paused, the
/// paper follows no faster than a robot's arm.
class HeldFrames {
 public:
  HeldFrames(OrigamiNode& origami, const tf2_ros::Buffer& tf);
  HeldFrames(const HeldFrames&) = delete;
  HeldFrames& operator=(const HeldFrames&) = delete;
  ~HeldFrames();

  /// \throws std::invalid_argument when a frame is the paper's own, and cannot hold it
  void requireForeign(const std::string& frame) const;
  /// Lets a frame hold vertices from now on. \throws std::invalid_argument when TF does not know
  /// where it is, or it is the paper's own.
  EditRecord pin(const PinWhere& where, const std::string& frame);
  /// Lets a frame carry a grasp. \throws as pin()
  EditRecord grasp(const GraspEdit& grasp, const std::string& frame);
  /// Adds an obstacle that a frame carries. \throws as pin()
  EditRecord add(const AddObstacleEdit& obstacle, const std::string& frame);

 private:
  struct Follower {
    ros::Time played;   ///< of the frame's way, so far
    double behind = 0;  ///< how late news come [s]
  };

  template <class MakeEdit>
  EditRecord begin(const std::string& frame, const MakeEdit& edit);
  void carry(double time_step, const ros::Time& end);
  void carry(const std::string& frame, const CarriedFrame& carried, double time_step,
             const ros::Time& end);
  void moveTo(const Pose& pose, const std::string& frame, const CarriedFrame& carried);
  geometry_msgs::TransformStamped lookUp(const std::string& frame, const ros::Time& time) const;

  OrigamiNode& origami_;
  const tf2_ros::Buffer& tf_;
  std::map<std::string, Follower> followers_;
};

}  // namespace shell_origami
