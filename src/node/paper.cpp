#include "node/paper.h"

#include <limits>
#include <utility>

namespace shell_origami {

Paper::Original::Original(const Simulation& simulation)
    : sheet(simulation.sheet()), positions(simulation.positions()) {
  for (const CreaseStatus& crease : simulation.creases()) {
    rest_angles.push_back(crease.driven ? crease.rest_angle
                                        : std::numeric_limits<double>::quiet_NaN());
  }
}

Paper::Paper(Simulation simulation) : simulation_(std::move(simulation)), original_(simulation_) {}

void Paper::replace(Simulation simulation) {
  follow(std::move(simulation));
  original_ = Original(simulation_);
}

void Paper::reset() {
  follow(Simulation(original_.sheet, simulation_.config(), original_.positions,
                    original_.rest_angles));
}

std::vector<EditRecord> Paper::takeEdits() {
  std::vector<EditRecord> edits = simulation_.takeEdits();
  for (EditRecord& edit : edits) {
    edit.step += steps_before_;
    edit.time += time_before_;
    edit.revision += revision_before_;
  }
  return edits;
}

void Paper::follow(Simulation simulation) {
  const std::uint32_t next_revision = revision() + 1;
  time_before_ += simulation_.time();
  steps_before_ += simulation_.counters().steps;
  simulation_ = std::move(simulation);
  revision_before_ = next_revision - simulation_.sheet().revision();
}

}  // namespace shell_origami
