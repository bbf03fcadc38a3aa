/// \file
/// The package's messages as msg::Sheet, msg::Fold and so on. catkin generates them straight into
/// namespace shell_origami, where Sheet, Crease, Edit and View are words of the core, so this is
/// the only file that includes them.
#pragma once

#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/Polygon.h>
#include <ros/ros.h>
#include <shape_msgs/MeshTriangle.h>

#define Sheet SheetMessage
#define Crease CreaseMessage
#define Edit EditMessage
#define View ViewMessage
#include <shell_origami/AddVertex.h>
#include <shell_origami/ContactPoint.h>
#include <shell_origami/Edit.h>
#include <shell_origami/Energy.h>
#include <shell_origami/Fold.h>
#include <shell_origami/FoldRecipeAction.h>
#include <shell_origami/Load.h>
#include <shell_origami/Picked.h>
#include <shell_origami/Pin.h>
#include <shell_origami/Save.h>
#include <shell_origami/Sheet.h>
#include <shell_origami/SheetState.h>
#include <shell_origami/Step.h>
#include <shell_origami/Undo.h>
#include <shell_origami/Unpin.h>
#include <shell_origami/View.h>
#undef View
#undef Edit
#undef Crease
#undef Sheet

namespace shell_origami {
namespace msg {

using Crease = CreaseMessage;
using Edit = EditMessage;
using Sheet = SheetMessage;
using View = ViewMessage;
using ::shell_origami::ContactPoint;
using ::shell_origami::CreaseState;
using ::shell_origami::Energy;
using ::shell_origami::FoldRecipeAction;
using ::shell_origami::FoldRecipeFeedback;
using ::shell_origami::FoldRecipeGoal;
using ::shell_origami::FoldRecipeResult;
using ::shell_origami::Picked;
using ::shell_origami::SheetState;

using ::shell_origami::AddVertex;
using ::shell_origami::Fold;
using ::shell_origami::Load;
using ::shell_origami::Pin;
using ::shell_origami::Save;
using ::shell_origami::Step;
using ::shell_origami::Undo;
using ::shell_origami::Unpin;

}  // namespace msg
}  // namespace shell_origami
