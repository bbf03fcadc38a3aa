#include <shell_origami/node/diagnostics.h>

#include <shell_origami/origami/outcome.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace shell_origami {
namespace {

constexpr double kDiagnosticsWarnPeriod = 60;  ///< [s]

using diagnostic_msgs::DiagnosticStatus;

}  // namespace

Diagnostics::Diagnostics(ros::NodeHandle& node, OrigamiNode& origami)
    : origami_(origami),
      counters_(origami.session().counters()),
      dropped_(origami.dropped()),
      updater_(ros::NodeHandle(), node) {
  updater_.setHardwareID("none");
  updater_.add("solver", [this](Status& status) { solver(status); });
  updater_.add("pace", [this](Status& status) { pace(status); });
  updater_.add("paper", [this](Status& status) { paper(status); });
  timer_ = node.createSteadyTimer(ros::WallDuration(origami.config().diagnostic_period),
                                  [this](const ros::SteadyTimerEvent&) { update(); });
}

void Diagnostics::update() {
  try {
    updater_.force_update();
  } catch (const std::runtime_error& error) {
    // The updater adds its period to the time now, which throws as ROS time comes to its end.
    ROS_WARN_THROTTLE(kDiagnosticsWarnPeriod, "no diagnostics are published: %s", error.what());
  }
  counters_ = origami_.session().counters();
  dropped_ = origami_.dropped();
}

void Diagnostics::solver(Status& status) const {
  const Counters now = origami_.session().counters();
  const std::uint64_t steps = now.steps - counters_.steps;
  const std::uint64_t retries = now.retries - counters_.retries;
  const auto per_step = [steps](std::uint64_t count) {
    return static_cast<double>(count) / static_cast<double>(std::max<std::uint64_t>(steps, 1));
  };
  if (origami_.paused() && !origami_.lastStep().converged) {
    status.summary(DiagnosticStatus::ERROR, "paused: " + origami_.lastStep().failure);
  } else if (retries > 0) {
    status.summaryf(DiagnosticStatus::WARN, "steps had to be cut in two, %lu times",
                    static_cast<unsigned long>(retries));
  } else {
    status.summary(DiagnosticStatus::OK, origami_.paused() ? "paused" : "running");
  }
  status.add("steps", steps);
  status.add("newton_iterations_per_step",
             per_step(now.newton_iterations - counters_.newton_iterations));
  status.add("factorizations_per_step", per_step(now.factorizations - counters_.factorizations));
  status.add("retries", retries);
}

void Diagnostics::pace(Status& status) const {
  const double lost = origami_.dropped() - dropped_;
  if (lost > 0) {
    status.summaryf(DiagnosticStatus::WARN, "falls behind: dropped %.2f s, %.2f s so far", lost,
                    origami_.dropped());
  } else {
    status.summary(DiagnosticStatus::OK, origami_.paused() ? "paused" : "keeps pace");
  }
  status.add("real_time_factor", origami_.realTimeFactor());
  status.add("dropped", lost);
  status.add("dropped_so_far", origami_.dropped());
}

void Diagnostics::paper(Status& status) {
  const Simulation& simulation = origami_.session().simulation();
  const Energies energies = simulation.energies();
  const double strain = simulation.maxStrain();
  const bool overstretched = strain > kBearableStrain && !simulation.soft();
  warnOfStrain(strain, overstretched);
  const Outcome& outcome = this->outcome();
  if (overstretched) {
    status.summaryf(DiagnosticStatus::WARN, "stretched by %.1f %%, further than paper bears",
                    100 * strain);
  } else if (const auto& stopped = simulation.stopped()) {
    status.summaryf(DiagnosticStatus::WARN, "obstacle %s is %s by the paper",
                    stopped->ids.front().c_str(), stopped->pace == 0 ? "stopped" : "slowed");
  } else if (const auto& blocked = simulation.blocked()) {
    status.summaryf(DiagnosticStatus::WARN,
                    "frame %s is held up: vertex %d meets the paper at vertex %d",
                    blocked->frame.c_str(), blocked->vertex, blocked->by);
  } else if (!outcome.shortfalls.empty()) {
    status.summary(DiagnosticStatus::WARN, outcome.shortfalls);
  } else {
    status.summary(DiagnosticStatus::OK, outcome.settled ? "settled" : "moving");
  }
  status.add("triangles", simulation.sheet().triangles().size());
  status.add("vertices", simulation.sheet().vertexCount());
  status.add("max_strain", strain);
  status.add("settled", outcome.settled);
  status.add("missed", outcome.missed);
  status.add("strain_energy", energies.strain());
  status.add("kinetic_energy", energies.kinetic);
  status.add("contacts", simulation.contacts().size());
}

/// Computed again only where the paper has changed: most papers lie still most of the time.
const Diagnostics::Outcome& Diagnostics::outcome() {
  const std::uint64_t edits = origami_.session().edits();
  const Simulation& simulation = origami_.session().simulation();
  const bool settled = simulation.settled();
  // Vertices become more by edits alone.
  if (!outcome_ || outcome_->edits != edits || outcome_->settled != settled ||
      outcome_->positions != simulation.positions()) {
    const std::vector<MissedCrease> missed = missedCreases(simulation);
    outcome_ = {edits, simulation.positions(), settled, missed.size(),
                settled ? shortfallText(shortfalls(simulation, missed)) : ""};
  }
  return *outcome_;
}

/// Once, and again only after the paper was relieved.
void Diagnostics::warnOfStrain(double strain, bool overstretched) {
  if (overstretched && !overstretched_) {
    ROS_WARN(
        "the paper is stretched by %.1f %%, further than paper bears (%.0f %%): look at what "
        "holds it",
        100 * strain, 100 * kBearableStrain);
    overstretched_ = true;
  } else if (strain < kBearableStrain / 2) {
    overstretched_ = false;
  }
}

}  // namespace shell_origami
