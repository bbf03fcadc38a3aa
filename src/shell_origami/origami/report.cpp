#include <shell_origami/origami/report.h>

#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/origami/mesh_file.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>
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

[[noreturn]] void failToWrite(const std::string& path, const std::string& reason) {
  throw std::runtime_error("cannot write " + path + ": " + reason);
}

/// Writes and flushes the whole text. Returns 0 or errno.
int writeWhole(const std::string& path, const std::string& text) {
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return errno;
  int error = 0;
  if (std::fwrite(text.data(), 1, text.size(), file) != text.size()) error = errno;
  if (error == 0 && std::fflush(file) != 0) error = errno;
  // On the disk before the old file goes.
  if (error == 0 && fsync(fileno(file)) != 0 && errno != EINVAL) error = errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  return error;
}

std::string lowerExtension(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

json makeReport(const Simulation& simulation, const std::string& recipe, double wall_time) {
  const Counters& counters = simulation.counters();
  const Energies energies = simulation.energies();
  json creases = json::array();
  for (const CreaseStatus& crease : simulation.creases()) creases.push_back(reportCrease(crease));
  return {{"recipe", recipe},
          {"triangles", simulation.sheet().triangles().size()},
          {"vertices", simulation.sheet().vertexCount()},
          {"sim_time", orNull(simulation.time())},
          {"wall_time", orNull(wall_time)},
          {"solver_time", counters.times.total()},
          {"steps", counters.steps},
          {"newton_iterations", counters.newton_iterations},
          {"factorizations", counters.factorizations},
          {"max_strain", orNull(simulation.maxStrain())},
          {"kinetic_energy", orNull(energies.kinetic)},
          // What targets that are not compatible cost: rigid panels with creases at rest have none.
          {"strain_energy", orNull(energies.strain())},
          {"settled", simulation.settled()},
          {"min_gap", -1},  // contact is not computed
          {"intersections", -1},
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
  reject("cannot save ", path, ": its extension must be .fold, .obj, .stl or .ply");
}

/// A file that is written beside the one whose place it takes, and gone unless it has.
class PartFile {
 public:
  explicit PartFile(const TextFile& file) : path_(file.path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path_, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      failToWrite(path_, "it is no plain file");
    }
    // Through a link, its target is replaced and the link stays.
    const bool link = fs::is_symlink(fs::symlink_status(path_, ignored)) && fs::exists(status);
    target_ = link ? fs::canonical(path_, ignored).string() : path_;
    part_ = target_ + "." + std::to_string(getpid()) + ".part";
    const int error = writeWhole(part_, file.text);
    if (error == 0) return;
    std::remove(part_.c_str());
    failToWrite(path_, std::strerror(error));
  }
  PartFile(const PartFile&) = delete;
  ~PartFile() {
    if (!part_.empty()) std::remove(part_.c_str());
  }

  void takePlace() {
    if (std::rename(part_.c_str(), target_.c_str()) != 0) failToWrite(path_, std::strerror(errno));
    part_.clear();
  }

 private:
  std::string path_, target_, part_;
};

}  // namespace

void savePaper(const Simulation& simulation, const std::string& path) {
  writeFiles({{path, paperText(simulation, path)}});
}

void writeFiles(const std::vector<TextFile>& files) {
  std::deque<PartFile> parts;
  for (const TextFile& file : files) parts.emplace_back(file);
  for (PartFile& part : parts) part.takePlace();
}

void writeResults(const Simulation& simulation, const std::string& recipe, double wall_time,
                  const std::string& folder, std::vector<TextFile> files) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) failToWrite(folder, error.message());
  for (const char* name : {"final.fold", "final.obj"}) {
    files.push_back({name, paperText(simulation, name)});
  }
  // The report last: where it stands, everything else does.
  const json report = makeReport(simulation, recipe, wall_time);
  files.push_back(
      {"report.json", report.dump(2, ' ', false, json::error_handler_t::replace) + "\n"});
  for (TextFile& file : files) file.path = (fs::path(folder) / file.path).string();
  writeFiles(files);
}

}  // namespace shell_origami
