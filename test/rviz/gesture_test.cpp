#include <shell_origami/rviz/gesture.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180;

Spot corner(double x, double y) {
  Spot spot;
  spot.kind = SnapKind::kCorner;
  spot.flat = {x, y};
  spot.vertex = static_cast<int>(100 * x + y);
  return spot;
}

Spot onCrease(double x, double y, int crease) {
  Spot spot = corner(x, y);
  spot.kind = SnapKind::kCrease;
  spot.crease = crease;
  return spot;
}

Spot onPaper(double x, double y) {
  Spot spot = corner(x, y);
  spot.kind = SnapKind::kFree;
  return spot;
}

/// A mouse over a paper on which a pixel is a flat unit. Remembers what was asked for.
class Mouse {
 public:
  void send(MouseEvent event, MouseButton button, const Vector2& pixel,
            const std::optional<Spot>& spot) {
    MouseInput input;
    input.event = event;
    input.button = button;
    input.pixel = pixel;
    input.spot = spot;
    input.control = control;
    input.shift = shift;
    input.notches = notches;
    input.crease_angle = crease_angle;
    remember(gesture.handle(input));
  }
  void move(const Spot& spot) { send(MouseEvent::kMove, MouseButton::kNone, spot.flat, spot); }
  void leave() { send(MouseEvent::kMove, MouseButton::kNone, {-50, -50}, std::nullopt); }
  void press(const Spot& spot) { send(MouseEvent::kPress, MouseButton::kLeft, spot.flat, spot); }
  void release(const Spot& spot) {
    send(MouseEvent::kRelease, MouseButton::kLeft, spot.flat, spot);
  }
  void click(const Spot& spot) {
    move(spot);
    press(spot);
    release(spot);
  }
  void drag(const Spot& from, const Spot& to) {
    move(from);
    press(from);
    move(to);
    release(to);
  }
  void doubleClick(const Spot& spot) {
    click(spot);
    send(MouseEvent::kDoubleClick, MouseButton::kLeft, spot.flat, spot);
    release(spot);
  }
  void clickRight(const Vector2& pixel, const std::optional<Spot>& spot) {
    send(MouseEvent::kPress, MouseButton::kRight, pixel, spot);
    send(MouseEvent::kRelease, MouseButton::kRight, pixel, spot);
  }
  void clickRight(const Spot& spot) { clickRight(spot.flat, spot); }
  void clickBeside() {
    send(MouseEvent::kPress, MouseButton::kLeft, {-50, -50}, std::nullopt);
    send(MouseEvent::kRelease, MouseButton::kLeft, {-50, -50}, std::nullopt);
  }
  void wheel(double by) {
    notches = by;
    send(MouseEvent::kWheel, MouseButton::kNone, {0, 0}, std::nullopt);
    notches = 0;
  }
  void type(const std::string& keys) {
    for (char key : keys) remember(gesture.press(key));
  }
  void remember(const Reaction& reaction) {
    taken = reaction.taken;
    if (reaction.request) requests.push_back(*reaction.request);
  }

  /// The only request so far. Fails where there is another number of them, or it is of another
  /// kind.
  template <class Request>
  Request only() const {
    EXPECT_EQ(requests.size(), 1U);
    if (requests.size() != 1 || !std::holds_alternative<Request>(requests[0])) {
      ADD_FAILURE() << "another request";
      return {};
    }
    return std::get<Request>(requests[0]);
  }

  Gesture gesture;
  bool control = false, shift = false, taken = false;
  double notches = 0, crease_angle = 0;
  std::vector<MouseRequest> requests;
};

const Spot kA = corner(0, 0), kB = corner(100, 100), kC = corner(100, 0);
const Spot kP = onPaper(40, 20), kQ = onPaper(60, 80), kOnCrease = onCrease(50, 50, 7);

TEST(Gesture, TwoClicksAndAThirdFoldAlongALine) {
  Mouse mouse;
  mouse.click(kP);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kLine);
  EXPECT_EQ(*mouse.gesture.from(), kP.flat);
  mouse.move(kQ);
  ASSERT_TRUE(mouse.gesture.preview());
  EXPECT_EQ(mouse.gesture.preview()->second.flat, kQ.flat);
  mouse.click(kQ);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kAngle);
  mouse.click(kC);
  const LaidFold fold = mouse.only<LaidFold>();
  EXPECT_FALSE(fold.bring);
  EXPECT_EQ(fold.first.flat, kP.flat);
  EXPECT_EQ(fold.second.flat, kQ.flat);
  EXPECT_EQ(*fold.moving, kC.flat) << "the side under the pointer moves";
  EXPECT_EQ(fold.reach, FoldReach::kAll);
  EXPECT_DOUBLE_EQ(fold.angle, 178 * kDegree);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kIdle);
}

TEST(Gesture, EnterFolds) {
  Mouse mouse;
  mouse.click(kP);
  mouse.type("\n");
  EXPECT_TRUE(mouse.requests.empty());
  mouse.click(kQ);
  mouse.type("\n");
  EXPECT_FALSE(mouse.only<LaidFold>().moving)
      << "where the pointer says no side the node's default";
}

