#include <shell_origami/fold_format/svg_shapes.h>

#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/text_scanner.h>
#include <shell_origami/fold_format/xml.h>

#include <cctype>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

using tinyxml2::XMLElement;

std::string attribute(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value ? value : "";
}

/// A length of an element; 0 where it does not state it.
double lengthOf(const XMLElement& element, const char* name) {
  std::string text = trimmed(attribute(element, name));
  if (!element.Attribute(name)) return 0;
  const bool has_unit = text.size() > 2 && text.substr(text.size() - 2) == "px";
  const auto number = numberFrom(has_unit ? text.substr(0, text.size() - 2) : text);
  if (!number) {
    reject(placeOf(element), " has ", name, " '", text.substr(0, 60), "', not a finite number");
  }
  return *number;
}

std::vector<Polyline> lineOf(const XMLElement& element) {
  return {{{lengthOf(element, "x1"), lengthOf(element, "y1")},
           {lengthOf(element, "x2"), lengthOf(element, "y2")}}};
}

std::vector<Polyline> rectOf(const XMLElement& element) {
  const Vector2 corner(lengthOf(element, "x"), lengthOf(element, "y"));
  const double width = lengthOf(element, "width"), height = lengthOf(element, "height");
  if (!(width > 0 && height > 0)) reject(placeOf(element), " has no positive width and height");
  return {{corner, corner + Vector2(width, 0), corner + Vector2(width, height),
           corner + Vector2(0, height), corner}};
}

std::vector<Polyline> pointsOf(const XMLElement& element, bool is_closed) {
  Polyline points;
  for (TextScanner scanner(attribute(element, "points")); !scanner.atEnd();) {
    const auto x = scanner.number();
    const auto y = x ? scanner.number() : std::nullopt;
    if (!y) {
      reject(placeOf(element), " has points that are not pairs of finite numbers",
             scanner.atEnd() ? "" : ", from '" + scanner.rest() + "' on");
    }
    points.emplace_back(*x, *y);
  }
  if (points.size() < 2) reject(placeOf(element), " has fewer than two points");
  if (is_closed) points.push_back(points.front());
  return {points};
}

/// Reads the data of a path.
class PathReader {
 public:
  explicit PathReader(const XMLElement& element)
      : element_(element), scanner_(attribute(element, "d")) {}

  std::vector<Polyline> read() {
    while (!scanner_.atEnd()) {
      if (std::isalpha(static_cast<unsigned char>(scanner_.peek())) != 0) {
        command_ = scanner_.take();
        if (std::strchr("CcSsQqTtAa", command_)) {
          reject(placeOf(element_), " holds a curve (", command_,
                 "): only straight lines (M L H V Z) can be creases");
        }
        if (std::strchr("MmLlHhVvZz", command_) == nullptr) {
          reject(placeOf(element_), " holds the unknown command '", command_, "'");
        }
      } else if (command_ == '\0' || std::strchr("Zz", command_)) {
        reject(placeOf(element_), " holds no command before '", scanner_.rest(), "'");
      }
      follow();
    }
    return std::move(polylines_);
  }

 private:
  void follow() {
    const bool is_relative = std::islower(static_cast<unsigned char>(command_)) != 0;
    const Vector2 origin = is_relative ? at_ : Vector2(0, 0);
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command_)));
    if (kind != 'M' && !started_) {
      reject(placeOf(element_), " holds '", command_, "' before it has moved anywhere (M)");
    }
    if (kind == 'Z') return go(start_);
    if (kind == 'H') return go({origin.x() + number(), at_.y()});
    if (kind == 'V') return go({at_.x(), origin.y() + number()});
    const double x = number(), y = number();
    if (kind == 'L') return go(origin + Vector2(x, y));
    start_ = at_ = origin + Vector2(x, y);
    started_ = true;
    is_drawing_ = false;
    command_ = is_relative ? 'l' : 'L';  // what further pairs of numbers mean
  }

  void go(const Vector2& to) {
    if (!is_drawing_) polylines_.push_back({at_});
    is_drawing_ = true;
    polylines_.back().push_back(to);
    at_ = to;
  }

  double number() {
    const auto value = scanner_.number();
    if (!value) {
      reject(placeOf(element_), " lacks a finite number for ", command_,
             scanner_.atEnd() ? std::string(" at its end") : " before '" + scanner_.rest() + "'");
    }
    return *value;
  }

  const XMLElement& element_;
  TextScanner scanner_;
  std::vector<Polyline> polylines_;
  char command_ = '\0';
  bool started_ = false;
  bool is_drawing_ = false;  ///< the last polyline goes on
  Vector2 start_ = Vector2::Zero(), at_ = Vector2::Zero();
};

/// One function of a transform. Empty where it has no such number of arguments or is unknown.
std::optional<Eigen::Affine2d> transformBy(const std::string& name, const std::vector<double>& v) {
  Eigen::Affine2d transform = Eigen::Affine2d::Identity();
  const std::size_t count = v.size();
  if (name == "matrix" && count == 6) {
    transform.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0, 0, 1;
  } else if (name == "translate" && (count == 1 || count == 2)) {
    transform.translate(Vector2(v[0], count == 2 ? v[1] : 0));
  } else if (name == "scale" && (count == 1 || count == 2)) {
    transform.scale(Vector2(v[0], v[count - 1]));
  } else if (name == "rotate" && (count == 1 || count == 3)) {
    const Vector2 center = count == 3 ? Vector2(v[1], v[2]) : Vector2(0, 0);
    transform.translate(center).rotate(v[0] / 180 * M_PI).translate(-center);
  } else {
    return std::nullopt;
  }
  return transform;
}

}  // namespace

std::vector<Polyline> polylinesOf(const XMLElement& element) {
  const std::string name = localName(element);
  if (name == "line") return lineOf(element);
  if (name == "rect") return rectOf(element);
  if (name == "polyline") return pointsOf(element, false);
  if (name == "polygon") return pointsOf(element, true);
  if (name == "path") return PathReader(element).read();
  return {};
}

Eigen::Affine2d transformOf(const XMLElement& element) {
  Eigen::Affine2d transform = Eigen::Affine2d::Identity();
  const std::string text = attribute(element, "transform");
  for (TextScanner scanner(text); !scanner.atEnd();) {
    const std::string name = scanner.word();
    std::vector<double> arguments;
    if (scanner.peek() == '(') {
      scanner.take();
      while (const auto number = scanner.number()) arguments.push_back(*number);
    }
    const auto function = transformBy(name, arguments);
    if (!function || scanner.peek() != ')') {
      reject(placeOf(element), " has the transform '", text.substr(0, 60),
             "': only matrix, translate, scale and rotate with finite numbers are read");
    }
    scanner.take();
    transform = transform * *function;
  }
  return transform;
}

}  // namespace shell_origami
