/// \file
/// Paper that gives way in its plane while it is folded, and keeps what it cannot lose again.
#pragma once

#include <shell_origami/energy/shell.h>
#include <shell_origami/origami/fold_ramp.h>

#include <map>
#include <string>
#include <vector>

namespace shell_origami {

/// Which triangles are softened.
enum class CompliantRegion {
  kCreases,  ///< those with a corner on a crease
  kSheet,    ///< all
};

/// The regions by the names that people write.
const std::map<std::string, CompliantRegion>& compliantRegionNames();

/// Folding every crease of a pattern at once mostly needs panels to stretch on the way, which paper
/// as stiff as it is does not allow: it crumples.
struct ComplianceConfig {
  /// The membrane's stiffness over that while creases fold; 1: it does not soften. 0: it softens by
  /// kPatternFactor where a pattern's creases fold by angles at which rigid panels do not close.
  double factor = 0;
  CompliantRegion where = CompliantRegion::kCreases;
};

/// Returns the factor that the folds which start at `time` (with one ramp for each crease of the
/// sheet) ask for; 1: none.
double complianceOf(const ComplianceConfig& config, const Sheet& sheet,
                    const std::vector<FoldRamp>& ramps, double time);

/// Elastic strain (InPlaneSet::flow) whose stress hardening paper bears, and beyond which it yields
/// in its plane where layers may touch. Below it lie the strains of patterns whose panels close.
constexpr double kInPlaneYield = 1e-4;

/// The softness of the membrane over time. It softens within kSofteningTime as folds start, and
/// hardens within kHardeningTime after the last one of them, both evenly in the logarithm of the
/// stiffness. Meanwhile creases are stiffer, so that they rather than the membrane decide.
class Compliance {
 public:
  Compliance() = default;
  Compliance(double factor, double level, bool folding)
      : factor_(factor), level_(level), folding_(folding) {}

  /// Softens by `factor`, from now until no crease folds.
  void start(double factor);
  /// Advances by `duration` [s].
  void advance(bool folding, double duration);
  /// Makes the membrane less soft from now on. Returns false where it is the paper's already.
  bool stiffen();

  double factor() const { return factor_; }
  double level() const { return level_; }
  bool folding() const { return folding_; }
  /// Whether the membrane is softer than the paper's.
  bool soft() const { return level_ > 0; }
  bool hardening() const { return soft() && !folding_; }
  /// By what creases are stiffer now.
  double creaseFactor() const;
  void apply(CompliantRegion where, const Shell& shell, RestState& rest) const;

 private:
  double factor_ = 1;
  double level_ = 0;  ///< 0: true paper; 1: softer by factor_
  bool folding_ = false;
};

}  // namespace shell_origami
