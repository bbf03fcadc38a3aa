#include <shell_origami/origami/report.h>

#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/origami/mesh_file.h>
#include <shell_origami/origami/outcome.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace shell_origami {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// JSON has no NaN and no infinity.
json orNull(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json degrees(double radians) { return orNull(radians / M_PI * 180); }

json reportCrease(const CreaseStatus& crease) {
  return {{"name", crease.name},
          {"id", crease.id},
          // A crease that no fold has named has no target.
          {"target_deg", crease.driven ? degrees(crease.target_angle) : json(nullptr)},
          {"angle_deg_mean", degrees(crease.angle)},
          {"angle_deg_min", degrees(crease.angle_min)},
          {"angle_deg_max", degrees(crease.angle_max)}};
}

json reportMissed(const Simulation& simulation) {
  json missed = json::array();
  for (const MissedCrease& crease : missedCreases(simulation)) {
    missed.push_back({{"name", crease.name},
                      {"id", crease.id},
                      {"target_deg", degrees(crease.target)},
                      {"angle_deg", degrees(crease.angle)},
                      {"why", crease.why}});
  }
  return missed;
}

std::string lowerExtension(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

json makeReport(const Simulation& simulation, const RunRecord& run) {
  const Counters& counters = simulation.counters();
  const Energies energies = simulation.energies();
  const InPlaneSet::Size set = simulation.inPlaneSet();
  const std::vector<Contact> contacts = simulation.contacts();
  json creases = json::array();
  for (const CreaseStatus& crease : simulation.creases()) creases.push_back(reportCrease(crease));
  json timeouts = json::array();
  for (int step : run.timeouts) timeouts.push_back(step + 1);  // people count from 1
  return {{"recipe", run.recipe},
          {"triangles", simulation.sheet().triangles().size()},
          {"vertices", simulation.sheet().vertexCount()},
          {"sim_time", orNull(simulation.time())},
          {"wall_time", orNull(run.wall_time)},
          {"solver_time", counters.times.total()},
          {"steps", counters.steps},
          {"newton_iterations", counters.newton_iterations},
          {"factorizations", counters.factorizations},
          {"max_strain", orNull(simulation.maxStrain())},
          {"in_plane_set", {{"mean", orNull(set.mean)}, {"worst", orNull(set.worst)}}},
          {"kinetic_energy", orNull(energies.kinetic)},
          // The energy of incompatible targets: rigid panels with creases at rest have none.
          {"strain_energy", orNull(energies.strain())},
          {"settled", simulation.settled()},
          {"min_gap", smallestGap(contacts)},
          {"contacts", contacts.size()},
          {"intersections", simulation.crossings().size()},
          {"failure", run.failure.empty() ? json(nullptr) : json(run.failure)},
          {"timeouts", std::move(timeouts)},
          {"missed", reportMissed(simulation)},
          {"creases", std::move(creases)}};
}

namespace {

std::vector<FoldCrease> foldCreases(const Simulation& simulation) {
  std::vector<FoldCrease> creases;
  for (const CreaseStatus& crease : simulation.creases()) {
    const double free = std::numeric_limits<double>::quiet_NaN();
    creases.push_back({crease.angle, crease.driven ? crease.rest_angle : free});
  }
  return creases;
}

}  // namespace

json foldDocument(const Simulation& simulation, const std::string& title) {
  return writeFold(simulation.sheet(), foldCreases(simulation), simulation.positions(), title);
}

json foldFrame(const Simulation& simulation, int mesh_frame) {
  return foldedFrame(simulation.sheet(), foldCreases(simulation), simulation.positions(),
                     simulation.time(), mesh_frame);
}

namespace {

/// By the path's extension.
std::string paperText(const Simulation& simulation, const std::string& path) {
  const std::string extension = lowerExtension(path);
  const Positions& positions = simulation.positions();
  const std::vector<Triangle>& triangles = simulation.sheet().triangles();
  if (extension == ".fold") {
    return foldText(foldDocument(simulation, fs::path(path).stem().string()));
  }
  if (extension == ".obj") return objText(positions, triangles);
  if (extension == ".stl") return stlText(positions, triangles);
  if (extension == ".ply") return plyText(positions, triangles);
  reject("cannot save ", path,
         ": its extension must be .fold, .obj, .stl or .ply, or .yaml for a recipe");
}

}  // namespace

void savePaper(const Simulation& simulation, const std::string& path) {
  writeFiles({{path, paperText(simulation, path)}});
}

void writeResults(const Simulation& simulation, const RunRecord& run, const std::string& folder,
                  std::vector<TextFile> files) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot write " + folder + ": " + error.message());
  for (const char* name : {"final.fold", "final.obj"}) {
    files.push_back({name, paperText(simulation, name)});
  }
  // The report last: where it stands, everything else does.
  const json report = makeReport(simulation, run);
  files.push_back(
      {"report.json", report.dump(2, ' ', false, json::error_handler_t::replace) + "\n"});
  for (TextFile& file : files) file.path = (fs::path(folder) / file.path).string();
  writeFiles(files);
}

}  // namespace shell_origami
