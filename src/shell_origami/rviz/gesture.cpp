#include <shell_origami/rviz/gesture.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace shell_origami {
namespace {

/// Two points of the flat sheet nearer to each other are the same [m].
constexpr double kSamePoint = 1e-9;
/// More digits no angle needs.
constexpr std::size_t kMostTyped = 8;

double clampAngle(double angle) {
  return std::clamp(angle, -Gesture::kMostAngle, Gesture::kMostAngle);
}

bool isSamePoint(const Spot& a, const Spot& b) { return (a.flat - b.flat).norm() < kSamePoint; }

/// Returns the reach that keys ask for, if any.
std::optional<FoldReach> reachOf(const MouseInput& input) {
  if (input.control && input.shift) return FoldReach::kSegment;
  if (input.control) return FoldReach::kTop;
  if (input.shift) return FoldReach::kFlap;
  return std::nullopt;
}

bool isNear(const MouseInput& a, const MouseInput& b) {
  return (a.pixel - b.pixel).norm() <= Gesture::kClickPixels;
}

}  // namespace

Reaction Gesture::handle(const MouseInput& input) {
  pointer_ = input.spot;
  const bool left = input.button == MouseButton::kLeft;
  const bool right = input.button == MouseButton::kRight;
  switch (input.event) {
    case MouseEvent::kMove: return move(input);
    case MouseEvent::kWheel: return wheel(input);
    case MouseEvent::kDoubleClick: return left ? doubleClick(input) : Reaction{};
    case MouseEvent::kPress:
      if (left) return pressLeft(input);
      if (right) right_press_ = input;
      return {};
    case MouseEvent::kRelease:
      if (left) return releaseLeft(input);
      return right ? releaseRight(input) : Reaction{};
  }
  return {};
}

Reaction Gesture::move(const MouseInput& input) {
  if (right_press_ && !isNear(*right_press_, input)) right_press_.reset();
  if (left_press_ && !dragging_ && !isNear(*left_press_, input)) {
    dragging_ = true;
    beginDrag(*left_press_);
  }
  if (phase_ == Phase::kLine || phase_ == Phase::kBring) {
    laid_->reach = reachOf(input).value_or(default_reach_);
  }
  if (!dragging_) {
    if (phase_ == Phase::kAngle && input.spot) laid_->moving = input.spot->flat;
    return {};
  }
  const double angle =
      clampAngle(start_angle_ + kPixel * (left_press_->pixel.y() - input.pixel.y()));
  if (phase_ == Phase::kTurn) turning_.angle = angle;
  if (phase_ == Phase::kAngle) setAngle(angle);
  return {taken_, {}};
}

/// A drag from a corner, on a crease or of a laid fold is a gesture; any other is the camera's.
void Gesture::beginDrag(const MouseInput& input) {
  taken_ = false;
  if (phase_ == Phase::kAngle) {
    taken_ = true;
    start_angle_ = angle_;
  } else if (phase_ == Phase::kIdle && input.spot) {
    const SnapKind kind = input.spot->kind;
    if (kind == SnapKind::kCorner || kind == SnapKind::kVertex) {
      phase_ = Phase::kBring;
      laid_ = LaidFold();
      laid_->bring = true;
      laid_->first = laid_->second = *input.spot;
      laid_->reach = reachOf(input).value_or(default_reach_);
      taken_ = true;
    } else if (input.spot->crease >= 0) {
      phase_ = Phase::kTurn;
      start_angle_ = input.crease_angle;
      turning_ = {input.spot->crease, input.crease_angle};
      taken_ = true;
    }
  }
}

Reaction Gesture::pressLeft(const MouseInput& input) {
  left_press_ = input;
  dragging_ = false;
  // The camera turns by what is dragged: it must hear of the press where the drag may be its own.
  const bool grips = phase_ == Phase::kIdle && input.spot &&
                     (input.spot->kind <= SnapKind::kVertex || input.spot->crease >= 0);
  return {phase_ == Phase::kAngle || grips, {}};
}

