#include <shell_origami/rviz/plugin/fold_tool.h>

#include <shell_origami/rviz/plugin/fold_menu.h>
#include <shell_origami/rviz/plugin/fold_status.h>

#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/string_property.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/viewport_mouse_event.h>
#include <QKeyEvent>
#include <pluginlib/class_list_macros.hpp>

namespace shell_origami {
namespace {

constexpr double kWheelNotch = 120;  ///< of Qt, for one notch

MouseEvent eventOf(const rviz::ViewportMouseEvent& event) {
  switch (event.type) {
    case QEvent::MouseButtonPress: return MouseEvent::kPress;
    case QEvent::MouseButtonRelease: return MouseEvent::kRelease;
    case QEvent::MouseButtonDblClick: return MouseEvent::kDoubleClick;
    case QEvent::Wheel: return MouseEvent::kWheel;
    default: return MouseEvent::kMove;
  }
}

MouseButton buttonOf(const rviz::ViewportMouseEvent& event) {
  if (event.acting_button == Qt::LeftButton) return MouseButton::kLeft;
  return event.acting_button == Qt::RightButton ? MouseButton::kRight : MouseButton::kNone;
}

/// Returns the key as Gesture takes it; 0: it takes none such.
char keyOf(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter: return '\n';
    case Qt::Key_Backspace: return '\b';
    default: break;
  }
  const QByteArray text = event.text().toLatin1();
  return text.size() == 1 ? text[0] : '\0';
}

}  // namespace

FoldTool::FoldTool() : link_(sharedPaperLink()), preview_(*link_) {
  shortcut_key_ = 'o';
  node_property_ = new rviz::StringProperty("Node", PaperLink::kDefaultNode,
                                            "Node whose paper is folded, also by the panel Origami",
                                            getPropertyContainer(), SLOT(chooseNode()), this);
  reach_property_ = new rviz::EnumProperty(
      "Layers", "all", "Layers that a fold takes where neither Ctrl nor Shift is held",
      getPropertyContainer(), SLOT(chooseReach()), this);
  reach_property_->addOption("all", static_cast<int>(FoldReach::kAll));
  reach_property_->addOption("top", static_cast<int>(FoldReach::kTop));
  reach_property_->addOption("flap", static_cast<int>(FoldReach::kFlap));
  reach_property_->addOption("segment", static_cast<int>(FoldReach::kSegment));
}

FoldTool::~FoldTool() = default;

void FoldTool::onInitialize() {
  setName("Fold");
  setDescription("Folds paper: click two points, or drag a corner onto a point");
  drawing_ = std::make_unique<FoldDrawing>(scene_manager_);
}

void FoldTool::chooseNode() {
  if (node_property_->getStdString() == link_->node()) return;
  gesture_.cancel();
  link_->choose(node_property_->getStdString());
}

void FoldTool::chooseReach() {
  gesture_.setReach(static_cast<FoldReach>(reach_property_->getOptionInt()));
}

/// Takes in what has been heard. Places on an earlier sheet mean nothing on this one.
void FoldTool::followPaper() {
  link_->poll();
  if (sheets_ == link_->sheets()) return;
  sheets_ = link_->sheets();
  if (gesture_.cancel()) tell("The paper has changed.", false);
}

void FoldTool::activate() {
  followPaper();
  status_.clear();
  showStatus();
}

void FoldTool::deactivate() {
  gesture_.cancel();
  preview_.clear();
  drawing_->clear();
  status_.clear();
}

void FoldTool::update(float /*wall_dt*/, float /*ros_dt*/) {
  requests_.poll();
  preview_.poll();
  followPaper();
  if (node_property_->getStdString() != link_->node()) {
    node_property_->setStdString(link_->node());  // the panel has chosen another
  }
  draw();
  showStatus();
}

/// Where the paper's world is in rviz's fixed frame, if TF knows.
std::optional<FramePose> FoldTool::world() {
  if (!link_->paper()) return std::nullopt;
  FramePose pose;
  const std::string& frame = link_->state().header.frame_id;
  if (!context_->getFrameManager()->getTransform(frame, ros::Time(), pose.position,
                                                 pose.orientation)) {
    return std::nullopt;
  }
  return pose;
}

std::optional<FoldTool::View> FoldTool::viewOf(rviz::RenderPanel& panel) {
  const std::optional<FramePose> pose = world();
  if (!pose || !panel.getCamera()) return std::nullopt;
  const Vector2 size(panel.width(), panel.height());
  return View{cameraFrom(*panel.getCamera(), *pose, size), eyeOf(*panel.getCamera(), *pose)};
}

MouseInput FoldTool::inputOf(const rviz::ViewportMouseEvent& event,
                             const std::optional<View>& view) {
  MouseInput input;
  input.event = eventOf(event);
  input.button = buttonOf(event);
  input.pixel = {event.x, event.y};
  input.control = event.modifiers & Qt::ControlModifier;
  input.shift = event.modifiers & Qt::ShiftModifier;
  input.notches = event.wheel_delta / kWheelNotch;
  if (!view) return input;
  input.spot = spotAt(input.pixel, view->camera, *link_->paper(), link_->caster(), gesture_.from());
  if (input.spot && input.spot->crease >= 0) {
    input.crease_angle = link_->paper()->creaseAngle(input.spot->crease);
  }
  return input;
}

