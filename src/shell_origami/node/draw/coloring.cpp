#include <shell_origami/node/draw/coloring.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace shell_origami {
namespace {

const std_msgs::ColorRGBA kFront = color(0.90, 0.32, 0.18);
const std_msgs::ColorRGBA kBack = color(0.97, 0.94, 0.86);

/// The same on both sides.
std::vector<SheetColours::Sides> painted(const std::vector<double>& values, double scale) {
  std::vector<SheetColours::Sides> colours;
  colours.reserve(values.size());
  for (const double value : values) {
    const std_msgs::ColorRGBA colour = diverging(value / scale);
    colours.push_back({colour, colour});
  }
  return colours;
}

}  // namespace

const std::map<std::string, Coloring>& coloringNames() {
  static const std::map<std::string, Coloring> names{{"paper", Coloring::kPaper},
                                                     {"strain", Coloring::kStrain},
                                                     {"curvature", Coloring::kCurvature},
                                                     {"contact", Coloring::kContact}};
  return names;
}

std_msgs::ColorRGBA color(double r, double g, double b) {
  std_msgs::ColorRGBA result;
  result.r = static_cast<float>(r);
  result.g = static_cast<float>(g);
  result.b = static_cast<float>(b);
  result.a = 1;
  return result;
}

std_msgs::ColorRGBA mixed(const std_msgs::ColorRGBA& from, const std_msgs::ColorRGBA& to,
                          double part) {
  return color(from.r + part * (to.r - from.r), from.g + part * (to.g - from.g),
               from.b + part * (to.b - from.b));
}

std_msgs::ColorRGBA diverging(double value) {
  // RdBu of colorbrewer2.org, which the colour-blind read too, with the back of paper in its
  // middle.
  static const std::array<std_msgs::ColorRGBA, 9> kColours{color(0.13, 0.40, 0.67),
                                                           color(0.26, 0.58, 0.76),
                                                           color(0.57, 0.77, 0.87),
                                                           color(0.82, 0.90, 0.94),
                                                           kBack,
                                                           color(0.99, 0.86, 0.78),
                                                           color(0.96, 0.65, 0.51),
                                                           color(0.84, 0.38, 0.30),
                                                           color(0.70, 0.09, 0.17)};
  if (std::isnan(value)) value = 0;
  const double place = (std::clamp(value, -1.0, 1.0) + 1) / 2 * (kColours.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
  return mixed(kColours[below], kColours[below + 1], place - static_cast<double>(below));
}

void SheetColours::setSheet(const msg::Sheet& sheet) {
  triangles_ = sheet.triangles.size();
  size_ = sheetSize(sheet);
  if (colouring_ != Coloring::kPaper) measures_ = SheetMeasures(sheet);
}

std::vector<SheetColours::Sides> SheetColours::draw(const Positions& x,
                                                    const std::vector<float>& pressures) const {
  switch (colouring_) {
    case Coloring::kStrain: return painted(measures_.strains(x), kFullStrain);
    // Valleys are blue, as creases are.
    case Coloring::kCurvature: return painted(measures_.curvatures(x), -kFullCurvature / size_);
    case Coloring::kContact:
      if (pressures.empty()) break;
      return painted(measures_.means(pressures), kFullPressure);
    case Coloring::kPaper: break;
  }
  return {triangles_, {kFront, kBack}};
}

}  // namespace shell_origami
