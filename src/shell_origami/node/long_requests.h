/// \file
/// Requests that take longer than a time step. The node answers others meanwhile.
#pragma once

#include <shell_origami/node/background.h>
#include <shell_origami/node/messages.h>
#include <shell_origami/node/session.h>

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {

/// So many time steps, of which the node takes one after the other.
struct LongStep {
  std::uint32_t count = 0;
  std::uint32_t taken = 0;
  std::promise<double> answer;  ///< simulation time after the steps [s]

  std::string stopped(const std::string& why) const;
};

/// A copy of the paper that moves to equilibrium in the background.
class LongSettle {
 public:
  /// \param of_recipe  the step of a recipe that asks for it; none: a request does
  LongSettle(const Session& session, const std::optional<SettleStep>& of_recipe);

  bool ofRecipe() const { return of_recipe_.has_value(); }
  /// The paper has changed: the copy is of no use any more.
  void outdate();
  bool outdated() const { return outdated_; }
  /// Starts over from the paper as it is. \pre done()
  void startAgain(const Session& session);
  bool done() const { return work_->done(); }
  /// Puts the copy in the place of the paper. \pre done(), and not outdated
  /// \throws std::exception when it found no equilibrium
  EditRecord finish(Session& session);
  /// The work that is under way, to be waited for elsewhere.
  std::unique_ptr<Background> giveUp();

  std::promise<EditRecord> answer;

 private:
  struct Settled {
    std::optional<Simulation> simulation;
    EditRecord record;
  };

  std::optional<SettleStep> of_recipe_;
  bool outdated_ = false;
  std::shared_ptr<Settled> settled_;
  std::unique_ptr<Background> work_;
};

/// Paper that is read from a file in the background.
class LongLoad {
 public:
  /// Reads a paper, and takes notes of what was changed in its file to read it.
  using Read = std::function<NewPaper(std::vector<std::string>& notes)>;

  LongLoad(std::string path, Read read);

  const std::string& path() const { return path_; }
  bool done() const { return work_->done(); }
  /// \pre done() \throws std::exception when there is no such paper
  NewPaper finish();
  /// \pre done()
  const std::vector<std::string>& notes() const { return paper_->notes; }
  /// The work that is under way, to be waited for elsewhere.
  std::unique_ptr<Background> giveUp();

  std::promise<msg::Load::Response> answer;

 private:
  struct Paper {
    std::optional<NewPaper> read;
    std::vector<std::string> notes;
  };

  std::string path_;
  std::shared_ptr<Paper> paper_;
  std::unique_ptr<Background> work_;
};

/// The long requests under way: at most one to step or settle, and one to load.
class LongRequests {
 public:
  // Each begins one. \throws std::invalid_argument when another is in its way
  std::future<double> step(std::uint32_t count);
  std::future<EditRecord> settle(const Session& session);
  std::future<msg::Load::Response> load(const std::string& path, LongLoad::Read read);
  /// Begins to settle for a recipe's step, which ends a request to settle.
  void settleForRecipe(const Session& session, const SettleStep& step);

  bool stepping() const { return stepping_.has_value(); }
  LongSettle* settling() const { return settling_.get(); }  ///< null: none is under way
  bool settlesForRecipe() const { return settling_ && settling_->ofRecipe(); }
  /// Whether a request to load is ready to be finished.
  bool loaded() const { return loading_ && loading_->done(); }

  /// Counts a step that was taken; the paper's time is `time` [s] now. Returns whether it was the
  /// last one, and then has answered the request. \pre stepping()
  bool stepTaken(double time);
  // Each hands a request over to whoever finishes it. \pre it is done
  std::unique_ptr<LongSettle> takeSettle() { return std::move(settling_); }
  std::unique_ptr<LongLoad> takeLoad() { return std::move(loading_); }

  /// Ends them all early. What a recipe has begun it finishes, paused or not: it takes no time of
  /// the paper's.
  void end(const std::string& why);
  /// Returns whether there was a request to step.
  bool endStep(const std::string& why);
  /// Ends what settleForRecipe() began.
  void endRecipeSettle();
  /// Lets go of work that was ended early and has stopped since.
  void forgetEnded();

 private:
  void requireNone() const;
  void requireFewEnding() const;
  void endSettle(const std::string& why);
  void endLoad(const std::string& why);

  std::optional<LongStep> stepping_;
  std::unique_ptr<LongSettle> settling_;
  std::unique_ptr<LongLoad> loading_;
  std::vector<std::unique_ptr<Background>> ending_;  ///< given up, but still at work
};

}  // namespace shell_origami
