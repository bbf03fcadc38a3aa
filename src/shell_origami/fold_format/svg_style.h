/// \file
/// How the lines of an SVG drawing look.
#pragma once

#include <tinyxml2.h>

#include <map>
#include <string>

namespace shell_origami {

/// The style sheets of a drawing, as far as they name classes and elements: rules for `.class`,
/// `element` and lists of these.
class SvgStyleSheet {
 public:
  /// Property to value.
  using Properties = std::map<std::string, std::string>;

  /// Adds the rules of a <style> element.
  void add(const std::string& css);
  /// The properties of an element. Its attributes are overridden by rules for elements of its name,
  /// these by rules for its classes, and these by its own style attribute.
  Properties propertiesOf(const tinyxml2::XMLElement& element) const;

 private:
  std::map<std::string, Properties> rules_;  ///< by selector
};

/// How the lines of an element look, including what it inherits from its groups.
struct SvgStyle {
  std::string stroke;  ///< empty: not drawn
  double opacity = 1;  ///< of the element and its groups
  double stroke_opacity = 1;
  bool is_visible = true;    ///< which an element in a hidden group may be
  bool is_displayed = true;  ///< which it may not

  /// The style of an element in a group of this style. Throws std::invalid_argument naming the
  /// element if an opacity is not a number from 0 to 1.
  SvgStyle of(const tinyxml2::XMLElement& element, const SvgStyleSheet& sheet) const;
  /// The kind of crease by the color, one of BMVCFU; nothing for other colors.
  char kind() const;
  bool isDrawn() const { return is_visible && is_displayed && !stroke.empty(); }
};

}  // namespace shell_origami