int FoldTool::processMouseEvent(rviz::ViewportMouseEvent& event) {
  if (panel_ != event.panel) {
    if (panel_) panel_->removeEventFilter(this);
    panel_ = event.panel;
    panel_->installEventFilter(this);
  }
  followPaper();
  view_ = viewOf(*event.panel);
  const MouseInput input = inputOf(event, view_);
  if (input.event == MouseEvent::kPress) notice_.clear();
  const Reaction reaction = gesture_.handle(input);
  if (reaction.request) carryOut(*reaction.request);
  if (!reaction.taken && event.panel->getViewController()) {
    event.panel->getViewController()->handleMouseEvent(event);
    status_.clear();  // it has written into the status bar
  }
  showStatus();
  return Render;
}

int FoldTool::processKeyEvent(QKeyEvent* event, rviz::RenderPanel* /*panel*/) {
  followPaper();
  const Reaction reaction = gesture_.press(keyOf(*event));
  if (reaction.request) carryOut(*reaction.request);
  showStatus();
  return Render;
}

bool FoldTool::eventFilter(QObject* watched, QEvent* event) {
  const bool escape =
      event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
  if (escape && gesture_.cancel()) {
    showStatus();
    return true;
  }
  return rviz::Tool::eventFilter(watched, event);
}

void FoldTool::carryOut(const MouseRequest& request) {
  if (!link_->paper()) return;
  std::visit([this](const auto& what) { make(what); }, request);
}

template <class Service>
void FoldTool::ask(const std::string& service, const typename Service::Request& request) {
  notice_ = "...";
  requests_.ask<Service>(link_->resolved(service), request,
                         [this](const typename Service::Response& response) {
                           tell(response.message, !response.success);
                         });
}

void FoldTool::make(const LaidFold& fold) {
  if (!view_) return tell(problem(), true);
  const auto seen = seenFold(fold, *link_->paper(), view_->eye);
  if (!seen) return tell("The two points lie on each other.", true);
  if (fold.reach == FoldReach::kSegment) {
    const bool front = showsFront(*link_->paper(), fold.first.place.triangle, view_->eye);
    ask<msg::Fold>("fold", foldRequest(fold, front, name_));
  } else {
    ask<msg::FoldThrough>("fold_through", foldThroughRequest(fold, *seen, name_));
  }
  name_.clear();
}

void FoldTool::make(const TurnCrease& turn) {
  ask<msg::Fold>("fold", foldRequest(turn, link_->paper()->sheet()));
}

void FoldTool::make(const TogglePin& pin) {
  const auto vertex = static_cast<std::uint32_t>(pin.vertex);
  if (link_->isPinned(pin.vertex)) {
    msg::Unpin::Request request;
    request.vertices = {vertex};
    ask<msg::Unpin>("unpin", request);
  } else {
    msg::Pin::Request request;
    request.vertices = {vertex};
    ask<msg::Pin>("pin", request);
  }
}

void FoldTool::make(const OpenMenu& menu) {
  auto* panel = qobject_cast<rviz::RenderPanel*>(panel_);
  if (!panel) return;
  MenuActions actions;
  actions.toggle_pin = [this](int vertex) { make(TogglePin{vertex}); };
  actions.grasp = [this](const msg::Grasp::Request& r) { ask<msg::Grasp>("grasp", r); };
  actions.release = [this](const msg::Release::Request& r) { ask<msg::Release>("release", r); };
  actions.add_vertex = [this](const msg::AddVertex::Request& r) {
    ask<msg::AddVertex>("add_vertex", r);
  };
  actions.fold = [this](const msg::Fold::Request& r) { ask<msg::Fold>("fold", r); };
  actions.name = [this](const std::string& name) {
    name_ = name;
    tell("The next fold is called " + name + ".", false);
  };
  panel->showContextMenu(foldMenu(menu.spot, *link_, actions));
}

void FoldTool::tell(const std::string& message, bool refused) {
  notice_ = refused ? refusal(message) : plain(message);
}

void FoldTool::draw() {
  const std::optional<FramePose> pose = world();
  if (!pose) {
    preview_.clear();
    return drawing_->clear();
  }
  const ShownPaper& paper = *link_->paper();
  drawing_->place(*pose);
  drawing_->setSize(paper.sheet().size());
  const std::optional<Spot>& pointer = gesture_.pointer();
  if (pointer) drawing_->showPointer(paper.point(pointer->place), pointer->kind != SnapKind::kFree);
  else drawing_->hidePointer();
  const std::optional<LaidFold> fold = gesture_.preview();
  if (fold && view_) preview_.show(*fold, view_->eye);
  else preview_.clear();
  preview_.draw(*drawing_);
}

std::string FoldTool::problem() {
  const std::string of_link = link_->problem();
  if (!of_link.empty()) return of_link;
  if (world()) return "";
  return "TF knows no way from \"" + link_->state().header.frame_id + "\" to the fixed frame \"" +
         context_->getFixedFrame().toStdString() + "\"";
}

void FoldTool::showStatus() {
  const std::string missing = problem();
  std::string text = missing.empty() ? "" : refusal(missing);
  if (text.empty()) {
    text = notice_.empty() ? "" : notice_ + kBetween;
    text += statusText(gesture_, preview_, *link_);
  }
  const QString status = QString::fromStdString(text);
  if (status == status_) return;
  status_ = status;
  setStatus(status);
}

}  // namespace shell_origami

PLUGINLIB_EXPORT_CLASS(shell_origami::FoldTool, rviz::Tool)
