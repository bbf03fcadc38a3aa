#include <shell_origami/node/diagnostics.h>
#include <shell_origami/node/frame_listener.h>
#include <shell_origami/node/live_parameters.h>
#include <shell_origami/node/master_watch.h>
#include <shell_origami/node/picking.h>
#include <shell_origami/node/recipe_action.h>
#include <shell_origami/node/sense/depth_camera.h>
#include <shell_origami/node/services.h>

#include <csignal>
#include <optional>

int main(int argc, char** argv) {
  ros::init(argc, argv, "origami");
  // roscpp ends cleanly of SIGINT alone.
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  ros::NodeHandle node("~");
  try {
    shell_origami::OrigamiNode origami(node, shell_origami::loadParameters(node));
    tf2_ros::Buffer tf;
    const shell_origami::FrameListener frame_listener(node, tf);
    shell_origami::HeldFrames held_frames(origami, tf);
    shell_origami::Services services(node, origami, held_frames, tf);
    shell_origami::RecipeAction recipe_action(node, origami);
    shell_origami::Picking picking(node, origami, tf);
    shell_origami::DepthCamera depth_camera(node, origami, tf);
    shell_origami::LiveParameters live(node, origami);
    shell_origami::Diagnostics diagnostics(node, origami);
    std::optional<shell_origami::MasterWatch> master_watch;
    if (origami.config().watch_master) master_watch.emplace();
    origami.spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