TEST(Gesture, ACornerIsBroughtToAPoint) {
  Mouse mouse;
  mouse.move(kA);
  mouse.press(kA);
  EXPECT_TRUE(mouse.taken) << "or the camera turns";
  mouse.move(kQ);
  EXPECT_TRUE(mouse.taken);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kBring);
  EXPECT_TRUE(mouse.gesture.preview()->bring);
  mouse.release(kQ);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kAngle);
  mouse.type("\n");
  const LaidFold fold = mouse.only<LaidFold>();
  EXPECT_TRUE(fold.bring);
  EXPECT_EQ(fold.first.flat, kA.flat);
  EXPECT_EQ(fold.second.flat, kQ.flat);
}

TEST(Gesture, TheAngleIsTyped) {
  Mouse mouse;
  mouse.click(kP);
  mouse.type("9");
  mouse.click(kQ);
  mouse.type("0.5");
  EXPECT_EQ(mouse.gesture.typed(), "90.5");
  EXPECT_DOUBLE_EQ(mouse.gesture.angle(), 90.5 * kDegree);
  mouse.type("\b\b-");
  EXPECT_DOUBLE_EQ(mouse.gesture.angle(), -90 * kDegree);
  mouse.type("-\n");
  EXPECT_DOUBLE_EQ(mouse.only<LaidFold>().angle, 90 * kDegree);
  EXPECT_DOUBLE_EQ(mouse.gesture.angle(), 90 * kDegree) << "stays for the next fold";
}

TEST(Gesture, AnglesOutOfBoundsAreNotTaken) {
  Mouse mouse;
  mouse.click(kP);
  mouse.click(kQ);
  mouse.type("1800000000..");
  EXPECT_DOUBLE_EQ(mouse.gesture.angle(), 18 * kDegree) << "the last one that is one";
  mouse.type("\b\b\b\b\b\b\b\b\b\b0");
  EXPECT_DOUBLE_EQ(mouse.gesture.angle(), 1 * kDegree) << "0 is no fold";
}

TEST(Gesture, TheWheelTurnsTheAngle) {
  Mouse mouse;
  mouse.wheel(1);
  EXPECT_FALSE(mouse.taken) << "zooms";
  mouse.click(kP);
  mouse.click(kQ);
  mouse.wheel(-2);
  EXPECT_TRUE(mouse.taken);
  EXPECT_NEAR(mouse.gesture.angle(), 168 * kDegree, 1e-12);
  mouse.wheel(100);
  EXPECT_DOUBLE_EQ(mouse.gesture.angle(), Gesture::kMostAngle);
}

TEST(Gesture, ADragTurnsTheAngleOfALaidFold) {
  Mouse mouse;
  mouse.gesture.setAngle(90 * kDegree);
  mouse.click(kP);
  mouse.click(kQ);
  mouse.drag(onPaper(30, 30), onPaper(30, 50));
  EXPECT_NEAR(mouse.gesture.angle(), 80 * kDegree, 1e-12) << "20 pixels down";
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kAngle);
  EXPECT_TRUE(mouse.requests.empty());
}

TEST(Gesture, KeysSayWhichLayers) {
  const auto reach = [](bool control, bool shift) {
    Mouse mouse;
    mouse.click(kP);
    mouse.control = control;
    mouse.shift = shift;
    mouse.click(kQ);
    mouse.control = mouse.shift = false;
    mouse.type("\n");
    return mouse.only<LaidFold>().reach;
  };
  EXPECT_EQ(reach(false, false), FoldReach::kAll);
  EXPECT_EQ(reach(true, false), FoldReach::kTop);
  EXPECT_EQ(reach(false, true), FoldReach::kFlap);
  EXPECT_EQ(reach(true, true), FoldReach::kSegment);
}

TEST(Gesture, KeysAsTheFoldIsMadeCountToo) {
  Mouse mouse;
  mouse.click(kP);
  mouse.click(kQ);
  mouse.control = true;
  mouse.click(kC);
  EXPECT_EQ(mouse.only<LaidFold>().reach, FoldReach::kTop);
}

TEST(Gesture, ADraggedCreaseTurns) {
  Mouse mouse;
  mouse.crease_angle = -30 * kDegree;
  mouse.press(kOnCrease);
  EXPECT_TRUE(mouse.taken);
  mouse.move(onPaper(50, 20));
  ASSERT_TRUE(mouse.gesture.turning());
  EXPECT_NEAR(mouse.gesture.turning()->angle, -15 * kDegree, 1e-12);
  mouse.release(onPaper(50, 10));
  EXPECT_EQ(mouse.only<TurnCrease>().crease, 7);
}

TEST(Gesture, ALineMayStartOnACrease) {
  Mouse mouse;
  mouse.click(kOnCrease);
  mouse.click(kP);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kAngle);
}

