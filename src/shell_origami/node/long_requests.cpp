#include <shell_origami/node/long_requests.h>

#include <utility>

namespace shell_origami {

std::string LongStep::stopped(const std::string& why) const {
  return "stopped after " + std::to_string(taken) + (taken == 1 ? " step: " : " steps: ") + why;
}

LongSettle::LongSettle(const Session& session, bool of_recipe) : of_recipe_(of_recipe) {
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
  return session.accept(std::move(*settled_->simulation), std::move(settled_->record));
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
            paper->simulation.emplace(read(paper->notes));
          })) {}

Simulation LongLoad::finish() {
  if (work_->error()) std::rethrow_exception(work_->error());
  return std::move(*paper_->simulation);
}

std::unique_ptr<Background> LongLoad::giveUp() { return std::move(work_); }

}  // namespace shell_origami
