/// \file
/// rviz's tool that folds paper with the mouse.
#pragma once

#ifndef Q_MOC_RUN  // moc does not understand the headers of boost
#include <shell_origami/rviz/gesture.h>
#include <shell_origami/rviz/plugin/fold_preview.h>

#include <rviz/tool.h>
#include <QPointer>
#include <QWidget>
#endif

#include <memory>
#include <optional>
#include <string>

namespace rviz {
class EnumProperty;
class StringProperty;
}  // namespace rviz

namespace shell_origami {

/// Passes rviz's events to a Gesture and carries out what it asks for.
class FoldTool : public rviz::Tool {
  Q_OBJECT

 public:
  FoldTool();
  ~FoldTool() override;

  void onInitialize() override;
  void activate() override;
  void deactivate() override;
  void update(float wall_dt, float ros_dt) override;
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;
  int processKeyEvent(QKeyEvent* event, rviz::RenderPanel* panel) override;
  /// Esc during a gesture ends that and not the tool.
  bool eventFilter(QObject* watched, QEvent* event) override;

  const Gesture& gesture() const { return gesture_; }

 private Q_SLOTS:
  void chooseNode();
  void chooseReach();

 private:
  /// The camera through which somebody looks at the paper.
  struct View {
    Camera camera;
    Vector3 eye;  ///< [m], as the camera in the paper's world frame
  };
  void followPaper();
  std::optional<FramePose> world();
  std::optional<View> viewOf(rviz::RenderPanel& panel);
  MouseInput inputOf(const rviz::ViewportMouseEvent& event, const std::optional<View>& view);
  void carryOut(const MouseRequest& request);
  void make(const LaidFold& fold);
  void make(const TurnCrease& turn);
  void make(const TogglePin& pin);
  void make(const OpenMenu& menu);
  template <class Service>
  void ask(const std::string& service, const typename Service::Request& request);
  void tell(const std::string& message, bool refused);
  void draw();
  void showStatus();
  std::string problem();

  std::shared_ptr<PaperLink> link_;
  Requests requests_;
  FoldPreview preview_;
  Gesture gesture_;
  std::unique_ptr<FoldDrawing> drawing_;
  rviz::StringProperty* node_property_;
  rviz::EnumProperty* reach_property_;
  QPointer<QWidget> panel_;  ///< that the pointer was on last; rviz destroys it before its tools
  std::optional<View> view_;
  std::uint64_t sheets_ = 0;  ///< of the link, when the gesture began
  std::string name_;          ///< of the next fold
  std::string notice_;        ///< what the node said last
  QString status_;            ///< that is shown
};

}  // namespace shell_origami
