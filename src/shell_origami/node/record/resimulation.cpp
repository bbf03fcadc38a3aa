#include <shell_origami/node/record/resimulation.h>

#include <shell_origami/base/error.h>
#include <shell_origami/node/conversions.h>
#include <shell_origami/node/record/edit_messages.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// So many states wait for an edit at most, before it counts as missing: the two topics reach the
/// recorder by ways of their own.
constexpr std::size_t kMostWaiting = 1000;

/// Largest difference of a coordinate [m]; infinite where they are not of one sheet, or one is NaN.
double difference(const msg::SheetState& a, const msg::SheetState& b) {
  if (a.positions.size() != b.positions.size() || a.revision != b.revision) return HUGE_VAL;
  double largest = 0;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    const auto &p = a.positions[i], &q = b.positions[i];
    for (const float d : {p.x - q.x, p.y - q.y, p.z - q.z}) {
      if (std::isnan(d)) return HUGE_VAL;
      largest = std::max(largest, std::abs(static_cast<double>(d)));
    }
  }
  return largest;
}

bool sameAngles(const msg::SheetState& a, const msg::SheetState& b) {
  return std::equal(a.creases.begin(), a.creases.end(), b.creases.begin(), b.creases.end(),
                    [](const msg::CreaseState& c, const msg::CreaseState& d) {
                      return c.id == d.id && c.angle == d.angle && c.rest_angle == d.rest_angle;
                    });
}

}  // namespace

void Resimulation::add(msg::SheetState::ConstPtr state) {
  if (!session_) {
    ++result_.skipped;
    return;
  }
  states_.push_back(std::move(state));
  advance();
}

void Resimulation::add(msg::Edit::ConstPtr edit) {
  if (!session_) {
    if (!carriesPaper(*edit)) return;
    session_ = paperFrom(*edit);
    start_time_ = session_->time();
    return;
  }
  const std::uint64_t last = edits_.empty() ? session_->edits() : edits_.back()->number;
  if (edit->number <= last) return;  // the whole paper, sent to another listener
  edits_.push_back(std::move(edit));
  advance();
}

Resimulation::Result Resimulation::finish() {
  if (!session_) reject("it holds no whole paper to begin with, which ~edits is sent first");
  for (; !edits_.empty(); edits_.pop_front()) make(*edits_.front());
  advance();
  if (!states_.empty()) {
    reject("edits ", session_->edits() + 1, " to ", states_.back()->edits, " are missing");
  }
  result_.duration = session_->time() - start_time_;
  return result_;
}

/// An edit waits for a state after it, so that every state before it has come.
void Resimulation::advance() {
  while (!states_.empty()) {
    const msg::SheetState& state = *states_.front();
    if (state.edits > session_->edits()) {
      if (edits_.empty() && states_.size() > kMostWaiting) {
        reject("edits ", session_->edits() + 1, " to ", state.edits, " are missing");
      }
      if (edits_.empty()) return;
      make(*edits_.front());
      edits_.pop_front();
      continue;
    }
    if (state.edits < session_->edits() || state.step < session_->steps()) {
      ++result_.skipped;
    } else {
      advanceTo(state.step);
      compare(state);
    }
    states_.pop_front();
  }
}

void Resimulation::make(const msg::Edit& edit) {
  if (edit.number != session_->edits() + 1) {
    reject("edits ", session_->edits() + 1, " to ", edit.number - 1, " are missing");
  }
  advanceTo(edit.step);
  if (carriesPaper(edit)) {
    session_ = paperFrom(edit);
  } else {
    try {
      session_->apply(editFrom(edit));
    } catch (const std::invalid_argument& error) {
      reject("edit ", edit.number, " (", edit.kind, ") cannot be made again: ", error.what());
    }
  }
  if (session_->edits() != edit.number || session_->revision() != edit.revision) {
    reject("edit ", edit.number, " (", edit.kind, ") made another sheet than it once did");
  }
  ++result_.edits;
}

void Resimulation::advanceTo(std::uint64_t step) {
  while (session_->steps() < step) {
    const StepReport report = session_->step();
    if (!report.converged) reject("step ", session_->steps() + 1, " fails: ", report.failure);
  }
}

void Resimulation::compare(const msg::SheetState& then) {
  const msg::SheetState now = stateMessage(*session_, then.paused, {});
  const double distance = difference(now, then);
  ++result_.states;
  if (distance == 0 && sameAngles(now, then)) return;
  if (result_.different++ == 0) result_.first = session_->time();
  result_.largest = std::max(result_.largest, distance);
}

}  // namespace shell_origami
