#include <shell_origami/node/long_requests.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

namespace shell_origami {
namespace {

/// How many requests may be at work in the background after they were ended.
constexpr std::size_t kMostEnding = 4;

/// Fails a request with an error message.
template <class Result>
void fail(std::promise<Result>& answer, const std::string& why) {
  answer.set_exception(std::make_exception_ptr(std::invalid_argument(why)));
}

}  // namespace

std::string LongStep::stopped(const std::string& why) const {
  return "stopped after " + std::to_string(taken) + (taken == 1 ? " step: " : " steps: ") + why;
}

LongSettle::LongSettle(const Session& session, const std::optional<SettleStep>& of_recipe)
    : of_recipe_(of_recipe) {
  startAgain(session);
}

void LongSettle::outdate() {
  outdated_ = true;
  work_->cancel();
}

void LongSettle::startAgain(const Session& session) {
  outdated_ = false;
  settled_ = std::make_shared<Settled>();
  work_ =
      std::make_unique<Background>([settled = settled_, start = session.simulation().snapshot()](
                                       const Background::Cancelled& cancelled) {
        Simulation copy(start);
        copy.setInterrupt([&cancelled] { return cancelled.load(); });
        settled->record = copy.apply(SettleEdit{});
        copy.setInterrupt(nullptr);
        settled->simulation = std::move(copy);
      });
}

EditRecord LongSettle::finish(Session& session) {
  if (work_->error()) std::rethrow_exception(work_->error());
  return session.accept(std::move(*settled_->simulation), std::move(settled_->record), of_recipe_);
}

std::unique_ptr<Background> LongSettle::giveUp() {
  work_->cancel();
  return std::move(work_);
}

LongLoad::LongLoad(std::string path, Read read)
    : path_(std::move(path)),
      paper_(std::make_shared<Paper>()),
      work_(std::make_unique<Background>(
          [paper = paper_, read = std::move(read)](const Background::Cancelled&) {
            paper->read.emplace(read(paper->notes));
          })) {}

NewPaper LongLoad::finish() {
  if (work_->error()) std::rethrow_exception(work_->error());
  return std::move(*paper_->read);
}

std::unique_ptr<Background> LongLoad::giveUp() { return std::move(work_); }

std::future<double> LongRequests::step(std::uint32_t count) {
  requireNone();
  stepping_.emplace();
  stepping_->count = count;
  return stepping_->answer.get_future();
}

std::future<EditRecord> LongRequests::settle(const Session& session) {
  requireNone();
  settling_ = std::make_unique<LongSettle>(session, std::nullopt);
  return settling_->answer.get_future();
}

std::future<msg::Load::Response> LongRequests::load(const std::string& path, LongLoad::Read read) {
  requireFewEnding();
  if (loading_) {
    reject(loading_->path(), " is being read: wait until it is loaded, or end that with ~pause");
  }
  loading_ = std::make_unique<LongLoad>(path, std::move(read));
  return loading_->answer.get_future();
}

void LongRequests::settleForRecipe(const Session& session, const SettleStep& step) {
  endSettle("a recipe settles the paper");
  settling_ = std::make_unique<LongSettle>(session, step);
}

void LongRequests::requireNone() const {
  requireFewEnding();
  if (stepping_) {
    reject("the node takes ", stepping_->count,
           " steps: wait until they are taken, or end that with ", "~pause");
  }
  if (settling_) reject("the paper settles: wait until it has settled, or end that with ~pause");
}

/// Each has a thread of its own.
void LongRequests::requireFewEnding() const {
  if (ending_.size() < kMostEnding) return;
  reject(ending_.size(), " requests that were ended are still at work: wait a little");
}

bool LongRequests::stepTaken(double time) {
  if (++stepping_->taken < stepping_->count) return false;
  stepping_->answer.set_value(time);
  stepping_.reset();
  return true;
}

void LongRequests::end(const std::string& why) {
  endStep(why);
  endSettle(why);
  endLoad(why);
}

bool LongRequests::endStep(const std::string& why) {
  if (!stepping_) return false;
  fail(stepping_->answer, stepping_->stopped(why));
  stepping_.reset();
  return true;
}

void LongRequests::endSettle(const std::string& why) {
  if (!settling_ || settling_->ofRecipe()) return;
  fail(settling_->answer, why);
  ending_.push_back(settling_->giveUp());
  settling_.reset();
}

void LongRequests::endRecipeSettle() {
  if (!settlesForRecipe()) return;
  ending_.push_back(settling_->giveUp());
  settling_.reset();
}

void LongRequests::endLoad(const std::string& why) {
  if (!loading_) return;
  fail(loading_->answer, why);
  ending_.push_back(loading_->giveUp());
  loading_.reset();
}

void LongRequests::forgetEnded() {
  ending_.erase(
      std::remove_if(ending_.begin(), ending_.end(), [](const auto& work) { return work->done(); }),
      ending_.end());
}

}  // namespace shell_origami
