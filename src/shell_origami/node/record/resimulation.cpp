#include <shell_origami/node/record/resimulation.h>

#include <shell_origami/base/error.h>
#include <shell_origami/node/conversions.h>
#include <shell_origami/node/record/edit_messages.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

/// Largest difference of a coordinate [m]; infinite where they are not of one sheet.
double difference(const msg::SheetState& a, const msg::SheetState& b) {
  if (a.positions.size() != b.positions.size() || a.revision != b.revision) return HUGE_VAL;
  double largest = 0;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    const auto &p = a.positions[i], &q = b.positions[i];
    for (const float d : {p.x - q.x, p.y - q.y, p.z - q.z}) {
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

void Resimulation::add(const msg::SheetState& state) {
  states_[{state.edits, state.step}].push_back(state);
}

void Resimulation::add(const msg::Edit& edit) { edits_.push_back(edit); }

Resimulation::Result Resimulation::run() {
  for (const msg::Edit& edit : edits_) {
    if (!session_) {
      start(edit);
    } else if (edit.number > session_->edits()) {
      make(edit);
    }
  }
  if (!session_) reject("it holds no whole paper to begin with, which ~edits is sent first");
  // compare() erases the states that it has seen, so none is iterated over meanwhile.
  std::uint64_t last = session_->steps();
  for (const auto& [moment, states] : states_) {
    if (moment.first == session_->edits()) last = std::max(last, moment.second);
  }
  advanceTo(last);
  result_.duration = session_->time() - start_time_;
  for (const auto& [moment, states] : states_) result_.skipped += states.size();
  return result_;
}

void Resimulation::start(const msg::Edit& edit) {
  if (!carriesPaper(edit)) return;
  session_ = paperFrom(edit);
  start_time_ = session_->time();
  compare();
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
      session_->simulation().redo(editRecord(edit));
    } catch (const std::invalid_argument& error) {
      reject("edit ", edit.number, " (", edit.kind, ") cannot be made again: ", error.what());
    }
    session_->takeEdits();  // counts it
  }
  if (session_->edits() != edit.number || session_->revision() != edit.revision) {
    reject("edit ", edit.number, " (", edit.kind, ") made another sheet than it once did");
  }
  ++result_.edits;
  compare();
}

void Resimulation::advanceTo(std::uint64_t step) {
  while (session_->steps() < step) {
    const StepReport report = session_->simulation().step();
    if (!report.converged) reject("step ", session_->steps() + 1, " fails: ", report.failure);
    compare();
  }
}

/// With what was recorded at this moment, which is then done with.
void Resimulation::compare() {
  const auto recorded = states_.find({session_->edits(), session_->steps()});
  if (recorded == states_.end()) return;
  const msg::SheetState now = stateMessage(*session_, {});
  for (const msg::SheetState& then : recorded->second) {
    const double distance = difference(now, then);
    ++result_.states;
    if (distance == 0 && sameAngles(now, then)) continue;
    if (result_.different++ == 0) result_.first = session_->time();
    result_.largest = std::max(result_.largest, distance);
  }
  states_.erase(recorded);
}

}  // namespace shell_origami
