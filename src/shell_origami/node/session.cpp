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

EditRecord Session::apply(const Edit& edit) { return record(simulation_.apply(edit)); }

EditRecord Session::accept(Simulation edited, EditRecord made) {
  simulation_ = std::move(edited);
  return record(std::move(made));
}

EditRecord Session::record(EditRecord record) {
  record.number = ++edits_;
  record.step += counters_before_.steps;
  record.time += time_before_;
  record.revision += revision_before_;
  if (listener_) listener_->onEdit(record);
  return record;
}

void Session::replace(Simulation simulation, const std::string& path) {
  follow(std::move(simulation));
  original_ = simulation_.snapshot();
  if (listener_) listener_->onLoad(path);
}

void Session::reset() {
  Snapshot original = original_;
  original.config = simulation_.config();
  follow(Simulation(original));
  if (listener_) listener_->onReset();
}

Counters Session::counters() const {
  Counters sum = counters_before_;
  sum += simulation_.counters();
  return sum;
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
