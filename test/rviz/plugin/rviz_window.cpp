#include "test/rviz/plugin/rviz_window.h"

#include <gtest/gtest.h>
#include <ros/package.h>
#include <rviz/properties/property.h>
#include <rviz/render_panel.h>
#include <rviz/tool_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QScreen>
#include <QStatusBar>
#include <QTabWidget>
#include <QTest>

#include <cmath>

namespace shell_origami {

RvizWindow::RvizWindow() : frame_(std::make_unique<rviz::VisualizationFrame>()) {
  const std::string config = ros::package::getPath("shell_origami") + "/rviz/origami.rviz";
  frame_->setApp(qApp);
  frame_->setSplashPath("");
  frame_->initialize(QString::fromStdString(config));
  frame_->setGeometry(0, 0, 1280, 860);
  frame_->show();
  link_ = sharedPaperLink();
  chooseNode("origami");
}

RvizWindow::~RvizWindow() = default;

void RvizWindow::wait(const std::string& what, const std::function<bool()>& condition,
                      double seconds) {
  QElapsedTimer timer;
  timer.start();
  while (!condition()) {
    if (timer.elapsed() > 1000 * seconds) {
      throw std::runtime_error("never: " + what + "; status: " + status());
    }
    QTest::qWait(5);
  }
}

void RvizWindow::pass(double seconds) { QTest::qWait(static_cast<int>(1000 * seconds)); }

void RvizWindow::push(const QString& button) {
  QTest::mouseClick(&find<QPushButton>(button), Qt::LeftButton);
}

void RvizWindow::openTab(const QString& title) {
  auto& tabs = find<QTabWidget>("tabs");
  for (int i = 0; i < tabs.count(); ++i) {
    if (tabs.tabText(i) == title) tabs.setCurrentIndex(i);
  }
}

std::string RvizWindow::text(const QString& label) {
  return find<QLabel>(label).text().toStdString();
}

std::string RvizWindow::status() {
  std::string all;
  for (const QLabel* label : frame_->statusBar()->findChildren<QLabel*>()) {
    all += label->text().toStdString();
  }
  return all;
}

namespace {

QString pictureFolder() { return qEnvironmentVariable("PICTURES"); }

void saveScreen(const QString& name) {
  qApp->primaryScreen()->grabWindow(0).save(pictureFolder() + "/" + name + ".png");
}

}  // namespace

void RvizWindow::keepPicture(const QString& name) {
  if (pictureFolder().isEmpty()) return;
  pass(0.3);  // until it is drawn
  saveScreen(name);
}

RvizWindow::Film::Film(RvizWindow& window, const QString& name) : window_(window) {
  if (pictureFolder().isEmpty()) return;
  window_.filmed_ = true;
  QObject::connect(&timer_, &QTimer::timeout, [this, name] {
    saveScreen(name + QString("_%1").arg(count_++, 4, 10, QChar('0')));
  });
  timer_.start(200);
}

void RvizWindow::takeTime() {
  if (filmed_) pass(0.6);
}

FoldTool& RvizWindow::tool() {
  auto* tools = frame_->getManager()->getToolManager();
  for (int i = 0; i < tools->numTools(); ++i) {
    if (auto* tool = dynamic_cast<FoldTool*>(tools->getTool(i))) return *tool;
  }
  throw std::runtime_error("rviz has no tool Fold");
}

rviz::RenderPanel& RvizWindow::view() { return *frame_->getManager()->getRenderPanel(); }

void RvizWindow::chooseNode(const QString& node) {
  link_->choose(node.toStdString());
  wait("paper of " + node.toStdString(), [this] { return link_->paper() && link_->states() > 0; });
}

void RvizWindow::look(double yaw, double pitch, double distance) {
  rviz::ViewController& view = *frame_->getManager()->getViewManager()->getCurrent();
  view.subProp("Pitch")->setValue(pitch);
  view.subProp("Yaw")->setValue(yaw);
  view.subProp("Distance")->setValue(distance);
  pass(0.3);  // it is applied as rviz draws
}

Vector2 RvizWindow::pixelOf(const Vector2& flat) {
  const FramePose world;
  const Camera camera = cameraFrom(*view().getCamera(), world, {view().width(), view().height()});
  return camera.pixel(paper().point(paper().place(flat)));
}

void RvizWindow::send(QEvent::Type type, const Vector2& pixel, Qt::MouseButton button,
                      Qt::MouseButtons buttons, Qt::KeyboardModifiers keys) {
  const QPointF local(std::lround(pixel.x()), std::lround(pixel.y()));
  QMouseEvent event(type, local, view().mapToGlobal(local.toPoint()), button, buttons, keys);
  QApplication::sendEvent(&view(), &event);
}

void RvizWindow::move(const Vector2& pixel, Qt::KeyboardModifiers keys, Qt::MouseButtons buttons) {
  send(QEvent::MouseMove, pixel, Qt::NoButton, buttons, keys);
}

void RvizWindow::press(const Vector2& pixel, Qt::KeyboardModifiers keys) {
  send(QEvent::MouseButtonPress, pixel, Qt::LeftButton, Qt::LeftButton, keys);
}

void RvizWindow::release(const Vector2& pixel, Qt::KeyboardModifiers keys) {
  send(QEvent::MouseButtonRelease, pixel, Qt::LeftButton, Qt::NoButton, keys);
}

void RvizWindow::click(const Vector2& pixel, Qt::KeyboardModifiers keys, Qt::MouseButton button) {
  move(pixel, keys);
  takeTime();
  send(QEvent::MouseButtonPress, pixel, button, button, keys);
  send(QEvent::MouseButtonRelease, pixel, button, Qt::NoButton, keys);
}

void RvizWindow::doubleClick(const Vector2& pixel) {
  click(pixel);
  send(QEvent::MouseButtonDblClick, pixel, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
  release(pixel);
}

void RvizWindow::drag(const Vector2& from, const Vector2& to) {
  move(from);
  press(from);
  for (double part : {0.3, 0.7, 1.0}) {
    move(from + part * (to - from), Qt::NoModifier, Qt::LeftButton);
    pass(0.05);
  }
  release(to);
}

void RvizWindow::wheel(const Vector2& pixel, int notches) {
  const QPointF local(pixel.x(), pixel.y());
  QWheelEvent event(local, view().mapToGlobal(local.toPoint()), QPoint(), QPoint(0, 120 * notches),
                    Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view(), &event);
}

void RvizWindow::type(const std::string& keys) {
  for (char key : keys) QTest::keyClick(&view(), key);
}

void RvizWindow::pressKey(Qt::Key key) {
  takeTime();
  QTest::keyClick(&view(), key);
}

void RvizWindow::leaveTool() {
  pressKey(Qt::Key_Escape);  // ends a gesture
  pressKey(Qt::Key_Escape);
}

}  // namespace shell_origami
