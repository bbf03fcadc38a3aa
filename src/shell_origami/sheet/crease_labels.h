/// \file
/// The creases of a sheet that is edited.
#pragma once

#include <shell_origami/mesh/material_mesh.h>
#include <shell_origami/sheet/remap.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shell_origami {

/// The creases that the labels of an edited mesh stand for: creases of the sheet before the edit,
/// and those that a line has made. Creases have no lists of edges while the mesh changes; they are
/// gathered from the labels afterwards.
class CreaseLabels {
 public:
  /// \param old_creases  of the sheet before the edit; must outlive this
  explicit CreaseLabels(const std::vector<Crease>& old_creases) : old_creases_(old_creases) {}

  /// Labels the edges of a line, of which `parts` are the vertices of its parts inside the paper.
  /// Edges of an old crease that the line covers whole keep their label; the covered part of any
  /// other is cut off as a new crease, and edges that carried no crease form one.
  void label(const std::vector<std::vector<int>>& parts, MaterialMesh& edited);

  /// Returns the creases of the edited mesh; gaps divide them.
  /// \param name  of creases that the line has made; empty: that of the crease they were cut off,
  ///     or a name of their own
  /// \param next_id  id of the first new crease
  /// \param born  takes the creases that were cut off an older one
  std::vector<Crease> gather(const Triangulation& mesh, const std::vector<std::vector<int>>& parts,
                             const std::string& name, std::uint32_t next_id,
                             std::vector<Remap::Born>& born) const;

 private:
  struct NewCrease {
    std::optional<int> parent;  ///< index of the old crease that it was cut off
  };
  int addCrease(std::optional<int> parent);

  const std::vector<Crease>& old_creases_;
  std::vector<NewCrease> new_creases_;  ///< their labels follow those of the old ones
};

}  // namespace shell_origami
