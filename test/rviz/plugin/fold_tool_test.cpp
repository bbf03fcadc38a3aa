/// \file
/// The tool Fold in rviz, by mouse events on its window.

#include <shell_origami/rviz/seen_fold.h>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QTimer>

#include <cmath>
#include <ctime>
#include <random>

#include "test/rviz/plugin/rviz_window.h"

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180, kSide = 0.15;
constexpr double kMissed = 5e-4;  ///< [m] by which a click may miss: less than two pixels

class FoldToolTest : public testing::Test {
 protected:
  void SetUp() override {
    rviz.chooseNode("origami");
    call("pause");
    call("reset");
    rviz.leaveTool();
    rviz.lookDown(0.22);
    rviz.pressKey(Qt::Key_O);
    rviz.wait("flat paper", [this] { return rviz.paper().sheet().creases().empty(); });
  }
  void call(const std::string& service) {
    std_srvs::Trigger trigger;
    ASSERT_TRUE(ros::service::call("/origami/" + service, trigger) && trigger.response.success);
    rviz.pass(0.1);
  }
  Vector2 at(double x, double y) { return rviz.pixelOf({x, y}); }
  void waitForCreases(std::size_t count) {
    rviz.wait(std::to_string(count) + " creases",
              [&] { return rviz.paper().sheet().creases().size() == count; });
  }
  Segment line(std::size_t crease) {
    const Crease& of = rviz.paper().sheet().creases()[crease];
    const auto& flat = rviz.paper().sheet().flatPositions();
    return {flat[of.vertices.front()], flat[of.vertices.back()]};
  }
  double target(std::size_t crease) {
    return rviz.link().state().creases[crease].target_angle / kDegree;
  }
  void waitForStatus(const std::string& part) {
    rviz.wait("status " + part, [&] { return rviz.status().find(part) != std::string::npos; });
  }

  RvizWindow& rviz = window();
};

bool joins(const Segment& line, const Segment& wanted, double tolerance) {
  const auto near = [&](int i, int k) { return (line[i] - wanted[k]).norm() < tolerance; };
  return (near(0, 0) && near(1, 1)) || (near(0, 1) && near(1, 0));
}

/// As recipes/dog.yaml has it.
struct DogFold {
  Segment line;
  std::string degrees;
};
const std::vector<DogFold> kDog{{{Vector2(0.0435, 0.0435), Vector2(0, 0)}, "170"},
                                {{Vector2(0.0435, 0.0435), Vector2(0.126, 0.126)}, "-170"},
                                {{Vector2(0.0435, 0.0435), Vector2(0, 0.0302)}, "-171.2"},
                                {{Vector2(0.0435, 0.0435), Vector2(0.0302, 0)}, "-171.2"},
                                {{Vector2(0.126, 0.126), Vector2(0.15, 0.15)}, "170"},
                                {{Vector2(0.126, 0.126), Vector2(0.06348, 0.15)}, "175.9"},
                                {{Vector2(0.126, 0.126), Vector2(0.15, 0.06348)}, "175.9"}};

TEST_F(FoldToolTest, ADogIsFoldedClickByClick) {
  const RvizWindow::Film film(rviz, "dog");
  const auto segment = Qt::ControlModifier | Qt::ShiftModifier;
  for (std::size_t i = 0; i < kDog.size(); ++i) {
    for (const Vector2& end : kDog[i].line) rviz.click(at(end.x(), end.y()), segment);
    rviz.type(kDog[i].degrees);
    rviz.pressKey(Qt::Key_Return);
    waitForCreases(i + 1);
    rviz.wait("its state", [&] { return rviz.link().state().creases.size() == i + 1; });
  }
  for (const DogFold& fold : kDog) {
    int found = 0;
    for (std::size_t c = 0; c < kDog.size(); ++c) {
      if (!joins(line(c), fold.line, kMissed)) continue;
      ++found;
      EXPECT_NEAR(target(c), std::stod(fold.degrees), 1e-4);
    }
    EXPECT_EQ(found, 1) << fold.line[1].transpose();
  }
  rviz.look(5.1, 0.35, 0.3);
  call("resume");
  rviz.wait(
      "a folded dog", [&] { return rviz.link().state().settled; }, 60);
  // The recipe's panels close. Those of clicks do not quite, by a missed pixel over the length of a
  // crease, 0.3 mm in 30 mm: where creases are almost shut, a crease turns by some times as much.
  for (const msg::CreaseState& crease : rviz.link().state().creases) {
    EXPECT_NEAR(crease.angle, crease.target_angle, 5 * kDegree);
  }
  rviz.keepPicture("dog");
}

