/// \file
/// The package's messages as msg::Sheet, msg::Fold and so on. catkin generates them straight into
/// namespace shell_origami, where some of these are words of the core, so this is the only file
/// that includes them.
#pragma once

#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/Polygon.h>
#include <ros/ros.h>
#include <shape_msgs/MeshTriangle.h>

#define Sheet SheetMessage
#define Crease CreaseMessage
#define Edit EditMessage
#define View ViewMessage
#define Landmark LandmarkMessage
#define FoldThrough FoldThroughService
#define Obstacle ObstacleMessage
#define Grasp GraspService
#include <shell_origami/AddObstacle.h>
#include <shell_origami/AddVertex.h>
#include <shell_origami/ContactPoint.h>
#include <shell_origami/Edit.h>
#include <shell_origami/Energy.h>
#include <shell_origami/FlatSegment.h>
#include <shell_origami/Fold.h>
#include <shell_origami/FoldRecipeAction.h>
#include <shell_origami/FoldThrough.h>
#include <shell_origami/Grasp.h>
#include <shell_origami/Landmark.h>
#include <shell_origami/Layers.h>
#include <shell_origami/Load.h>
#include <shell_origami/Obstacle.h>
#include <shell_origami/Picked.h>
#include <shell_origami/Pin.h>
#include <shell_origami/Release.h>
#include <shell_origami/RemoveObstacle.h>
#include <shell_origami/Save.h>
#include <shell_origami/Sheet.h>
#include <shell_origami/SheetState.h>
#include <shell_origami/Step.h>
#include <shell_origami/Undo.h>
#include <shell_origami/Unpin.h>
#include <shell_origami/View.h>
#undef Grasp
#undef Obstacle
#undef FoldThrough
#undef Landmark
#undef View
#undef Edit
#undef Crease
#undef Sheet

namespace shell_origami {
namespace msg {

using Crease = CreaseMessage;
using Edit = EditMessage;
using Landmark = LandmarkMessage;
using Obstacle = ObstacleMessage;
using Sheet = SheetMessage;
using View = ViewMessage;
using ::shell_origami::ContactPoint;
using ::shell_origami::CreaseState;
using ::shell_origami::Energy;
using ::shell_origami::FlatSegment;
using ::shell_origami::FoldRecipeAction;
using ::shell_origami::FoldRecipeFeedback;
using ::shell_origami::FoldRecipeGoal;
using ::shell_origami::FoldRecipeResult;
using ::shell_origami::Picked;
using ::shell_origami::SheetState;

using ::shell_origami::AddObstacle;
using ::shell_origami::AddVertex;
using ::shell_origami::Fold;
using FoldThrough = FoldThroughService;
using Grasp = GraspService;
using ::shell_origami::Layers;
using ::shell_origami::Load;
using ::shell_origami::Pin;
using ::shell_origami::Release;
using ::shell_origami::RemoveObstacle;
using ::shell_origami::Save;
using ::shell_origami::Step;
using ::shell_origami::Undo;
using ::shell_origami::Unpin;

}  // namespace msg
}  // namespace shell_origami
