#include <shell_origami/node/diagnostics.h>

#include <shell_origami/origami/outcome.h>

#include <algorithm>
#include <stdexcept>

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
  const bool settled = simulation.settled();
  const std::string shortfalls = settled ? shortfallText(simulation) : "";
  if (overstretched) {
    status.summaryf(DiagnosticStatus::WARN, "stretched by %.1f %%, further than paper bears",
                    100 * strain);
  } else if (const auto& blocked = simulation.blocked()) {
    status.summaryf(DiagnosticStatus::WARN,
                    "frame %s is held up: vertex %d meets the paper at vertex %d",
                    blocked->frame.c_str(), blocked->vertex, blocked->by);
  } else if (!shortfalls.empty()) {
    status.summary(DiagnosticStatus::WARN, shortfalls);
  } else {
    status.summary(DiagnosticStatus::OK, settled ? "settled" : "moving");
  }
  status.add("triangles", simulation.sheet().triangles().size());
  status.add("vertices", simulation.sheet().vertexCount());
  status.add("max_strain", strain);
  status.add("settled", settled);
  status.add("missed", missedCreases(simulation).size());
  status.add("strain_energy", energies.strain());
  status.add("kinetic_energy", energies.kinetic);
  status.add("contacts", simulation.contacts().size());
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