TEST_F(FoldToolTest, ALineFoldsTheSideUnderThePointer) {
  rviz.click(at(kSide / 2, 0.0005));
  rviz.move(at(kSide / 2 + 0.001, kSide - 0.0005));
  waitForStatus("1 crease");
  rviz.click(at(kSide / 2 + 0.001, kSide - 0.0005));
  rviz.type("90");
  rviz.wheel(at(0.02, 0.03), 1);
  waitForStatus("95°");
  rviz.keepPicture("laid");
  rviz.click(at(0.02, 0.03));
  waitForCreases(1);
  EXPECT_TRUE(joins(line(0), {Vector2(kSide / 2, 0), Vector2(kSide / 2, kSide)}, 1e-6))
      << "snapped";
  waitForStatus("folding along 1 line");
  rviz.wait("its state", [&] { return rviz.link().state().creases.size() == 1; });
  EXPECT_NEAR(target(0), 95, 1e-4);
}

TEST_F(FoldToolTest, ACornerIsBroughtToAnother) {
  rviz.drag(at(0, 0), at(kSide, kSide));
  waitForStatus("1 crease");
  rviz.keepPicture("brought");
  rviz.pressKey(Qt::Key_Return);
  waitForCreases(1);
  EXPECT_TRUE(joins(line(0), {Vector2(kSide, 0), Vector2(0, kSide)}, 1e-6));
  EXPECT_GT(target(0), 0) << "towards the viewer, who sees the front";
  call("resume");
  rviz.wait(
      "shut paper", [&] { return rviz.link().state().settled; }, 30);
  // One layer of two.
  rviz.click(at(kSide, 0.05), Qt::ControlModifier);
  rviz.click(rviz.pixelOf({0.1, kSide}), Qt::ControlModifier);
  rviz.wait("an answer", [&] {
    return rviz.status().find("1 crease") != std::string::npos ||
           rviz.status().find("#b00020") != std::string::npos;
  });
  EXPECT_NE(rviz.status().find("the top layer"), std::string::npos) << rviz.status();
  rviz.pressKey(Qt::Key_Escape);
  EXPECT_EQ(rviz.tool().gesture().phase(), Gesture::Phase::kIdle);
}

/// As doc/tutorial.md tells it.
TEST_F(FoldToolTest, TheTutorial) {
  call("resume");
  rviz.drag(at(0, 0), at(kSide, kSide));
  rviz.type("178");
  rviz.pressKey(Qt::Key_Return);
  rviz.wait("a triangle", [&] {
    return rviz.link().state().creases.size() == 1 && rviz.link().state().settled &&
           rviz.link().state().creases[0].angle > 3;
  });
  // Both halves have risen: they are seen from the side.
  rviz.look(M_PI / 4, 0.1, 0.25);
  rviz.click(at(kSide / 2, kSide / 2));
  EXPECT_NE(rviz.status().find("middle of crease"), std::string::npos) << rviz.status();
  rviz.click(at(kSide, kSide));
  rviz.move(rviz.pixelOf({0.14, 0.06}));
  waitForStatus("2 creases");
  rviz.keepPicture("tutorial");
  rviz.click(rviz.pixelOf({0.14, 0.06}));
  rviz.wait("three creases", [&] { return rviz.link().state().creases.size() >= 3; });
  const auto& states = rviz.link().state().creases;
  EXPECT_LT(states[states.size() - 1].target_angle * states[states.size() - 2].target_angle, 0)
      << "a mountain and a valley";
  rviz.push("undo");
  rviz.wait("one crease", [&] { return rviz.link().state().creases.size() == 1; });
}

TEST_F(FoldToolTest, ACreaseIsDraggedToAnotherAngle) {
  rviz.click(at(0, 0));
  rviz.click(at(kSide, kSide));
  rviz.pressKey(Qt::Key_Return);
  waitForCreases(1);
  rviz.wait("its state", [&] { return rviz.link().state().creases.size() == 1; });
  const Vector2 from = at(0.05, 0.05);
  rviz.drag(from, from - Vector2(0, 60));
  rviz.wait("30 degrees", [&] { return std::abs(target(0) - 30) < 0.1; });
}

