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

Counters Paper::counters() const {
  Counters sum = counters_before_;
  sum += simulation_.counters();
  return sum;
}

std::vector<EditRecord> Paper::takeEdits() {
  std::vector<EditRecord> edits = simulation_.takeEdits();
  for (EditRecord& edit : edits) {
    edit.step += counters_before_.steps;
    edit.time += time_before_;
    edit.revision += revision_before_;
  }
  return edits;
}

void Paper::follow(Simulation simulation) {
  const std::uint32_t next_revision = revision() + 1;
  time_before_ += simulation_.time();
  counters_before_ += simulation_.counters();
  simulation_ = std::move(simulation);
  revision_before_ = next_revision - simulation_.sheet().revision();
}

}  // namespace shell_origami
