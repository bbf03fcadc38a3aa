/// \file
/// Turns mouse events and keys into requests: lines, folds, pins and others.
#pragma once

#include <shell_origami/rviz/laid_fold.h>

#include <optional>
#include <string>

namespace shell_origami {

enum class MouseEvent { kMove, kPress, kRelease, kDoubleClick, kWheel };
enum class MouseButton { kNone, kLeft, kRight };

struct MouseInput {
  MouseEvent event = MouseEvent::kMove;
  MouseButton button = MouseButton::kNone;  ///< that was pressed or released
  Vector2 pixel = Vector2::Zero();
  std::optional<Spot> spot;  ///< where the pointer is on the paper
  bool control = false, shift = false;
  double notches = 0;       ///< of the wheel, away from the person > 0
  double crease_angle = 0;  ///< of the spot's crease [rad]
};

/// The answer of a gesture to a mouse event or a key.
struct Reaction {
  bool taken = false;  ///< otherwise the event is the camera's
  std::optional<MouseRequest> request;
};

/// Folds with the mouse. Two clicks lay a line, or a corner is dragged onto a point; then the
/// wheel, digits or a drag set the angle, and a click or Enter folds. A crease that is dragged
/// changes its angle, a double click pins or unpins, a right click opens a menu. Esc or a right
/// click during a gesture leave nothing behind. What it does not take moves the camera. Ctrl takes
/// the top layer alone, Shift a flap, both together the segment, where they are held as the fold is
/// laid or made.
///
///            click          click            click, Enter
///     kIdle -------> kLine --------> kAngle --------------> kIdle, LaidFold
///       |  drag a corner     release   |
///       +--------------> kBring -------+
///       |  drag a crease     release
///       +--------------> kTurn --------> kIdle, TurnCrease
class Gesture {
 public:
  enum class Phase {
    kIdle,   ///< nothing has begun
    kLine,   ///< a line has its first point
    kBring,  ///< a corner is being dragged
    kAngle,  ///< a fold is laid
    kTurn,   ///< a crease is being dragged
  };
  /// A pointer that moves farther while a button is held drags instead of clicking [pixel].
  static constexpr double kClickPixels = 4;
  /// One notch of the wheel, and one pixel of a drag [rad].
  static constexpr double kNotch = 5 * M_PI / 180, kPixel = 0.5 * M_PI / 180;
  static constexpr double kMostAngle = 179 * M_PI / 180;  ///< [rad]

  Reaction handle(const MouseInput& input);
  /// \param key  a digit, '-', '.', '\b', or '\n' for Enter; others are not taken
  Reaction press(char key);
  /// Leaves nothing behind. Returns whether a gesture was under way.
  bool cancel();

  Phase phase() const { return phase_; }
  /// The fold as it would be made now: laid, or with the pointer as its second point.
  std::optional<LaidFold> preview() const;
  /// The crease that is being dragged, with its angle now.
  std::optional<TurnCrease> turning() const;
  /// The first point of a line, from which directions count.
  std::optional<Vector2> from() const;
  const std::optional<Spot>& pointer() const { return pointer_; }

  /// The angle [rad] and reach of the next fold. The angle stays from one fold to the next.
  double angle() const { return angle_; }
  void setAngle(double angle);
  void setReach(FoldReach reach) { default_reach_ = reach; }
  /// The angle as it is being typed, in degrees; empty: none is.
  const std::string& typed() const { return typed_; }

 private:
  Reaction move(const MouseInput& input);
  Reaction pressLeft(const MouseInput& input);
  Reaction releaseLeft(const MouseInput& input);
  Reaction releaseRight(const MouseInput& input);
  Reaction doubleClick(const MouseInput& input);
  Reaction wheel(const MouseInput& input);
  Reaction click(const MouseInput& input);
  void beginDrag(const MouseInput& input);
  Reaction fold();
  void lay(const MouseInput& input, bool bring);
  void end();

  Phase phase_ = Phase::kIdle;
  double angle_ = 178 * M_PI / 180;
  FoldReach default_reach_ = FoldReach::kAll;
  std::string typed_;
  std::optional<Spot> pointer_;
  std::optional<LaidFold> laid_;  ///< in kLine and kBring without its second point
  std::optional<MouseInput> left_press_, right_press_;
  bool dragging_ = false;   ///< the pointer has moved since the left button was pressed
  bool taken_ = false;      ///< the drag is the gesture's, not the camera's
  double start_angle_ = 0;  ///< of the drag that changes an angle [rad]
  TurnCrease turning_{-1, 0};
};

}  // namespace shell_origami
