#include <shell_origami/energy/material.h>

namespace shell_origami {

const std::map<std::string, MembraneKind>& membraneNames() {
  static const std::map<std::string, MembraneKind> names{
      {"st_venant_kirchhoff", MembraneKind::kStVenantKirchhoff},
      {"discrete_shells", MembraneKind::kDiscreteShells}};
  return names;
}

const std::map<std::string, PaperKind>& paperNames() {
  static const std::map<std::string, PaperKind> names{{"copy_paper", PaperKind::kCopyPaper}};
  return names;
}

Material materialOf(PaperKind paper) {
  Material material;
  switch (paper) {
    case PaperKind::kCopyPaper:
      material.youngs_modulus = 1.9e9;
      material.poisson_ratio = 0.3;
      material.thickness = 1e-4;
      material.density = 800;
      material.yield_curvature = 200;
      material.hardening = 0.4;
  }
  return material;
}

}  // namespace shell_origami
