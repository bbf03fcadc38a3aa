/// \file
/// Every button of the panel Origami does what it says.

#include <shell_origami/rviz/plugin/history_box.h>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "test/rviz/plugin/rviz_window.h"

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180, kSide = 0.15;

class OrigamiPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    rviz.chooseNode("origami");
    std_srvs::Trigger trigger;
    for (const std::string service : {"pause", "reset"}) {
      // On a busy machine roscpp has reported a call as failed that the node had answered. Either
      // may be made twice.
      rviz.wait(service, [&] {
        return ros::service::call("/origami/" + service, trigger) && trigger.response.success;
      });
    }
    rviz.wait("flat paper", [this] {
      return rviz.paper().sheet().creases().empty() && state().paused && state().pinned.empty();
    });
  }
  const msg::SheetState& state() { return rviz.link().state(); }
  void fold(double angle) {
    msg::Fold fold;
    fold.request.line.resize(2);
    fold.request.line[1].x = fold.request.line[1].y = kSide;
    fold.request.angle = angle;
    fold.request.name = "spine";
    ASSERT_TRUE(ros::service::call("/origami/fold", fold) && fold.response.success);
    rviz.wait("a crease", [this] { return state().creases.size() == 1; });
  }
  void waitForAnswer(const std::string& part) {
    rviz.wait("answer " + part,
              [&] { return rviz.text("answer").find(part) != std::string::npos; });
  }

  RvizWindow& rviz = window();
};

TEST_F(OrigamiPanelTest, Time) {
  rviz.push("resume");
  rviz.wait("running", [this] { return !state().paused; });
  rviz.push("pause");
  rviz.wait("paused", [this] { return state().paused && rviz.text("rest") == "paused"; });
  const std::uint64_t before = state().step;
  rviz.find<QSpinBox>("steps").setValue(7);
  fold(1);
  rviz.push("step");
  waitForAnswer("took 7 steps");
  rviz.wait("7 steps", [&] { return state().step == before + 7; });
  rviz.push("settle");
  waitForAnswer("at rest");
}

TEST_F(OrigamiPanelTest, StepIsRefusedWhileTimeRuns) {
  rviz.push("resume");
  rviz.wait("running", [this] { return !state().paused; });
  rviz.push("step");
  waitForAnswer("step needs the node to be paused");
  EXPECT_NE(rviz.text("answer").find("#b00020"), std::string::npos);
}

TEST_F(OrigamiPanelTest, UndoAndReset) {
  fold(1);
  rviz.push("undo");
  rviz.wait("no crease", [this] { return state().creases.empty(); });
  fold(1);
  rviz.push("reset");
  rviz.wait("no crease", [this] { return state().creases.empty(); });
}

TEST_F(OrigamiPanelTest, Readings) {
  fold(1);
  rviz.push("resume");
  rviz.wait("readings", [this] {
    return rviz.text("rest") == "moving" && rviz.text("strain").find("strain 0.") == 0 &&
           rviz.text("pace").find("real time x") == 0 && rviz.text("contacts") == "contacts 0";
  });
  rviz.wait(
      "rest", [this] { return rviz.text("rest") == "settled"; }, 30);
}

TEST_F(OrigamiPanelTest, CreasesHaveRowsAndSliders) {
  rviz.openTab("Creases");
  fold(0.5);
  auto& table = rviz.find<QTableWidget>("creases");
  rviz.wait("a row", [&] { return table.rowCount() == 1 && table.item(0, 2)->text() == "28.6"; });
  EXPECT_EQ(table.item(0, 0)->text(), "spine");
  auto& slider = rviz.find<QSlider>("slider_0");
  EXPECT_EQ(slider.value(), 29);
  slider.setSliderDown(true);
  slider.setValue(-40);
  slider.setSliderDown(false);
  rviz.wait("target",
            [this] { return std::abs(state().creases[0].target_angle + 40 * kDegree) < 1e-5; });
  rviz.push("resume");
  rviz.wait(
      "angle", [&] { return std::abs(table.item(0, 1)->text().toDouble() + 40) < 1; }, 30);
}

TEST_F(OrigamiPanelTest, WhatIsHeldIsLetGo) {
  rviz.openTab("Held");
  msg::Pin pin;
  pin.request.vertices = {0, 1, 2};
  msg::Grasp grasp;
  grasp.request.id = "hand";
  grasp.request.vertices = {3};
  ASSERT_TRUE(ros::service::call("/origami/pin", pin) && pin.response.success);
  ASSERT_TRUE(ros::service::call("/origami/grasp", grasp) && grasp.response.success);
  auto& list = rviz.find<QListWidget>("held");
  rviz.wait("four rows", [&] { return list.count() == 4; });
  EXPECT_EQ(list.item(3)->text(), "vertex 3, grasped");
  rviz.push("unpin_selected");
  waitForAnswer("No pin is selected");
  list.item(1)->setSelected(true);
  rviz.push("unpin_selected");
  rviz.wait("two pins", [this] { return state().pinned == std::vector<std::uint32_t>{0, 2}; });
  rviz.push("unpin_all");
  rviz.wait("no pin", [this] { return state().pinned.empty(); });
  rviz.push("release_all");
  rviz.wait("nothing", [&] { return list.count() == 0; });
}