TEST(Gesture, ADoubleClickPins) {
  Mouse mouse;
  mouse.doubleClick(kB);
  EXPECT_EQ(mouse.only<TogglePin>().vertex, kB.vertex);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kIdle);
  EXPECT_FALSE(mouse.gesture.preview());
}

TEST(Gesture, ARightClickOpensTheMenu) {
  Mouse mouse;
  mouse.clickRight(kQ);
  EXPECT_EQ(mouse.only<OpenMenu>().spot.flat, kQ.flat);
}

TEST(Gesture, TheCameraHasWhatIsNoGesture) {
  Mouse mouse;
  mouse.press(kP);
  EXPECT_FALSE(mouse.taken);
  mouse.move(kQ);
  EXPECT_FALSE(mouse.taken);
  mouse.release(kQ);
  EXPECT_FALSE(mouse.taken);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kIdle);
}

TEST(Gesture, TheCameraTurnsWhileALineIsLaid) {
  Mouse mouse;
  mouse.click(kP);
  mouse.drag(kC, kQ);
  EXPECT_FALSE(mouse.taken);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kLine);
  mouse.click(kQ);
  EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kAngle);
}

/// Sequences that fold nothing, each followed by an Esc.
const std::vector<std::function<void(Mouse&)>> kWrong{
    [](Mouse& m) { m.click(kP); },
    [](Mouse& m) { m.click(kP), m.clickBeside(); },
    [](Mouse& m) { m.click(kP), m.click(kP); },
    [](Mouse& m) { m.clickBeside(), m.clickBeside(); },
    [](Mouse& m) {
      m.click(kP), m.clickRight({5, 5}, std::nullopt);
    },
    [](Mouse& m) { m.click(kP), m.click(kQ), m.clickRight(kQ); },
    [](Mouse& m) { m.click(kP), m.click(kQ), m.type("12-.x"); },
    [](Mouse& m) { m.type("90\n"); },
    [](Mouse& m) { m.click(kP), m.type("\n\n"); },
    [](Mouse& m) { m.drag(kA, kA); },
    [](Mouse& m) { m.press(kA), m.move(kQ), m.leave(); },
    [](Mouse& m) { m.press(kA), m.move(kQ), m.clickRight(kQ), m.release(kQ); },
    [](Mouse& m) { m.press(kA), m.move(kQ), m.move(kA), m.release(kA); },
    [](Mouse& m) { m.press(kOnCrease), m.move(kQ), m.clickRight(kQ), m.release(kQ); },
    [](Mouse& m) { m.release(kA), m.release(kQ); },
    [](Mouse& m) { m.press(kA), m.press(kA); },
    [](Mouse& m) { m.send(MouseEvent::kRelease, MouseButton::kRight, kP.flat, kP); },
    [](Mouse& m) { m.send(MouseEvent::kDoubleClick, MouseButton::kLeft, kP.flat, kP); },
    [](Mouse& m) {
      m.clickRight({5, 5}, std::nullopt);
    },
    [](Mouse& m) { m.wheel(3), m.wheel(-300), m.leave(); },
    [](Mouse& m) { m.press(kA), m.move(kQ), m.wheel(2), m.type("5"); },
    [](Mouse& m) { m.click(kP), m.click(kQ), m.drag(kP, kQ), m.type("\b\b"); },
    [](Mouse& m) { m.send(MouseEvent::kPress, MouseButton::kRight, kP.flat, kP), m.move(kQ); },
    [](Mouse& m) { m.click(kP), m.drag(kA, kB); },
};

TEST(Gesture, WrongSequencesLeaveNothingBehind) {
  ASSERT_GE(kWrong.size(), 20U);
  for (std::size_t i = 0; i < kWrong.size(); ++i) {
    Mouse mouse;
    kWrong[i](mouse);
    EXPECT_TRUE(mouse.requests.empty()) << "sequence " << i;
    mouse.gesture.cancel();
    EXPECT_EQ(mouse.gesture.phase(), Gesture::Phase::kIdle);
    EXPECT_FALSE(mouse.gesture.preview() || mouse.gesture.turning() || mouse.gesture.from());
    EXPECT_FALSE(mouse.gesture.pointer()) << "which may be a place on another paper";
    EXPECT_TRUE(mouse.gesture.typed().empty());
    // What comes after it is as if it had not been.
    mouse.gesture.setAngle(90 * kDegree);
    mouse.click(kP);
    mouse.click(kQ);
    mouse.type("\n");
    const LaidFold fold = mouse.only<LaidFold>();
    EXPECT_EQ(fold.first.flat, kP.flat) << "sequence " << i;
    EXPECT_EQ(fold.second.flat, kQ.flat) << "sequence " << i;
    EXPECT_FALSE(fold.moving) << "sequence " << i;
    EXPECT_DOUBLE_EQ(fold.angle, 90 * kDegree) << "sequence " << i;
  }
}

}  // namespace
}  // namespace shell_origami
