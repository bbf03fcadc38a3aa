/// \file
/// How far the paper is stretched and bent, from the messages alone.
#pragma once

#include <shell_origami/energy/curvature.h>
#include <shell_origami/energy/membrane.h>
#include <shell_origami/node/messages.h>

#include <array>
#include <cstdint>
#include <vector>

namespace shell_origami {

/// The longer side of the box around the flat sheet [m].
double sheetSize(const msg::Sheet& sheet);

/// Figures of each triangle, in the sheet's order. A triangle without area, flat or in space, has
/// figures that mean nothing and may be NaN. Positions recorded as float32 leave 5e-6 of strain.
class SheetMeasures {
 public:
  SheetMeasures() = default;
  /// \pre every vertex that the sheet names exists
  explicit SheetMeasures(const msg::Sheet& sheet);

  /// The principal Green strain of largest magnitude; stretched is positive.
  std::vector<double> strains(const Positions& x) const;

  /// The principal curvature of largest magnitude [1/m]; as of a valley, towards the front, is
  /// positive. From the bends of the triangle's edges that are no creases.
  std::vector<double> curvatures(const Positions& x) const;

  /// The means of what the corners have. \pre there is an entry for each vertex of the sheet
  std::vector<double> means(const std::vector<float>& of_vertices) const;

 private:
  void addBends(const msg::Sheet& sheet, const std::vector<Vector2>& flat);

  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<MembraneElement> membranes_;
  /// Of each edge between two triangles that is no crease, its vertices as HingePoints has them.
  std::vector<std::array<std::uint32_t, 4>> bends_;
  CurvatureFit fit_;
};

}  // namespace shell_origami
