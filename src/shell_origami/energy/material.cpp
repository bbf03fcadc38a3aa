#include <shell_origami/energy/material.h>

namespace shell_origami {

const std::map<std::string, MembraneKind>& membraneNames() {
  static const std::map<std::string, MembraneKind> names{
      {"st_venant_kirchhoff", MembraneKind::kStVenantKirchhoff},
      {"discrete_shells", MembraneKind::kDiscreteShells}};
  return names;
}

}  // namespace shell_origami
