/// \file
/// An rviz window with the package's configuration, and a person's hands on it.
#pragma once

#include <shell_origami/rviz/plugin/fold_tool.h>

#include <rviz/visualization_frame.h>
#include <QEvent>
#include <QString>
#include <QTimer>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

class QLabel;

namespace shell_origami {

class RvizWindow {
 public:
  RvizWindow();
  ~RvizWindow();

  /// Handles events until a condition holds; fails the test after some seconds.
  void wait(const std::string& what, const std::function<bool()>& condition, double seconds = 20);
  /// Handles events for a time [s].
  void pass(double seconds);

  /// The window's widget of a name. Fails the test where there is none.
  template <class Widget>
  Widget& find(const QString& name) {
    auto* found = frame_->findChild<Widget*>(name);
    if (!found) throw std::runtime_error("there is no " + name.toStdString());
    return *found;
  }
  void push(const QString& button);
  /// Shows the panel's tab of a title.
  void openTab(const QString& title);
  std::string text(const QString& label);
  /// What stands in the status bar.
  std::string status();
  /// Saves the screen in the folder that the environment names as PICTURES, if it does.
  void keepPicture(const QString& name);
  /// With PICTURES, saves the screen five times a second there as NAME_<number>.png while it lives,
  /// and has the person take time.
  class Film;

  PaperLink& link() { return *link_; }
  const ShownPaper& paper() { return *link_->paper(); }
  FoldTool& tool();
  rviz::VisualizationFrame& frame() { return *frame_; }
  rviz::RenderPanel& view();

  /// Chooses the node whose paper is folded, and waits for its paper.
  void chooseNode(const QString& node);
  /// Looks at the paper's middle. \param yaw  around it [rad] \param pitch  above it [rad]
  /// \param distance  [m]
  void look(double yaw, double pitch, double distance);
  /// Looks straight down, +x to the right.
  void lookDown(double distance) { look(3 * M_PI / 2, M_PI / 2, distance); }
  /// Where a point of the flat sheet is seen.
  Vector2 pixelOf(const Vector2& flat);

  void move(const Vector2& pixel, Qt::KeyboardModifiers keys = Qt::NoModifier,
            Qt::MouseButtons buttons = Qt::NoButton);
  void press(const Vector2& pixel, Qt::KeyboardModifiers keys = Qt::NoModifier);
  void release(const Vector2& pixel, Qt::KeyboardModifiers keys = Qt::NoModifier);
  void click(const Vector2& pixel, Qt::KeyboardModifiers keys = Qt::NoModifier,
             Qt::MouseButton button = Qt::LeftButton);
  void doubleClick(const Vector2& pixel);
  void drag(const Vector2& from, const Vector2& to);
  void wheel(const Vector2& pixel, int notches);
  void type(const std::string& keys);
  void pressKey(Qt::Key key);
  /// Goes back to the tool that moves the camera, whatever was under way.
  void leaveTool();

 private:
  void send(QEvent::Type type, const Vector2& pixel, Qt::MouseButton button,
            Qt::MouseButtons buttons, Qt::KeyboardModifiers keys);

  /// So that a film shows what is done.
  void takeTime();

  std::unique_ptr<rviz::VisualizationFrame> frame_;
  std::shared_ptr<PaperLink> link_;
  bool filmed_ = false;
};

class RvizWindow::Film {
 public:
  Film(RvizWindow& window, const QString& name);
  ~Film() { window_.filmed_ = false; }

 private:
  RvizWindow& window_;
  QTimer timer_;
  int count_ = 0;
};

/// Returns the window that the tests share.
RvizWindow& window();

}  // namespace shell_origami
