#include <shell_origami/fold_format/svg_style.h>

#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/text_scanner.h>
#include <shell_origami/fold_format/xml.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <sstream>
#include <vector>

namespace shell_origami {
namespace {

constexpr const char* kProperties[] = {"stroke", "stroke-opacity", "opacity", "display",
                                       "visibility"};

/// Red, green and blue from 0 to 1.
using Color = std::array<double, 3>;

std::string lowered(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(trimmed(part));
  return parts;
}

/// Reads "property: value; ...".
void readDeclarations(const std::string& text, SvgStyleSheet::Properties& properties) {
  for (const std::string& declaration : split(text, ';')) {
    const std::size_t colon = declaration.find(':');
    if (colon == std::string::npos) continue;
    properties[trimmed(declaration.substr(0, colon))] = trimmed(declaration.substr(colon + 1));
  }
}

std::string withoutComments(const std::string& css) {
  std::string text;
  for (std::size_t at = 0; at < css.size();) {
    const std::size_t comment = std::min(css.find("/*", at), css.size());
    text += css.substr(at, comment - at);
    const std::size_t end = css.find("*/", comment);
    at = end == std::string::npos ? css.size() : end + 2;
  }
  return text;
}

std::optional<Color> hexColor(const std::string& digits) {
  const std::size_t width = digits.size() / 3;
  if ((digits.size() != 3 && digits.size() != 6) ||
      digits.find_first_not_of("0123456789abcdef") != std::string::npos) {
    return std::nullopt;
  }
  const auto channel = [&](std::size_t k) {
    return std::stoi(digits.substr(k * width, width), nullptr, 16) / (width == 1 ? 15.0 : 255.0);
  };
  return Color{channel(0), channel(1), channel(2)};
}

/// Reads "rgb(...)" or "rgba(...)" behind the bracket.
std::optional<Color> rgbColor(const std::string& arguments) {
  TextScanner scanner(arguments);
  Color color{};
  for (double& channel : color) {
    const std::optional<double> value = scanner.number();
    if (!value) return std::nullopt;
    channel = *value / 255;
    if (scanner.peek() == '%') {
      scanner.take();
      channel = *value / 100;
    }
  }
  return color;
}

std::optional<Color> colorOf(const std::string& text) {
  static const std::map<std::string, Color> kNames{
      {"black", {0, 0, 0}}, {"red", {1, 0, 0}},    {"blue", {0, 0, 1}},    {"green", {0, 1, 0}},
      {"lime", {0, 1, 0}},  {"yellow", {1, 1, 0}}, {"magenta", {1, 0, 1}}, {"fuchsia", {1, 0, 1}}};
  const auto name = kNames.find(text);
  if (name != kNames.end()) return name->second;
  if (text.rfind('#', 0) == 0) return hexColor(text.substr(1));
  if (text.rfind("rgb", 0) == 0 && text.find('(') != std::string::npos) {
    return rgbColor(text.substr(text.find('(') + 1));
  }
  return std::nullopt;
}

double opacityOf(const SvgStyleSheet::Properties& properties, const std::string& key,
                 const tinyxml2::XMLElement& element) {
  const auto found = properties.find(key);
  if (found == properties.end() || found->second == "inherit") return 1;
  const std::string& text = found->second;
  const bool is_percent = !text.empty() && text.back() == '%';
  const auto number = numberFrom(is_percent ? text.substr(0, text.size() - 1) : text);
  const double value = number ? *number / (is_percent ? 100 : 1) : -1;
  if (!(value >= 0 && value <= 1)) {
    reject(placeOf(element), " has ", key, " '", text.substr(0, 60), "', not a number from 0 to 1");
  }
  return value;
}

}  // namespace

void SvgStyleSheet::add(const std::string& css) {
  for (const std::string& rule : split(withoutComments(css), '}')) {
    const std::size_t brace = rule.find('{');
    if (brace == std::string::npos) continue;
    for (const std::string& selector : split(rule.substr(0, brace), ',')) {
      readDeclarations(rule.substr(brace + 1), rules_[selector]);
    }
  }
}

SvgStyleSheet::Properties SvgStyleSheet::propertiesOf(const tinyxml2::XMLElement& element) const {
  Properties properties;
  for (const char* name : kProperties) {
    if (const char* value = element.Attribute(name)) properties[name] = trimmed(value);
  }
  std::vector<std::string> selectors{localName(element)};
  if (const char* classes = element.Attribute("class")) {
    for (const std::string& name : split(classes, ' ')) selectors.push_back("." + name);
  }
  for (const std::string& selector : selectors) {
    const auto rule = rules_.find(selector);
    if (rule == rules_.end()) continue;
    for (const auto& [name, value] : rule->second) properties[name] = value;
  }
  if (const char* style = element.Attribute("style")) readDeclarations(style, properties);
  return properties;
}

SvgStyle SvgStyle::of(const tinyxml2::XMLElement& element, const SvgStyleSheet& sheet) const {
  const SvgStyleSheet::Properties properties = sheet.propertiesOf(element);
  const auto stated = [&properties](const char* name) -> std::optional<std::string> {
    const auto found = properties.find(name);
    if (found == properties.end() || found->second == "inherit") return std::nullopt;
    return lowered(found->second);
  };
  SvgStyle style = *this;
  if (const auto value = stated("stroke")) style.stroke = *value == "none" ? "" : *value;
  if (stated("stroke-opacity")) {
    style.stroke_opacity = opacityOf(properties, "stroke-opacity", element);
  }
  style.opacity *= opacityOf(properties, "opacity", element);
  if (const auto value = stated("visibility")) style.is_visible = *value == "visible";
  if (const auto value = stated("display")) style.is_displayed &= *value != "none";
  return style;
}

char SvgStyle::kind() const {
  constexpr double kDark = 0.25, kBright = 0.75;
  static const std::map<int, char> kKinds{{0, 'B'}, {1, 'M'}, {4, 'V'},
                                          {2, 'C'}, {3, 'F'}, {5, 'U'}};
  const std::optional<Color> color = colorOf(stroke);
  if (!color) return '\0';
  int bright = 0;
  for (int k = 0; k < 3; ++k) {
    const double channel = (*color)[k];
    if (channel > kDark && channel < kBright) return '\0';
    if (channel >= kBright) bright |= 1 << k;
  }
  const auto kind = kKinds.find(bright);
  return kind == kKinds.end() ? '\0' : kind->second;
}

}  // namespace shell_origami
