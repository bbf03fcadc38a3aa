/// \file
/// The simulation under way, through every paper that is loaded.
#pragma once

#include <shell_origami/node/undo_history.h>
#include <shell_origami/origami/fold_through.h>
#include <shell_origami/origami/journal.h>
#include <shell_origami/origami/simulation.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace shell_origami {

/// Whether an edit counts among those that can be undone: frames move the paper at every step, and
/// live parameters are none of its own.
bool countsForUndo(const Edit& edit);

/// Hears of every change of the paper other than time, once, in order.
class SessionListener {
 public:
  virtual ~SessionListener() = default;
  virtual void onEdit(const EditRecord& record) = 0;
  /// Another paper took the place of this one: that of a file, or the loaded one as it was.
  virtual void onLoad(const std::string& path) = 0;
  virtual void onReset() = 0;
  /// The paper is again as it was before the edit of this number.
  virtual void onUndo(std::uint64_t edit) = 0;
};

/// A paper, flat or as its file has it, and what makes it again.
struct NewPaper {
  Simulation simulation;
  PaperOrigin origin;
};

/// A fold through layers that was made.
struct FoldThroughRecord {
  FoldPlan plan;
  std::vector<EditRecord> folds;  ///< of its layers
};

/// One paper at a time, the side from which somebody looks at it, and what was done to it. Time,
/// counters, edits and revision keep growing when another takes its place, and when edits are
/// undone. Nothing else changes a node's paper.
class Session {
 public:
  explicit Session(NewPaper paper);
  /// The paper that toJson() or checkpoint() wrote. \throws std::invalid_argument,
  /// nlohmann::json::exception
  explicit Session(const nlohmann::json& json);

  /// Exact, as Snapshot is. A checkpoint knows, too, how the paper was when it was loaded.
  nlohmann::json toJson() const;
  nlohmann::json checkpoint() const;

  /// \param listener  must live as long; null: nobody hears
  void setListener(SessionListener* listener) { listener_ = listener; }

  /// Makes an edit (Simulation::apply). Its record has the number, time, steps and revision of the
  /// session.
  EditRecord apply(const Edit& edit);
  /// Makes the edits of a recipe's step in order, all of them or, where one is rejected, none. They
  /// are undone as one. The recipe notes its step in the journal itself.
  std::vector<EditRecord> applyOfRecipe(const std::vector<Edit>& edits);
  /// Folds through layers as somebody sees them, who from then on looks at what stays.
  FoldThroughRecord foldThrough(const FoldThrough& fold, const Viewpoint& view);
  /// The same as apply() of settling that was done on a copy of the simulation.
  /// \param of_recipe  the step of a recipe that it is
  /// \pre nothing has changed since the copy was made
  EditRecord accept(Simulation settled, EditRecord record,
                    const std::optional<SettleStep>& of_recipe);
  /// Simulation::step().
  StepReport step();
  /// Puts another paper in the place of this one. It is seen from its front.
  /// \param path  of the file it is from; empty: it is from none
  void replace(NewPaper paper, const std::string& path);
  /// Makes the paper again as it was when it was loaded, seen from its front.
  void reset();
  /// \param bytes  that may be kept to undo edits; at first none
  void setUndoMemory(std::size_t bytes) { history_.setMemory(bytes); }
  /// Makes the paper again as it was before the last edits, but for the live parameters. Edits of
  /// frames and of live parameters do not count, edits made together count as one. Returns the
  /// number of the first edit undone.
  /// \param count  of the edits, at least 1
  /// \throws std::invalid_argument when these are more than are kept
  std::uint64_t undo(std::uint32_t count);
  /// Returns how many edits undo() has to take back to be before the edit of a number; 0: that
  /// paper is not kept.
  std::uint32_t editsFrom(std::uint64_t edit) const { return history_.countFrom(edit); }
  /// The same before the edit of a number. Returns false, and does nothing, where that paper is not
  /// kept.
  bool undoFrom(std::uint64_t edit);

  /// Holds the steps that led from the loaded paper to this one, without those undone. Recipes
  /// note theirs there.
  Journal& journal() { return *journal_; }
  const Journal& journal() const { return *journal_; }

  const Viewpoint& view() const { return view_; }
  /// Looks at the paper as a recipe does from now on.
  void look(const Viewpoint& view) { view_ = view; }
  /// Looks at the paper's other side from now on.
  void turnOver();

  const Simulation& simulation() const { return simulation_; }
  /// The paper as it was loaded.
  const Snapshot& original() const { return *original_; }

  double time() const { return time_before_ + simulation_.time(); }  ///< [s]
  Counters counters() const;                                         ///< over every paper so far
  std::uint64_t steps() const { return counters().steps; }
  /// Number of the last edit. Papers that were replaced or reset count as one, too.
  std::uint64_t edits() const { return edits_; }
  std::uint32_t revision() const { return revision_before_ + simulation_.sheet().revision(); }

 private:
  void follow(Simulation simulation);
  EditRecord record(EditRecord record);
  std::optional<RecipeStep> turnTo(const Viewpoint& view) const;
  std::optional<BeforeEdit> beforeNext() const;
  void keep(std::optional<BeforeEdit> before);

  Simulation simulation_;
  std::shared_ptr<const Snapshot> original_;
  Viewpoint view_;
  std::shared_ptr<Journal> journal_;
  UndoHistory history_;
  double time_before_ = 0;
  std::uint64_t edits_ = 0;
  Counters counters_before_;
  std::uint32_t revision_before_ = 0;
  SessionListener* listener_ = nullptr;
};

}  // namespace shell_origami
