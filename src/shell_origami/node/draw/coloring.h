/// \file
/// Colors of the drawn paper by a measured quantity.
#pragma once

#include <shell_origami/node/draw/sheet_measures.h>
#include <shell_origami/node/messages.h>

#include <std_msgs/ColorRGBA.h>

#include <map>
#include <string>
#include <vector>

namespace shell_origami {

enum class Coloring {
  kPaper,      ///< the front orange, the back cream
  kStrain,     ///< squeezed blue, stretched red
  kCurvature,  ///< bent as a valley blue, as a mountain red
  kContact,    ///< the harder layers press on each other, the redder
};

/// The kinds by the names that people write.
const std::map<std::string, Coloring>& coloringNames();

std_msgs::ColorRGBA color(double r, double g, double b);
/// Part of the way from one colour to another.
std_msgs::ColorRGBA mixed(const std_msgs::ColorRGBA& from, const std_msgs::ColorRGBA& to,
                          double part);
/// From blue at -1 over the pale of paper at 0 to red at 1, in steps that look alike. What is
/// beyond has the colour of the end, NaN that of 0.
std_msgs::ColorRGBA diverging(double value);

/// Colours each triangle of a sheet.
class SheetColours {
 public:
  /// Strain, curvature and pressure that have the strongest colour.
  static constexpr double kFullStrain = 1e-4;
  static constexpr double kFullCurvature = 5;   ///< over the size of the sheet: [1/sheetSize]
  static constexpr double kFullPressure = 500;  ///< [Pa]

  struct Sides {
    std_msgs::ColorRGBA front, back;
  };

  explicit SheetColours(Coloring colouring) : colouring_(colouring) {}

  /// \pre every vertex that the sheet names exists
  void setSheet(const msg::Sheet& sheet);
  /// The sheet has to be set again.
  void choose(Coloring colouring) { colouring_ = colouring; }
  Coloring coloring() const { return colouring_; }
  /// One entry a triangle. Where pressures are wanted and there are none, the paper's own colours.
  /// \pre x has a column for each vertex of the sheet, and pressures [Pa], unless empty, an entry
  std::vector<Sides> draw(const Positions& x, const std::vector<float>& pressures) const;

 private:
  Coloring colouring_;
  std::size_t triangles_ = 0;
  double size_ = 0;  ///< of the flat sheet [m]
  SheetMeasures measures_;
};

}  // namespace shell_origami
