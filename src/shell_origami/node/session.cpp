#include <shell_origami/node/session.h>

#include <utility>

namespace shell_origami {

Session::Session(Simulation simulation)
    : simulation_(std::move(simulation)), original_(simulation_.snapshot()) {}

Session::Session(const nlohmann::json& json)
    : simulation_(snapshotFrom(json.at("now"))),
      original_(json.count("original") ? snapshotFrom(json.at("original"))
                                       : simulation_.snapshot()),
      time_before_(json.at("time_before")),
      edits_(json.at("edits")),
      counters_before_(countersFrom(json.at("counters_before"))),
      revision_before_(json.at("revision_before")) {}

nlohmann::json Session::toJson() const {
  return {{"now", shell_origami::toJson(simulation_.snapshot())},
          {"time_before", time_before_},
          {"counters_before", shell_origami::toJson(counters_before_)},
          {"edits", edits_},
          {"revision_before", revision_before_}};
}

nlohmann::json Session::checkpoint() const {
  nlohmann::json json = toJson();
  json["original"] = shell_origami::toJson(original_);
  return json;
}

void Session::replace(Simulation simulation) {
  follow(std::move(simulation));
  original_ = simulation_.snapshot();
}

void Session::reset() {
  Snapshot original = original_;
  original.config = simulation_.config();
  follow(Simulation(original));
}

Counters Session::counters() const {
  Counters sum = counters_before_;
  sum += simulation_.counters();
  return sum;
}

std::vector<EditRecord> Session::takeEdits() {
  std::vector<EditRecord> edits = simulation_.takeEdits();
  for (EditRecord& edit : edits) {
    edit.number = ++edits_;
    edit.step += counters_before_.steps;
    edit.time += time_before_;
    edit.revision += revision_before_;
  }
  return edits;
}

void Session::follow(Simulation simulation) {
  const std::uint32_t next_revision = revision() + 1;
  time_before_ += simulation_.time();
  ++edits_;
  counters_before_ += simulation_.counters();
  simulation_ = std::move(simulation);
  revision_before_ = next_revision - simulation_.sheet().revision();
}

}  // namespace shell_origami
