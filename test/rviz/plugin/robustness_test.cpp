/// \file
/// Nodes end and begin again, papers and frames change, and people click anywhere.

#include <gtest/gtest.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <rviz/frame_manager.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/viewport_mouse_event.h>
#include <rviz/visualization_manager.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcClient.h>
#include <QApplication>
#include <QComboBox>
#include <QTimer>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <random>

#include "test/rviz/plugin/rviz_window.h"

namespace shell_origami {
namespace {

constexpr double kSide = 0.15;

class RobustnessTest : public testing::Test {
 protected:
  void take(const QString& node) {
    rviz.leaveTool();
    rviz.chooseNode(node);
    rviz.lookDown(0.3);
    rviz.pressKey(Qt::Key_O);
  }
  void TearDown() override { rviz.frame().getManager()->setFixedFrame("world"); }
  void waitForStatus(const std::string& part) {
    rviz.wait("status " + part, [&] { return rviz.status().find(part) != std::string::npos; });
  }
  void foldDiagonal() {
    rviz.click(rviz.pixelOf({0, 0}));
    rviz.click(rviz.pixelOf({kSide, kSide}));
    rviz.pressKey(Qt::Key_Return);
  }

  RvizWindow& rviz = window();
};

/// Has a node end. One that roslaunch keeps alive begins again two seconds later.
void end(const std::string& node) {
  XmlRpc::XmlRpcValue arguments, result, uri;
  arguments[0] = "/test";
  arguments[1] = node;
  ASSERT_TRUE(ros::master::execute("lookupNode", arguments, result, uri, false));
  std::string host;
  std::uint32_t port = 0;
  ASSERT_TRUE(ros::network::splitURI(uri, host, port));
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  arguments[1] = "a test ends it";
  client.execute("shutdown", arguments, result);
}

TEST_F(RobustnessTest, ANodeEndsAndBeginsAgain) {
  take("mortal");
  rviz.move(rviz.pixelOf({0.05, 0.05}));
  waitForStatus("point (50.");
  rviz.click(rviz.pixelOf({0.05, 0.05}));
  end("/mortal");
  waitForStatus("there is no node /mortal");
  rviz.wait("the panel", [this] {
    return rviz.text("problem").find("there is no node /mortal") != std::string::npos;
  });
  rviz.click(rviz.pixelOf({0.05, 0.1}));
  rviz.pressKey(Qt::Key_Return);
  rviz.push("pause");
  rviz.wait("an answer", [this] {
    return rviz.text("answer").find("/mortal/pause does not answer") != std::string::npos;
  });
  rviz.wait("recovery", [this] {
    return rviz.status().find("there is no node") == std::string::npos &&
           rviz.text("problem").empty();
  });
  take("mortal");
  foldDiagonal();
  rviz.wait("a crease", [this] { return rviz.paper().sheet().creases().size() == 1; });
}

TEST_F(RobustnessTest, AnotherPaperEndsTheGesture) {
  take("origami");
  rviz.click(rviz.pixelOf({0.05, 0.05}));
  EXPECT_EQ(rviz.tool().gesture().phase(), Gesture::Phase::kLine);
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("/origami/reset", reset));
  waitForStatus("The paper has changed");
  EXPECT_EQ(rviz.tool().gesture().phase(), Gesture::Phase::kIdle);
}

TEST_F(RobustnessTest, AnotherFixedFrame) {
  take("origami");
  rviz.frame().getManager()->setFixedFrame("nowhere");
  rviz.pass(0.2);
  rviz.click(rviz.view().rect().center().x() * Vector2(1, 0) +
             rviz.view().rect().center().y() * Vector2(0, 1));
  waitForStatus("TF knows no way from");
  EXPECT_EQ(rviz.tool().gesture().phase(), Gesture::Phase::kIdle);
  rviz.frame().getManager()->setFixedFrame("paper_view");
  rviz.wait("recovery", [this] { return rviz.status().find("TF knows") == std::string::npos; });
  // The paper is where it is drawn: in the middle of the view.
  rviz.move({rviz.view().width() / 2.0, rviz.view().height() / 2.0});
  ASSERT_TRUE(rviz.tool().gesture().pointer());
  EXPECT_LT((rviz.tool().gesture().pointer()->flat - Vector2(kSide / 2, kSide / 2)).norm(), 2e-3);
}

TEST_F(RobustnessTest, TheNodeIsChosenInThePanel) {
  take("origami");
  auto& nodes = rviz.find<QComboBox>("node");
  rviz.wait("all nodes",
            [&] { return nodes.findText("/origami") >= 0 && nodes.findText("/fine") >= 0; });
  nodes.setCurrentText("/fine");
  Q_EMIT nodes.activated(nodes.findText("/fine"));
  EXPECT_EQ(rviz.link().node(), "/fine");
  rviz.wait("its paper", [this] {
    return rviz.link().paper() && rviz.paper().sheet().triangles().size() > 4000;
  });
  rviz.link().choose("bad name!");
  waitForStatus("is no name of a node");
  rviz.chooseNode("origami");
  rviz.wait("recovery", [this] { return rviz.text("problem").empty(); });
}

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Ghost and snapping on 5,000 triangles at 30 Hz.
TEST_F(RobustnessTest, FineMeshesTakeASmallPartOfACore) {
  take("fine");
  ASSERT_GT(rviz.paper().sheet().triangles().size(), 4500U);
  rviz.click(rviz.pixelOf({kSide / 2, 0}));
  rviz.click(rviz.pixelOf({kSide / 2, kSide}));
  waitForStatus("1 crease");
  constexpr int kFrames = 100;
  const double start = cpuSeconds();
  for (int i = 0; i < kFrames; ++i) {
    rviz.link().poll();
    rviz.move(rviz.pixelOf({0.02 + 0.0005 * i, 0.05}));
    rviz.tool().update(0, 0);
  }
  const double share = 30 * (cpuSeconds() - start) / kFrames;
  RecordProperty("percent_of_a_core", std::to_string(100 * share));
  std::cout << "ghost and snapping at 30 Hz: " << 100 * share << " % of a core" << std::endl;
  EXPECT_LT(share, 0.3);
  rviz.pressKey(Qt::Key_Escape);
}

double residentMegabytes() {
  std::ifstream statm("/proc/self/statm");
  double size = 0, resident = 0;
  statm >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// One random event on the view.
void sendRandom(RvizWindow& rviz, std::mt19937& random) {
  const auto below = [&](int count) {
    return std::uniform_int_distribution<int>(0, count - 1)(random);
  };
  const Vector2 pixel(below(rviz.view().width()), below(rviz.view().height()));
  const Qt::KeyboardModifiers keys[] = {Qt::NoModifier, Qt::NoModifier, Qt::ControlModifier,
                                        Qt::ShiftModifier, Qt::ControlModifier | Qt::ShiftModifier};
  switch (below(12)) {
    case 0: return rviz.press(pixel, keys[below(5)]);
    case 1: return rviz.release(pixel, keys[below(5)]);
    case 2:
    case 3: return rviz.click(pixel, keys[below(5)]);
    case 4: return rviz.doubleClick(pixel);
    case 5: return rviz.wheel(pixel, below(3) - 1);
    case 6: return rviz.type(std::string(1, "0123456789.-\b"[below(13)]));
    case 7: return below(4) == 0 ? rviz.pressKey(Qt::Key_Return) : rviz.move(pixel);
    case 8: return rviz.click(pixel, Qt::NoModifier, Qt::RightButton);
    case 9: return rviz.move(pixel, keys[below(5)], Qt::LeftButton);
    default: return rviz.move(pixel, keys[below(5)]);
  }
}

/// rviz keeps the last ten minutes of TF, 8 kB a second of these papers, whatever its tool is. The
/// rest of its memory does not grow: 200,000 events took nothing more in ten minutes.
void forgetFrames(RvizWindow& rviz) {
  rviz.frame().getManager()->getFrameManager()->getTF2BufferPtr()->clear();
}

/// MOUSE_EVENTS in the environment asks for more of them.
TEST_F(RobustnessTest, RandomEventsDoNoHarm) {
  take("mortal");
  const char* wanted = std::getenv("MOUSE_EVENTS");
  const int events = wanted ? std::atoi(wanted) : 2000;
  std::mt19937 random(17);
  QTimer closer;  // of menus, which have event loops of their own
  QObject::connect(&closer, &QTimer::timeout, [] {
    if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
  });
  closer.start(5);
  double settled = 0;
  for (int i = 0; i < events; ++i) {
    sendRandom(rviz, random);
    if (i % 20 == 0) rviz.pass(0.02);
    if (i % 500 == 0) {
      // Paper of which nothing more can be folded would be a dull one.
      std_srvs::Trigger trigger;
      ros::service::call("/mortal/reset", trigger);
      forgetFrames(rviz);
      rviz.lookDown(0.3);
      if (rviz.tool().gesture().phase() == Gesture::Phase::kIdle) rviz.pass(0.1);
    }
    if (i == events / 2) settled = residentMegabytes();
  }
  const double grown = residentMegabytes() - settled;
  std::cout << events << " events; the second half took " << grown << " MB" << std::endl;
  EXPECT_LT(grown, 2);
  take("mortal");
  EXPECT_TRUE(rviz.link().problem().empty()) << rviz.link().problem();
}

}  // namespace
}  // namespace shell_origami
