/// \file
/// A recipe: a sheet, its material, and what to do with it, step by step (YAML).
#pragma once

#include <shell_origami/origami/fold_through.h>
#include <shell_origami/origami/manoeuvre.h>
#include <shell_origami/origami/sheet_source.h>
#include <shell_origami/origami/simulation.h>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace shell_origami {

/// Makes the paper. `notes` takes a sentence for each thing in a pattern's file that was changed or
/// passed over to read it.
/// \throws std::invalid_argument with one sentence.
Simulation makeSimulation(const SheetSource& source, const SimulationConfig& config,
                          std::vector<std::string>* notes = nullptr);

struct PinStep {
  PinWhere where;
};
struct UnpinStep {
  std::optional<PinWhere> where;  ///< none: all
};
struct FoldStep {
  std::vector<FoldEdit> folds;
  /// The ends of lines that are given by landmarks, by the number of their fold.
  std::map<std::size_t, std::array<Landmark, 2>> lines = {};
  double duration = 1;  ///< [s]
};
/// Waits until the paper has settled; quasi-statically it goes to equilibrium first, at once.
struct SettleStep {
  double timeout = 5;
  bool quasi_static = false;
};  ///< [s]
/// A fold through layers, as the paper is when the step begins. What is large in a step is shared:
/// journals keep many steps.
struct FoldThroughStep {
  std::shared_ptr<const FoldThrough> fold;
  double duration = 1;  ///< [s]
};
/// Looks at the paper's other side from now on.
struct TurnOverStep {};
/// Looks at the paper from a direction from now on.
struct LookStep {
  Vector3 from;
};
/// Lets time pass.
struct WaitStep {
  double seconds = 0;
};
struct AddVertexStep {
  AddVertexEdit edit;
};
/// Stops every fold under way where it is.
struct StopStep {};
/// Changes parameters that may change while the paper moves. Those without a value stay.
struct ConfigureStep {
  std::optional<Vector3> gravity;
  std::optional<double> air_damping, fold_duration;
};
struct ManoeuvreStep {
  std::shared_ptr<const Manoeuvre> manoeuvre;
  ManoeuvreManner manner;
};
/// Takes back the last step that folded: its creases return to where they were.
struct UnfoldStep {
  double duration = 1;  ///< [s]
};
/// Gives creases another stiffness, and leaves their angles.
struct LoosenStep {
  std::vector<std::string> names;
  std::vector<std::array<Landmark, 2>> lines;  ///< the ends of each
  double stiffness = 0;                        ///< [N*m/rad per m]
};
/// Adds obstacles, all of them or none.
struct AddObstacleStep {
  std::vector<AddObstacleEdit> obstacles;
};
struct RemoveObstacleStep {
  std::vector<std::string> ids;  ///< none: all
};
/// Moves an obstacle, and lasts until it is there or the paper has stopped it.
struct MoveObstacleStep {
  std::string id;
  Pose pose;
  double duration = 1;  ///< [s]
};
struct GraspStep {
  GraspEdit edit;
};
struct ReleaseStep {
  std::vector<std::string> ids;  ///< none: all
};
using RecipeStep =
    std::variant<PinStep, UnpinStep, FoldStep, SettleStep, FoldThroughStep, TurnOverStep, LookStep,
                 WaitStep, AddVertexStep, StopStep, ConfigureStep, ManoeuvreStep, UnfoldStep,
                 LoosenStep, AddObstacleStep, RemoveObstacleStep, MoveObstacleStep, GraspStep,
                 ReleaseStep>;

/// From where the finished model looks best: rviz's orbit camera.
struct View {
  double yaw = 0.8, pitch = 0.7;  ///< [rad]
  double distance = 0.4;          ///< [m]
};

/// A recipe as people write it.
struct RecipeText {
  std::string called = "yaml";  ///< its path, or another word that complaints call it by
  std::string folder;           ///< which relative paths in it are relative to
  std::string text;
};

struct Recipe {
  RecipeText source;
  std::string name;  ///< file name without folder and extension
  SheetSource sheet;
  SimulationConfig config;
  SimulationConfig defaults;  ///< with which it was read: read so again, it is the same recipe
  View view;
  LandmarkNames names;
  bool precrease = false;  ///< whether every line is drawn on the flat sheet first
  std::vector<RecipeStep> steps;
  /// How long steps last that state it, by their index [s]. Others last until they are done.
  std::map<int, double> lasts;
  std::set<std::string> stated;  ///< words at its top, such as "sheet": all else is by default

  bool states(const std::string& word) const { return stated.count(word) > 0; }
};

/// `key=value` pairs with the key's parts joined by '/', such as material/thickness=2e-4.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Whether a file is a recipe by its extension, .yaml or .yml. Others are crease patterns.
bool isRecipe(const std::string& path);

