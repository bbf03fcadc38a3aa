#include <shell_origami/node/session.h>

#include <algorithm>
#include <stdexcept>
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

Session::Session(NewPaper paper)
    : simulation_(std::move(paper.simulation)),
      original_(std::make_shared<const Snapshot>(simulation_.snapshot())),
      view_(frontOf(simulation_.sheet())),
      journal_(std::make_shared<Journal>(std::move(paper.origin))) {}

Session::Session(const nlohmann::json& json)
    : simulation_(snapshotFrom(json.at("now"))),
      original_(std::make_shared<const Snapshot>(
          json.count("original") ? snapshotFrom(json.at("original")) : simulation_.snapshot())),
      view_(viewpointFrom(json.at("view"))),
      journal_(json.count("journal") ? std::make_shared<Journal>(json.at("journal"))
                                     : std::make_shared<Journal>()),
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
  json["journal"] = journal_->toJson();
  return json;
}

EditRecord Session::apply(const Edit& edit) {
  std::optional<BeforeEdit> before = countsForUndo(edit) ? beforeNext() : std::nullopt;
  const LiveConfig live = liveConfigOf(simulation_.config());
  EditRecord made = simulation_.apply(edit);
  keep(std::move(before));
  journal_->add(edit, made, live);
  return record(std::move(made));
}

std::vector<EditRecord> Session::applyOfRecipe(const std::vector<Edit>& edits) {
  const bool counts = std::any_of(edits.begin(), edits.end(), countsForUndo);
  std::optional<BeforeEdit> before = counts ? beforeNext() : std::nullopt;
  std::vector<EditRecord> records = simulation_.apply(edits);
  keep(std::move(before));
  for (EditRecord& made : records) made = record(std::move(made));
  return records;
}

/// It is noted as a step of a recipe.
FoldThroughRecord Session::foldThrough(const FoldThrough& fold, const Viewpoint& view) {
  FoldPlan plan = planFold(fold, view, simulation_);
  const std::optional<RecipeStep> turn = turnTo(view);
  const std::vector<FoldEdit> folds = foldEdits(plan, fold);
  std::vector<EditRecord> made = applyOfRecipe(std::vector<Edit>(folds.begin(), folds.end()));
  if (turn) journal_->add(*turn, simulation_.time());
  const double duration = fold.duration.value_or(simulation_.config().fold_duration);
  journal_->add(FoldThroughStep{std::make_shared<FoldThrough>(fold), duration}, simulation_.time());
  look(plan.after);
  return {std::move(plan), std::move(made)};
}

/// The step of a recipe that looks at the paper from the side of another view; none where that is
/// looked at already.
std::optional<RecipeStep> Session::turnTo(const Viewpoint& view) const {
  const Vector3 viewer = viewedPaper(view, simulation_).viewer;
  try {
    const bool same_side = viewer.dot(viewedPaper(view_, simulation_).viewer) > 0;
    return same_side ? std::nullopt : std::optional<RecipeStep>(TurnOverStep{});
  } catch (const std::invalid_argument&) {  // what was looked at stands on edge
    const Sheet& sheet = simulation_.sheet();
    const auto place = sheet.triangulation().locate(view.point, 1e-6 * sheet.size());
    const Vector3 normal =
        areaNormal(sheet.triangles()[place->triangle], simulation_.positions()).normalized();
    return LookStep{view.front ? normal : Vector3(-normal)};
  }
}

void Session::turnOver() {
  view_.front = !view_.front;
  journal_->add(TurnOverStep{}, simulation_.time());
}

EditRecord Session::accept(Simulation settled, EditRecord made,
                           const std::optional<SettleStep>& of_recipe) {
  keep(beforeNext());
  simulation_ = std::move(settled);
  if (of_recipe) journal_->onStepBegun(*of_recipe, simulation_.time());
  else journal_->add(SettleEdit{}, made, liveConfigOf(simulation_.config()));
  return record(std::move(made));
}

StepReport Session::step() {
  const bool moves = !simulation_.resting();
  const StepReport report = simulation_.step();
  if (moves && report.converged) journal_->moved(simulation_.time());
  return report;
}

std::optional<BeforeEdit> Session::beforeNext() const {
  if (!history_.keeps()) return std::nullopt;
  return BeforeEdit{edits_ + 1, simulation_.snapshot(), original_, view_,
                    journal_,   journal_->size()};
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

void Session::replace(NewPaper paper, const std::string& path) {
  keep(beforeNext());
  follow(std::move(paper.simulation));
  original_ = std::make_shared<const Snapshot>(simulation_.snapshot());
  journal_ = std::make_shared<Journal>(std::move(paper.origin));
  look(frontOf(simulation_.sheet()));
  if (listener_) listener_->onLoad(path);
}

void Session::reset() {
  keep(beforeNext());
  Snapshot original = *original_;
  original.config = simulation_.config();
  PaperOrigin origin = journal_->origin();
  origin.config = original.config;
  journal_ = std::make_shared<Journal>(std::move(origin));
  follow(Simulation(original));
  look(frontOf(simulation_.sheet()));
  if (listener_) listener_->onReset();
}

std::uint64_t Session::undo(std::uint32_t count) {
  BeforeEdit before = history_.goBack(count);
  journal_ = std::move(before.journal);
  journal_->keepFirst(before.steps);
  const LiveConfig live = liveConfigOf(simulation_.config());
  Simulation paper(before.paper);
  if (const LiveConfig then = liveConfigOf(paper.config()); !(then == live)) {
    journal_->add(ConfigureEdit{live}, paper.apply(ConfigureEdit{live}), then);
  }
  follow(std::move(paper));
  original_ = std::move(before.original);
  look(before.view);
  if (listener_) listener_->onUndo(before.edit);
  return before.edit;
}

bool Session::undoFrom(std::uint64_t edit) {
  const std::uint32_t count = history_.countFrom(edit);
  if (count > 0) undo(count);
  return count > 0;
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
