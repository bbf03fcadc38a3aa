#include <shell_origami/sheet/crease_labels.h>

#include <algorithm>
#include <array>
#include <map>

namespace shell_origami {
namespace {

/// Splits a crease's edges, ordered along its line, into runs without gaps.
std::vector<std::vector<int>> runsAlong(std::vector<std::array<int, 2>> edges,
                                        const std::vector<Vector2>& points,
                                        const Vector2& direction) {
  for (auto& [a, b] : edges) {
    if (direction.dot(points[b] - points[a]) < 0) std::swap(a, b);
  }
  std::sort(edges.begin(), edges.end(), [&](const auto& e, const auto& f) {
    return direction.dot(points[e[0]]) < direction.dot(points[f[0]]);
  });
  std::vector<std::vector<int>> runs;
  for (const auto& [a, b] : edges) {
    if (runs.empty() || runs.back().back() != a) runs.push_back({a});
    runs.back().push_back(b);
  }
  return runs;
}

}  // namespace

int CreaseLabels::addCrease(std::optional<int> parent) {
  new_creases_.push_back({parent});
  return static_cast<int>(old_creases_.size() + new_creases_.size()) - 1;
}

void CreaseLabels::label(const std::vector<std::vector<int>>& parts, MaterialMesh& edited) {
  const Triangulation& mesh = edited.flat();
  std::map<int, std::size_t> covered;
  std::vector<Triangulation::Side> sides;
  for (const std::vector<int>& part : parts) {
    for (std::size_t i = 1; i < part.size(); ++i) {
      sides.push_back(*mesh.findSide(part[i - 1], part[i]));
      ++covered[mesh.label(sides.back())];
    }
  }
  std::map<int, std::size_t> whole;
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.neighbour({t, k}) > t) ++whole[mesh.label({t, k})];
    }
  }
  std::map<int, int> new_label;
  for (const auto& side : sides) {
    const int old = mesh.label(side);
    if (old != Triangulation::kNone && covered[old] == whole[old]) continue;
    if (!new_label.count(old)) {
      const bool fresh = old == Triangulation::kNone;
      new_label[old] = addCrease(fresh ? std::nullopt : std::optional<int>(old));
    }
  }
  for (const auto& side : sides) {
    const auto relabelled = new_label.find(mesh.label(side));
    if (relabelled != new_label.end()) edited.setLabel(side, relabelled->second);
  }
}

std::vector<Crease> CreaseLabels::gather(const Triangulation& mesh,
                                         const std::vector<std::vector<int>>& parts,
                                         const std::string& name, std::uint32_t next_id,
                                         std::vector<Remap::Born>& born) const {
  std::map<int, std::vector<std::array<int, 2>>> edges;
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int label = mesh.label({t, k});
      if (label != Triangulation::kNone && mesh.neighbour({t, k}) > t) {
        edges[label].push_back(mesh.ends({t, k}));
      }
    }
  }
  std::vector<Crease> creases;
  const int old_count = static_cast<int>(old_creases_.size());
  for (const auto& [label, own] : edges) {
    const bool is_old = label < old_count;
    const auto parent = is_old ? std::optional<int>(label) : new_creases_[label - old_count].parent;
    const auto [first, last] = parent ? std::make_pair(old_creases_[*parent].vertices.front(),
                                                       old_creases_[*parent].vertices.back())
                                      : std::make_pair(parts.front().front(), parts.back().back());
    const Vector2 direction = mesh.points()[last] - mesh.points()[first];
    const std::string own_name = "fold_" + std::to_string(next_id);
    bool keeps_id = is_old;
    for (std::vector<int>& run : runsAlong(own, mesh.points(), direction)) {
      Crease crease;
      crease.id = keeps_id ? old_creases_[label].id : next_id++;
      const bool named = !is_old && !name.empty();
      crease.name = named ? name : parent ? old_creases_[*parent].name : own_name;
      crease.vertices = std::move(run);
      if (parent) crease.pattern_angle = old_creases_[*parent].pattern_angle;
      if (parent && !keeps_id) born.push_back({crease.id, old_creases_[*parent].id});
      creases.push_back(std::move(crease));
      keeps_id = false;
    }
  }
  return creases;
}

}  // namespace shell_origami
