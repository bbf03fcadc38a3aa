/// Crease patterns drawn as SVG, in the colors of Origami Simulator.
#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/line_drawing.h>
#include <shell_origami/fold_format/svg_shapes.h>
#include <shell_origami/fold_format/svg_style.h>
#include <shell_origami/fold_format/xml.h>

#include <cmath>
#include <limits>
#include <set>

namespace shell_origami {
namespace {

using tinyxml2::XMLElement;

const std::set<std::string> kGroups{"g", "a", "switch"};
const std::set<std::string> kShapes{"line", "polyline", "polygon", "rect", "path"};
/// Elements that may draw lines but are not read.
const std::set<std::string> kOtherShapes{"circle", "ellipse", "use", "text", "image", "svg"};

/// The first words, for a message.
std::string listed(const std::set<std::string>& words) {
  constexpr std::size_t kMost = 5;
  std::string text;
  std::size_t count = 0;
  for (const std::string& word : words) {
    if (++count > kMost) return text + ", ...";
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

void readStyleSheets(const XMLElement& element, SvgStyleSheet& sheet) {
  if (localName(element) == "style") sheet.add(textOf(element));
  for (const auto* child = element.FirstChildElement(); child;
       child = child->NextSiblingElement()) {
    readStyleSheets(*child, sheet);
  }
}

class SvgReader {
 public:
  explicit SvgReader(const XMLElement& root) {
    readStyleSheets(root, sheet_);
    readChildren(root, SvgStyle{}.of(root, sheet_), Eigen::Affine2d::Identity());
  }

  LineDrawing take() {
    if (!colors_.empty()) {
      drawing_.notes.push_back("lines of other colors than those of creases were passed over: " +
                               listed(colors_));
    }
    if (!other_shapes_.empty()) {
      drawing_.notes.push_back("elements that are not straight lines were passed over: " +
                               listed(other_shapes_));
    }
    return std::move(drawing_);
  }

 private:
  void readChildren(const XMLElement& group, const SvgStyle& style,
                    const Eigen::Affine2d& transform) {
    for (const auto* child = group.FirstChildElement(); child;
         child = child->NextSiblingElement()) {
      const std::string name = localName(*child);
      const bool is_group = kGroups.count(name) > 0, is_shape = kShapes.count(name) > 0;
      if (kOtherShapes.count(name) > 0) other_shapes_.insert(name);
      if (!is_group && !is_shape) continue;
      const SvgStyle own = style.of(*child, sheet_);
      const Eigen::Affine2d placed = transform * transformOf(*child);
      if (is_group) readChildren(*child, own, placed);
      else if (own.isDrawn()) readShape(*child, own, placed);
    }
  }

  void readShape(const XMLElement& element, const SvgStyle& style,
                 const Eigen::Affine2d& transform) {
    const char kind = style.kind();
    if (kind == '\0') {
      colors_.insert(style.stroke.substr(0, 60));
      return;
    }
    double angle = style.opacity * style.stroke_opacity * M_PI;
    if (kind == 'M') angle = 0 - angle;  // not -0
    else if (kind == 'U') angle = std::numeric_limits<double>::quiet_NaN();
    else if (kind != 'V') angle = 0;
    for (const Polyline& polyline : polylinesOf(element)) {
      for (std::size_t k = 1; k < polyline.size(); ++k) {
        drawing_.add(
            {transform * polyline[k - 1], transform * polyline[k], kind, angle, placeOf(element)});
      }
    }
  }

  SvgStyleSheet sheet_;
  LineDrawing drawing_;
  std::set<std::string> colors_, other_shapes_;  ///< that were passed over
};

}  // namespace

LineDrawing readSvg(const std::string& text) {
  tinyxml2::XMLDocument document;
  parseXml(text, document);
  const XMLElement& root = *document.RootElement();
  if (localName(root) != "svg") reject(placeOf(root), " is its root, not <svg>");
  return SvgReader(root).take();
}

}  // namespace shell_origami
