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
#include <vector>

namespace shell_origami {

/// Fails a request with an error message.
template <class Result>
void fail(std::promise<Result>& answer, const std::string& why) {
  answer.set_exception(std::make_exception_ptr(std::invalid_argument(why)));
}

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
  /// \param of_recipe  whether a recipe's step asks for it, and no request
  LongSettle(const Session& session, bool of_recipe);

  bool ofRecipe() const { return of_recipe_; }
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

  bool of_recipe_;
  bool outdated_ = false;
  std::shared_ptr<Settled> settled_;
  std::unique_ptr<Background> work_;
};

/// Paper that is read from a file in the background.
class LongLoad {
 public:
  /// Reads a paper, and takes notes of what was changed in its file to read it.
  using Read = std::function<Simulation(std::vector<std::string>& notes)>;

  LongLoad(std::string path, Read read);

  const std::string& path() const { return path_; }
  bool done() const { return work_->done(); }
  /// \pre done() \throws std::exception when there is no such paper
  Simulation finish();
  /// \pre done()
  const std::vector<std::string>& notes() const { return paper_->notes; }
  /// The work that is under way, to be waited for elsewhere.
  std::unique_ptr<Background> giveUp();

  std::promise<msg::Load::Response> answer;

 private:
  struct Paper {
    std::optional<Simulation> simulation;
    std::vector<std::string> notes;
  };

  std::string path_;
  std::shared_ptr<Paper> paper_;
  std::unique_ptr<Background> work_;
};

}  // namespace shell_origami