/// Reads a recipe. Unknown words are refused. Values the recipe does not state are those of
/// `defaults`. The recipe of a crease pattern, `sheet.width` wide, folds every crease to the angle
/// that the pattern asks for and waits until the paper has settled, or folds the steps of a folding
/// sequence; without a width (0) the file states its unit.
/// \throws std::invalid_argument with one sentence naming file, line and offending value.
Recipe loadRecipe(const std::string& path, const SimulationConfig& defaults = {},
                  const SheetSource& sheet = {}, const Overrides& overrides = {});

/// The same of a recipe that is not in a file.
Recipe readRecipe(const RecipeText& source, const SimulationConfig& defaults = {},
                  const SheetSource& sheet = {}, const Overrides& overrides = {});

/// Of a step in phases, what is still to come.
struct StepUnderWay {
  double phase_end = 0;           ///< of the phase under way, at the latest [s]
  std::vector<FoldPhase> phases;  ///< after it
  std::vector<FoldEdit> result;   ///< the step's creases, as they are to be at its end
};

/// How far a recipe is.
struct RecipePlace {
  int step = 0;                   ///< under way, 0-based
  bool started = false;           ///< whether that step's edits are made
  double start_time = 0;          ///< of that step [s]
  std::optional<Viewpoint> view;  ///< none: that of the flat sheet's front
  int failures = 0;               ///< of that step, which was taken back each time
  StepUnderWay under_way;
  std::vector<FoldEdit> unfolding;  ///< what takes the last step that folded back
  /// Steps before it, 0-based, that ended at their timeout before the paper had settled.
  std::vector<int> timeouts;
};

/// Hears of the steps of a recipe as they are carried out.
class RecipeListener {
 public:
  virtual ~RecipeListener() = default;
  /// A step's edits were made, at a time of the simulation [s]. Where making them takes long, this
  /// is up to who makes them.
  virtual void onStepBegun(const RecipeStep& step, double time) = 0;
  virtual void onStepOver(double time) = 0;
};

/// A step has left creases otherwise than it should: on the wrong side, or far from their angles.
/// The paper is to be taken back to before the step.
class StepFailed : public std::runtime_error {
 public:
  StepFailed(const std::string& sentence, int failures)
      : std::runtime_error(sentence), failures_(failures) {}
  int failures() const { return failures_; }  ///< of the step, this one included

 private:
  int failures_;
};

/// Carries a recipe out. Call update() before each step.
class RecipeRunner {
 public:
  explicit RecipeRunner(Recipe recipe, const RecipePlace& place = {});

  /// Makes the edits of a step of the recipe, together or not at all. Returns false where that
  /// takes long, as a SettleEdit may: the edit is then made before the next step and the next
  /// update().
  using Apply = std::function<bool(const std::vector<Edit>& edits)>;

  /// Makes the edits that are due now. Returns false once every step of the recipe is done.
  /// \param listener  null: nobody hears
  /// \throws std::invalid_argument when the paper rejects edits of the recipe; StepFailed.
  bool update(const Simulation& simulation, const Apply& apply, RecipeListener* listener = nullptr);
  bool update(Simulation& simulation);

  const Recipe& recipe() const { return recipe_; }
  const RecipePlace& place() const { return place_; }
  /// Goes on from another place of the same recipe, with the paper as it was there.
  void goTo(const RecipePlace& place) { place_ = place; }
  /// Goes back to before a step that failed, as the paper has been, to carry it out looser and
  /// slower. Returns false where it has failed too often.
  bool tryAgain(const StepFailed& failed, const RecipePlace& before);
  /// Looks at the paper as somebody else does.
  void look(const Viewpoint& view) { place_.view = view; }
  bool finished() const { return place_.step >= static_cast<int>(recipe_.steps.size()); }
  double progress(const Simulation& simulation) const;  ///< 0..1
  std::string doing() const;                            ///< one word for the step under way
  /// Returns a sentence for each step that ended otherwise than it should since the last call.
  std::vector<std::string> takeWarnings() { return std::exchange(warnings_, {}); }

 private:
  bool over(const Simulation& simulation);
  double length(int step) const;
  void drawLines(const Simulation& simulation, const Apply& apply, RecipeListener* listener);
  bool begin(const RecipeStep& step, const Simulation& simulation, const Apply& apply);
  void beginPhase(const Simulation& simulation, const Apply& apply);
  void checkResult(const Simulation& simulation) const;
  void noteTimeout(const SettleStep& step);
  void noteStopped(const MoveObstacleStep& step, const Simulation& simulation);

  Recipe recipe_;
  RecipePlace place_;
  std::vector<std::string> warnings_;
};

}  // namespace shell_origami
