#include <shell_origami/origami/sequence.h>

#include <shell_origami/fold_format/fold_document.h>
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/origami/report.h>
#include <shell_origami/origami/viewed_paper.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace shell_origami {
namespace {

using nlohmann::json;

json flatCoordinates(const Sheet& sheet) {
  json coordinates = json::array();
  for (const Vector2& p : sheet.flatPositions()) coordinates.push_back({p.x(), p.y()});
  return coordinates;
}

/// Of each edge whether it belongs to one of the creases.
json edgesOf(const std::set<std::uint32_t>& crease_ids, const Sheet& sheet) {
  json folded = json::array();
  for (const Edge& edge : sheet.edges()) {
    folded.push_back(edge.crease >= 0 && crease_ids.count(sheet.creases()[edge.crease].id) > 0);
  }
  return folded;
}

/// Of each vertex how far it is to the right, up and towards the viewer, as people see the paper.
json seenCoordinates(const ViewedPaper& seen) {
  const Vector3 right = seen.viewer.unitOrthogonal(), up = seen.viewer.cross(right);
  json coordinates = json::array();
  for (Eigen::Index v = 0; v < seen.positions.cols(); ++v) {
    const Vector3 p = seen.positions.col(v);
    coordinates.push_back({right.dot(p), up.dot(p), seen.heights[v]});
  }
  return coordinates;
}

/// Adds what the viewer of the next fold sees.
void addViewer(const RecipeRunner& runner, const Simulation& simulation, json& frame) {
  const Viewpoint view = runner.place().view.value_or(frontOf(simulation.sheet()));
  frame["shell_origami:viewpoint"] = {view.point.x(), view.point.y()};
  frame["shell_origami:front"] = view.front;
  try {
    frame["vertices_shell_origami:seen_coords"] = seenCoordinates(viewedPaper(view, simulation));
  } catch (const std::invalid_argument&) {
    // The layer at the viewpoint stands on edge, where no fold can be planned.
  }
}

}  // namespace

void Sequence::Step::add(const FoldEdit& fold, const std::vector<std::uint32_t>& ids) {
  crease_ids.insert(ids.begin(), ids.end());
  part = std::max(part, fold.part);
  if (fold.part == 0) angle = std::max(angle, std::abs(fold.angle));
}

std::string Sequence::Step::title() const {
  std::ostringstream title;
  title << word;
  if (angle > 0) title << ", " << angle / M_PI * 180 << " degrees";
  if (part > 0) title << ", " << part << " of the pattern's angles";
  if (crease_ids.size() > 1) title << ", " << crease_ids.size() << " creases";
  return title.str();
}

void Sequence::close(const RecipeRunner& runner, const Simulation& simulation) {
  if (!open_) return;
  open_ = false;
  json frame = foldFrame(simulation, 0);
  frame["frame_title"] = step_.title();
  frame[kFlatCoordinates] = flatCoordinates(simulation.sheet());
  frame["edges_shell_origami:new_creases"] = edgesOf(step_.crease_ids, simulation.sheet());
  frame["shell_origami:step"] = step_.number;
  addViewer(runner, simulation, frame);
  frames_.push_back(std::move(frame));
}

void Sequence::before(const std::vector<Edit>& edits, const RecipeRunner& runner,
                      const Simulation& simulation) {
  const bool folds = std::any_of(edits.begin(), edits.end(), [](const Edit& edit) {
    return std::holds_alternative<FoldEdit>(edit);
  });
  // Folds of one step that begin one after the other are of one frame.
  if (folds && runner.place().step + 1 != step_.number) close(runner, simulation);
}

void Sequence::after(const std::vector<EditRecord>& records, const RecipeRunner& runner) {
  for (const EditRecord& record : records) {
    const auto* fold = std::get_if<FoldEdit>(&record.edit);
    if (!fold) continue;
    if (!open_) step_ = {runner.place().step + 1, runner.doing()};
    open_ = true;
    step_.add(*fold, record.crease_ids);
  }
}

TextFile Sequence::file(const RecipeRunner& runner, const Simulation& simulation) {
  close(runner, simulation);
  json document = foldDocument(simulation, runner.recipe().name);
  document["file_classes"] = {"diagrams"};
  document["file_frames"] = frames_;
  return {"diagrams.fold", foldText(document)};
}

}  // namespace shell_origami
