/// \file
/// Runs the tests of the plugin with one rviz window on the display.

#include "test/rviz/plugin/rviz_window.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QTemporaryDir>

#include <exception>
#include <iostream>
#include <memory>

namespace {

std::unique_ptr<shell_origami::RvizWindow> the_window;

}  // namespace

shell_origami::RvizWindow& shell_origami::window() { return *the_window; }

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // The user's settings of rviz are neither read nor written.
  const QTemporaryDir home;
  qputenv("HOME", home.path().toLocal8Bit());
  ros::init(argc, argv, "plugin_test", ros::init_options::AnonymousName);
  QApplication application(argc, argv);
  try {
    the_window = std::make_unique<shell_origami::RvizWindow>();
    const int status = RUN_ALL_TESTS();
    the_window.reset();
    return status;
  } catch (const std::exception& error) {
    std::cerr << "no window: " << error.what() << std::endl;
    return 1;
  }
}