TEST_F(FoldToolTest, ADoubleClickPinsAndUnpins) {
  rviz.doubleClick(at(kSide, 0));
  rviz.wait("a pin", [&] { return rviz.link().state().pinned.size() == 1; });
  const auto& flat = rviz.paper().sheet().flatPositions();
  EXPECT_LT((flat[rviz.link().state().pinned[0]] - Vector2(kSide, 0)).norm(), 1e-6);
  rviz.doubleClick(at(kSide, 0));
  rviz.wait("no pin", [&] { return rviz.link().state().pinned.empty(); });
}

/// Opens the menu at a pixel and chooses an entry. The menu has an event loop of its own.
void choose(RvizWindow& rviz, const Vector2& pixel, const QString& entry) {
  bool chosen = false;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (!menu) return;
    auto* action = menu->findChild<QAction*>(entry);
    EXPECT_TRUE(action) << entry.toStdString();
    if (action) action->trigger();
    menu->close();
    chosen = true;
  });
  timer.start(20);
  rviz.click(pixel, Qt::NoModifier, Qt::RightButton);
  rviz.wait("a menu", [&] { return chosen; });
}

TEST_F(FoldToolTest, TheMenuDoesWhatItSays) {
  choose(rviz, at(kSide, 0), "pin");
  rviz.wait("a pin", [&] { return rviz.link().state().pinned.size() == 1; });
  choose(rviz, at(0, kSide), "grasp");
  rviz.wait("a grasp", [&] { return rviz.link().state().grasped.size() == 1; });
  choose(rviz, at(0, kSide), "release");
  rviz.wait("no grasp", [&] { return rviz.link().state().grasped.empty(); });
  const int vertices = rviz.paper().sheet().vertexCount();
  choose(rviz, at(0.033, 0), "add_vertex");
  rviz.wait("a vertex", [&] { return rviz.paper().sheet().vertexCount() == vertices + 1; });
  rviz.click(at(0, 0));
  rviz.click(at(kSide, kSide));
  rviz.type("60");
  rviz.pressKey(Qt::Key_Return);
  waitForCreases(1);
  call("resume");
  rviz.wait("a crease", [&] { return rviz.link().state().creases[0].angle > 55 * kDegree; });
  choose(rviz, rviz.pixelOf({0.05, 0.05}), "reverse");
  rviz.wait("a mountain", [&] { return target(0) < -50; });
  choose(rviz, rviz.pixelOf({0.05, 0.05}), "unfold");
  rviz.wait("flat", [&] { return target(0) == 0; });
}

TEST_F(FoldToolTest, EscAndTheRightButtonLeaveNothingBehind) {
  const std::uint64_t edits = rviz.link().state().edits;
  rviz.click(at(0.03, 0.03));
  EXPECT_EQ(rviz.tool().gesture().phase(), Gesture::Phase::kLine);
  rviz.pressKey(Qt::Key_Escape);
  EXPECT_EQ(rviz.tool().gesture().phase(), Gesture::Phase::kIdle);
  rviz.click(at(0.03, 0.03));
  rviz.click(at(0.1, 0.12));
  EXPECT_EQ(rviz.tool().gesture().phase(), Gesture::Phase::kAngle) << "the tool is still there";
  rviz.click(at(0.1, 0.1), Qt::NoModifier, Qt::RightButton);
  EXPECT_EQ(rviz.tool().gesture().phase(), Gesture::Phase::kIdle);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  rviz.pass(0.3);
  EXPECT_EQ(rviz.link().state().edits, edits);
}

TEST_F(FoldToolTest, WhatTheNodeRefusesStandsInTheStatusBar) {
  rviz.click(at(0, 0), Qt::ControlModifier | Qt::ShiftModifier);
  rviz.click(at(0.1, 0), Qt::ControlModifier | Qt::ShiftModifier);
  rviz.pressKey(Qt::Key_Return);
  waitForStatus("border");
  EXPECT_NE(rviz.status().find("#b00020"), std::string::npos) << rviz.status();
  EXPECT_TRUE(rviz.paper().sheet().creases().empty());
}

}  // namespace
}  // namespace shell_origami
