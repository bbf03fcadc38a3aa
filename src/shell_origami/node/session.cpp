#include <shell_origami/node/session.h>

#include <algorithm>
#include <utility>

namespace shell_origami {
namespace {

nlohmann::json viewJson(const Viewpoint& view) {
  return {{"x", view.point.x()}, {"y", view.point.y()}, {"front", view.front}};
}

Viewpoint viewpointFrom(const nlohmann::json& json) {
  const double x = json.at("x"), y = json.at("y");
  return {Vector2(x, y), json.at("front")};
}

}  // namespace

bool countsForUndo(const Edit& edit) {
  return !std::holds_alternative<CarryEdit>(edit) && !std::holds_alternative<ConfigureEdit>(edit);
}

Session::Session(Simulation simulation)
    : simulation_(std::move(simulation)),
      original_(std::make_shared<const Snapshot>(simulation_.snapshot())),
      view_(frontOf(simulation_.sheet())) {}

Session::Session(const nlohmann::json& json)
    : simulation_(snapshotFrom(json.at("now"))),
      original_(std::make_shared<const Snapshot>(
          json.count("original") ? snapshotFrom(json.at("original")) : simulation_.snapshot())),
      view_(viewpointFrom(json.at("view"))),
      time_before_(json.at("time_before")),
      edits_(json.at("edits")),
      counters_before_(countersFrom(json.at("counters_before"))),
      revision_before_(json.at("revision_before")) {}

nlohmann::json Session::toJson() const {
  return {{"now", shell_origami::toJson(simulation_.snapshot())},
          {"time_before", time_before_},
          {"counters_before", shell_origami::toJson(counters_before_)},
          {"edits", edits_},
          {"view", viewJson(view_)},
          {"revision_before", revision_before_}};
}

nlohmann::json Session::checkpoint() const {
  nlohmann::json json = toJson();
  json["original"] = shell_origami::toJson(*original_);
  return json;
}

EditRecord Session::apply(const Edit& edit) {
  std::optional<BeforeEdit> before = countsForUndo(edit) ? beforeNext() : std::nullopt;
  EditRecord made = simulation_.apply(edit);
  keep(std::move(before));
  return record(std::move(made));
}

std::vector<EditRecord> Session::apply(const std::vector<Edit>& edits) {
  const bool counts = std::any_of(edits.begin(), edits.end(), countsForUndo);
  std::optional<BeforeEdit> before = counts ? beforeNext() : std::nullopt;
  std::vector<EditRecord> records = simulation_.apply(edits);
  keep(std::move(before));
  for (EditRecord& made : records) made = record(std::move(made));
  return records;
}

FoldThroughRecord Session::foldThrough(const FoldThrough& fold, const Viewpoint& view) {
  FoldPlan plan = planFold(fold, view, simulation_);
  const std::vector<FoldEdit> folds = foldEdits(plan, fold);
  std::vector<EditRecord> made = apply(std::vector<Edit>(folds.begin(), folds.end()));
  look(plan.after);
  return {std::move(plan), std::move(made)};
}

EditRecord Session::accept(Simulation edited, EditRecord made) {
  keep(beforeNext());
  simulation_ = std::move(edited);
  return record(std::move(made));
}

std::optional<BeforeEdit> Session::beforeNext() const {
  if (!history_.keeps()) return std::nullopt;
  return BeforeEdit{edits_ + 1, simulation_.snapshot(), original_, view_};
}

void Session::keep(std::optional<BeforeEdit> before) {
  if (before) history_.add(std::move(*before));
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
  keep(beforeNext());
  follow(std::move(simulation));
  original_ = std::make_shared<const Snapshot>(simulation_.snapshot());
  names_.clear();
  look(frontOf(simulation_.sheet()));
  if (listener_) listener_->onLoad(path);
}

void Session::reset() {
  keep(beforeNext());
  Snapshot original = *original_;
  original.config = simulation_.config();
  follow(Simulation(original));
  look(frontOf(simulation_.sheet()));
  if (listener_) listener_->onReset();
}

std::uint64_t Session::undo(std::uint32_t count) {
  BeforeEdit before = history_.goBack(count);
  const LiveConfig live = liveConfigOf(simulation_.config());
  Simulation paper(before.paper);
  if (!(liveConfigOf(paper.config()) == live)) paper.configure(live);
  follow(std::move(paper));
  original_ = std::move(before.original);
  look(before.view);
  if (listener_) listener_->onUndo(before.edit);
  return before.edit;
}

Counters Session::counters() const {
  Counters sum = counters_before_;
  sum += simulation_.counters();
  return sum;
}

void Session::follow(Simulation simulation) {
  const std::uint32_t next_revision = revision() + 1;
  time_before_ = time() - simulation.time();
  ++edits_;
  counters_before_ = counters();
  counters_before_ -= simulation.counters();
  simulation_ = std::move(simulation);
  revision_before_ = next_revision - simulation_.sheet().revision();
}

}  // namespace shell_origami