Reaction Gesture::releaseLeft(const MouseInput& input) {
  if (!left_press_) return {};
  const bool dragged = dragging_;
  left_press_.reset();
  dragging_ = false;
  if (!dragged) return click(input);
  if (phase_ == Phase::kBring) {
    if (input.spot && !isSamePoint(*input.spot, laid_->first)) {
      lay(input, true);
    } else {
      end();
    }
    return {true, {}};
  }
  if (phase_ == Phase::kTurn) {
    const TurnCrease turned = turning_;
    end();
    return {true, turned};
  }
  return {taken_, {}};
}

Reaction Gesture::click(const MouseInput& input) {
  if (phase_ == Phase::kAngle) {
    laid_->reach = reachOf(input).value_or(laid_->reach);
    return fold();
  }
  if (!input.spot) return {};
  if (phase_ == Phase::kIdle) {
    phase_ = Phase::kLine;
    laid_ = LaidFold();
    laid_->first = laid_->second = *input.spot;
  } else if (phase_ == Phase::kLine && !isSamePoint(*input.spot, laid_->first)) {
    lay(input, false);
  }
  // The camera has heard of the press.
  return {};
}

void Gesture::lay(const MouseInput& input, bool bring) {
  laid_->bring = bring;
  laid_->second = *input.spot;
  laid_->reach = reachOf(input).value_or(default_reach_);
  phase_ = Phase::kAngle;
}

Reaction Gesture::fold() {
  const LaidFold laid = *preview();
  end();
  return {true, laid};
}

/// The first click of a double click has begun a line.
Reaction Gesture::doubleClick(const MouseInput& input) {
  if (phase_ == Phase::kAngle) return pressLeft(input);
  const bool pins = phase_ == Phase::kLine && input.spot && isSamePoint(*input.spot, laid_->first);
  const std::optional<Spot> spot = input.spot;
  if (!pins) return pressLeft(input);
  end();
  return {true, TogglePin{spot->vertex}};
}

Reaction Gesture::releaseRight(const MouseInput& input) {
  const bool clicked = right_press_.has_value();
  right_press_.reset();
  if (!clicked) return {};
  if (cancel() || !input.spot) return {};
  return {false, OpenMenu{*input.spot}};
}

Reaction Gesture::wheel(const MouseInput& input) {
  if (phase_ != Phase::kAngle) return {};
  laid_->reach = reachOf(input).value_or(laid_->reach);
  typed_.clear();
  setAngle(angle_ + input.notches * kNotch);
  return {true, {}};
}

Reaction Gesture::press(char key) {
  if (phase_ == Phase::kIdle || phase_ == Phase::kTurn) return {};
  if (key == '\n') return phase_ == Phase::kAngle ? fold() : Reaction{};
  if (key == '\b') {
    if (!typed_.empty()) typed_.pop_back();
  } else if (key == '-') {
    if (typed_.empty() || typed_[0] != '-') typed_.insert(0, "-");
    else typed_.erase(0, 1);
  } else if ((key >= '0' && key <= '9') || (key == '.' && typed_.find('.') == std::string::npos)) {
    if (typed_.size() < kMostTyped) typed_ += key;
  } else {
    return {};
  }
  const double degrees = std::strtod(typed_.c_str(), nullptr);
  if (degrees != 0 && std::abs(degrees) < 180) angle_ = clampAngle(degrees * M_PI / 180);
  return {true, {}};
}

bool Gesture::cancel() {
  const bool under_way = phase_ != Phase::kIdle;
  end();
  pointer_.reset();
  return under_way;
}

void Gesture::end() {
  phase_ = Phase::kIdle;
  laid_.reset();
  left_press_.reset();
  right_press_.reset();
  dragging_ = taken_ = false;
  typed_.clear();
}

void Gesture::setAngle(double angle) {
  angle = clampAngle(angle);
  if (angle != 0) angle_ = angle;
}

std::optional<LaidFold> Gesture::preview() const {
  if (!laid_) return std::nullopt;
  LaidFold fold = *laid_;
  fold.angle = angle_;
  if (phase_ == Phase::kAngle) return fold;
  if (!pointer_ || isSamePoint(*pointer_, fold.first)) return std::nullopt;
  fold.second = *pointer_;
  return fold;
}

std::optional<TurnCrease> Gesture::turning() const {
  if (phase_ != Phase::kTurn) return std::nullopt;
  return turning_;
}

std::optional<Vector2> Gesture::from() const {
  if (phase_ != Phase::kLine) return std::nullopt;
  return laid_->first.flat;
}

}  // namespace shell_origami
