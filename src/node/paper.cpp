#include "node/paper.h"

#include <utility>

namespace shell_origami {

Paper::Paper(Simulation simulation)
    : simulation_(std::move(simulation)), original_(simulation_.snapshot()) {}

Paper::Paper(const nlohmann::json& json)
    : simulation_(snapshotFrom(json.at("now"))),
      original_(json.count("original") ? snapshotFrom(json.at("original"))
                                       : simulation_.snapshot()),
      time_before_(json.at("time_before")),
      steps_before_(json.at("steps_before")),
      edits_(json.at("edits")),
      revision_before_(json.at("revision_before")) {}

nlohmann::json Paper::toJson() const {
  return {{"now", shell_origami::toJson(simulation_.snapshot())},
          {"time_before", time_before_},
          {"steps_before", steps_before_},
          {"edits", edits_},
          {"revision_before", revision_before_}};
}

nlohmann::json Paper::checkpoint() const {
  nlohmann::json json = toJson();
  json["original"] = shell_origami::toJson(original_);
  return json;
}

void Paper::replace(Simulation simulation) {
  follow(std::move(simulation));
  original_ = simulation_.snapshot();
}

void Paper::reset() {
  Snapshot original = original_;
  original.config = simulation_.config();
  follow(Simulation(original));
}

std::vector<EditRecord> Paper::takeEdits() {
  std::vector<EditRecord> edits = simulation_.takeEdits();
  for (EditRecord& edit : edits) {
    edit.number = ++edits_;
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
  ++edits_;
  simulation_ = std::move(simulation);
  revision_before_ = next_revision - simulation_.sheet().revision();
}

}  // namespace shell_origami
