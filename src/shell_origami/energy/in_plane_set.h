/// \file
/// How far paper stays stretched and sheared.
#pragma once

#include <shell_origami/energy/shell.h>
#include <shell_origami/sheet/remap.h>

#include <utility>
#include <vector>

namespace shell_origami {

/// Green strains in which the triangles of a sheet rest.
class InPlaneSet {
 public:
  InPlaneSet() = default;
  explicit InPlaneSet(const Sheet& sheet)
      : strains_(sheet.triangles().size(), GreenStrain::Zero()) {}
  /// \param strains one a triangle
  explicit InPlaneSet(std::vector<GreenStrain> strains) : strains_(std::move(strains)) {}

  const std::vector<GreenStrain>& strains() const { return strains_; }

  void apply(const Shell& shell, RestState& rest) const;
  /// Carries it over an edit: a part of a triangle keeps that triangle's.
  void follow(const Remap& remap);
  /// Makes set of the part of each triangle's strain that would need more stress than the paper has
  /// at the elastic strain `yield` (the Frobenius norm of the Green strain's matrix), and gives
  /// `rest` the new strains. Called step by step it makes paper that pulls back with that stress at
  /// most, however far it is stretched, so that a set which is no longer needed goes again.
  void flow(double yield, const Sheet& sheet, const Positions& positions, const Shell& shell,
            RestState& rest);

  /// Returns the rest length [m] of a vector of the flat sheet within a triangle.
  double length(int triangle, const Vector2& flat) const;

  struct Size {
    double mean = 0;  ///< weighted by flat area
    double worst = 0;
  };
  /// By how much rest lengths have changed, in the direction of each triangle in which they have
  /// most, over flat lengths.
  Size size(const Sheet& sheet) const;

 private:
  std::vector<GreenStrain> strains_;
};

}  // namespace shell_origami