TEST_F(OrigamiPanelTest, ARecipeIsFollowedAndCanceled) {
  rviz.openTab("Recipe");
  rviz.find<QLineEdit>("recipe").setText("no_such_recipe");
  rviz.push("fold_recipe");
  waitForAnswer("no_such_recipe");
  rviz.find<QLineEdit>("recipe").setText("dog");
  rviz.push("fold_recipe");
  rviz.wait("progress", [this] {
    return rviz.text("doing").find("of 2") != std::string::npos &&
           rviz.find<QPushButton>("cancel_recipe").isEnabled();
  });
  rviz.wait("seven creases", [this] { return state().creases.size() == 7; });
  rviz.keepPicture("recipe");
  rviz.push("cancel_recipe");
  rviz.wait("the end", [this] { return !rviz.find<QPushButton>("cancel_recipe").isEnabled(); });
}

TEST_F(OrigamiPanelTest, OneGoesBackToAnyEdit) {
  rviz.openTab("Edits");
  auto& list = rviz.find<QListWidget>("edits");
  const auto text = [&](int from_last) {
    const auto* item = list.item(list.count() - from_last);
    return item ? item->text().toStdString() : "";
  };
  fold(0.5);
  msg::Pin pin;
  pin.request.vertices = {0, 1};
  ASSERT_TRUE(ros::service::call("/origami/pin", pin) && pin.response.success);
  rviz.wait("a row of the pin",
            [&] { return text(1).find("pin, 2 vertices") != std::string::npos; });
  EXPECT_NE(text(2).find("fold spine, 28.6°"), std::string::npos) << text(2);
  const int before = list.count() - 2;
  list.setCurrentRow(before);
  rviz.wait("a button", [this] { return rviz.find<QPushButton>("go_back").isEnabled(); });
  rviz.keepPicture("edits");
  rviz.push("go_back");
  rviz.wait("flat paper", [this] { return state().creases.empty() && state().pinned.empty(); });
  rviz.wait("both rows gone", [&] { return list.count() == before; });
}

/// A node that is edited for hours takes no more memory of rviz's than one that was edited for
/// minutes.
TEST_F(OrigamiPanelTest, TheLastEditsAreListed) {
  rviz.openTab("Edits");
  const auto& list = rviz.find<QListWidget>("edits");
  ros::Publisher edits = ros::NodeHandle().advertise<msg::Edit>("scribe/edits", 100);
  rviz.link().choose("scribe");
  rviz.wait("a listener", [&] { return edits.getNumSubscribers() > 0; });
  msg::Edit edit;
  edit.kind = msg::Edit::RESET;
  const auto last = [&]() -> std::uint64_t {
    return list.count() == 0 ? 0 : list.item(list.count() - 1)->text().section(' ', 0, 0).toULong();
  };
  while (edit.number < HistoryBox::kMostRows + 200) {
    for (int i = 0; i < 50; ++i) {
      ++edit.number;
      edits.publish(edit);
    }
    rviz.wait("its row", [&] { return last() == edit.number; });
  }
  EXPECT_EQ(list.count(), HistoryBox::kMostRows);
}

TEST_F(OrigamiPanelTest, FilesAreSavedAndLoaded) {
  rviz.openTab("File");
  const QTemporaryDir folder;
  fold(0.5);
  auto& path = rviz.find<QLineEdit>("path");
  for (const char* name : {"paper.fold", "paper.obj", "paper.yaml"}) {
    path.setText(folder.filePath(name));
    rviz.push("save");
    rviz.wait(name, [&] { return QFile::exists(folder.filePath(name)); });
  }
  rviz.push("reset");
  rviz.wait("flat paper", [this] { return state().creases.empty(); });
  path.setText(folder.filePath("paper.fold"));
  rviz.push("load");
  rviz.wait("a crease", [this] { return state().creases.size() == 1; });
  path.setText("/nowhere.fold");
  rviz.push("load");
  waitForAnswer("/nowhere.fold");
  // The paper to go back to is another one now.
  msg::Undo undo;
  ASSERT_TRUE(ros::service::call("/origami/undo", undo) && undo.response.success);
}

TEST_F(OrigamiPanelTest, DrawingIsChosen) {
  rviz.openTab("File");
  const auto is_on = [](const std::string& name, bool wanted) {
    bool value = !wanted;
    ros::param::get("/origami/live/" + name, value);
    return value == wanted;
  };
  for (const char* name : {"crease_labels", "vertex_ids", "contact_points"}) {
    for (const bool on : {true, false}) {
      QTest::mouseClick(&rviz.find<QCheckBox>(name), Qt::LeftButton, Qt::NoModifier, {8, 8});
      rviz.wait(name, [&] { return is_on(name, on); });
      EXPECT_EQ(rviz.find<QCheckBox>(name).isChecked(), on);
    }
  }
  auto& coloring = rviz.find<QComboBox>("coloring");
  for (const char* name : {"strain", "curvature", "contact", "paper"}) {
    coloring.setCurrentText(name);
    Q_EMIT coloring.activated(coloring.currentIndex());
    rviz.wait(name, [&] {
      std::string value;
      return ros::param::get("/origami/live/colouring", value) && value == name;
    });
  }
}

}  // namespace
}  // namespace shell_origami
