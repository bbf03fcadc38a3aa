#include <shell_origami/node/checkpoint.h>

#include <shell_origami/base/bounded_json.h>
#include <shell_origami/base/error.h>
#include <shell_origami/base/files.h>

#include <ros/console.h>

#include <filesystem>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// Grows where the file's contents change.
constexpr int kVersion = 12;
/// A million triangles take some 300 MB.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{2} << 30;

Json jsonOf(const Run& run) {
  return {{"shell_origami", kVersion},
          {"paper", run.session.checkpoint()},
          {"recipe", run.recipe ? run.recipe->checkpoint() : Json()},
          {"paused", run.paused}};
}

Run runOf(const Json& json) {
  if (json.at("shell_origami") != kVersion) {
    reject("it is of version ", describeJson(json.at("shell_origami")), ", not ", kVersion);
  }
  Run run{Session(json.at("paper")), std::nullopt, json.at("paused")};
  if (!json.at("recipe").is_null()) run.recipe.emplace(json.at("recipe"));
  return run;
}

}  // namespace

Checkpoint::Checkpoint(std::string path, double period) : path_(std::move(path)), period_(period) {}

std::optional<Run> Checkpoint::read() const {
  if (path_.empty() || !fs::exists(path_)) return std::nullopt;
  try {
    const std::string bytes = readFile(path_, kMostBytes);
    return runOf(parseCbor({bytes.begin(), bytes.end()}));
  } catch (const std::exception& error) {
    reject("parameter ~checkpoint/file is \"", path_,
           "\", from which nothing goes on: ", error.what());
  }
}

void Checkpoint::keep(const Run& run) {
  if (path_.empty()) return;
  const ros::SteadyTime now = ros::SteadyTime::now();
  if ((now - last_).toSec() < period_) return;
  last_ = now;
  write(run);
}

void Checkpoint::write(const Run& run) {
  const std::array<std::uint64_t, 4> state = {run.session.steps(), run.session.edits(), run.paused,
                                              run.session.view().front};
  if (path_.empty() || kept_ == state) return;
  try {
    std::string bytes;
    Json::to_cbor(jsonOf(run), bytes);
    writeFiles({{path_, std::move(bytes)}});
    kept_ = state;
  } catch (const std::exception& error) {
    ROS_ERROR("no checkpoint: %s", error.what());
  }
}

}  // namespace shell_origami
