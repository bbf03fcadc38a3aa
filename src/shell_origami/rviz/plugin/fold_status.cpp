#include <shell_origami/rviz/plugin/fold_status.h>

#include <QString>

#include <array>
#include <cmath>
#include <cstdio>

namespace shell_origami {
namespace {

std::string angleText(double angle) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g°", angle * 180 / M_PI);
  return text.data();
}

std::string reachText(FoldReach reach) {
  switch (reach) {
    case FoldReach::kAll: return "all layers";
    case FoldReach::kTop: return "the top layer";
    case FoldReach::kFlap: return "the flap";
    case FoldReach::kSegment: return "this segment";
  }
  return "";
}

std::string foldText(const LaidFold& fold, const Gesture& gesture) {
  const std::string angle =
      gesture.typed().empty() ? angleText(fold.angle) : gesture.typed() + "_°";
  return "<b>" + angle + (fold.angle < 0 ? " behind" : "") + "</b>, " + reachText(fold.reach);
}

std::string previewText(const FoldPreview& preview) {
  if (preview.refused()) return refusal(preview.message()) + kBetween;
  if (preview.creases() == 0) return "";
  return std::to_string(preview.creases()) + (preview.creases() == 1 ? " crease" : " creases") +
         kBetween;
}

}  // namespace

std::string refusal(const std::string& message) {
  return "<span style=\"color:#b00020\"><b>" + plain(message) + "</b></span>";
}

std::string plain(const std::string& message) {
  return QString::fromStdString(message).toHtmlEscaped().toStdString();
}

std::string statusText(const Gesture& gesture, const FoldPreview& preview, const PaperLink& link) {
  using Phase = Gesture::Phase;
  const ShownPaper& paper = *link.paper();
  const std::string spot =
      gesture.pointer() ? plain(describe(*gesture.pointer(), paper)) + ". " : "";
  const std::optional<LaidFold> fold = gesture.preview();
  const std::string said = previewText(preview);
  switch (gesture.phase()) {
    case Phase::kIdle:
      return spot +
             "<b>Click:</b> line. <b>Drag:</b> corner onto a point, crease to an angle. "
             "<b>Double click:</b> pin. <b>Right:</b> more.";
    case Phase::kLine:
      return said + spot +
             "<b>Click</b> the second point. <b>Ctrl:</b> top layer. "
             "<b>Shift:</b> flap. <b>Both:</b> segment. <b>Esc:</b> cancel.";
    case Phase::kBring: return said + spot + "<b>Let go</b> where the corner is to come.";
    case Phase::kAngle:
      return said + foldText(*fold, gesture) +
             ". <b>Wheel, digits, drag:</b> angle. <b>Pointer:</b> side that moves. "
             "<b>Click, Enter:</b> fold. <b>Esc:</b> cancel.";
    case Phase::kTurn:
      return "crease " + plain(paper.sheet().creases()[gesture.turning()->crease].name) + ": <b>" +
             angleText(gesture.turning()->angle) + "</b>. <b>Let go</b> to fold it.";
  }
  return "";
}

}  // namespace shell_origami
