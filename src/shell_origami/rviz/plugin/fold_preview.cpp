#include <shell_origami/rviz/plugin/fold_preview.h>

namespace shell_origami {
namespace {

DrawnLine::Kind kindOf(double angle) {
  return angle > 0 ? DrawnLine::Kind::kValley : DrawnLine::Kind::kMountain;
}

}  // namespace

void FoldPreview::show(const LaidFold& fold, const Vector3& eye) {
  const ShownPaper& paper = *link_.paper();
  fold_ = fold;
  seen_ = seenFold(fold, paper, eye);
  front_ = showsFront(paper, fold.first.place.triangle, eye);
  if (!seen_ || fold.reach == FoldReach::kSegment) {
    asked_.reset();
    segments_.clear();
    message_.clear();
    refused_ = false;
    return;
  }
  ask();
}

void FoldPreview::clear() {
  fold_.reset();
  seen_.reset();
  asked_.reset();
  segments_.clear();
  message_.clear();
  refused_ = false;
}

/// Asks the node about the fold as it is now. One request is under way at a time: a later change
/// waits for the next call of show().
void FoldPreview::ask() {
  if (requests_.underWay()) return;
  msg::FoldThrough::Request request = foldThroughRequest(*fold_, *seen_, "");
  request.dry_run = true;
  if (asked_ == request) return;
  asked_ = request;
  requests_.ask<msg::FoldThrough>(
      link_.resolved("fold_through"), request,
      [this](const msg::FoldThrough::Response& response) { hear(response); });
}

void FoldPreview::hear(const msg::FoldThrough::Response& response) {
  if (!asked_) return;
  message_ = response.message;
  refused_ = !response.success;
  segments_ = response.segments;
}

/// The line alone, without its creases on other layers.
std::vector<DrawnLine> FoldPreview::plainLine() const {
  const ShownPaper& paper = *link_.paper();
  const Vector3 first = paper.point(fold_->first.place), second = paper.point(fold_->second.place);
  if (fold_->reach == FoldReach::kSegment) {
    return {{{first, second}, kindOf(front_ ? fold_->angle : -fold_->angle)}};
  }
  const Vector3 middle = (first + second) / 2;
  const Vector3 along = fold_->bring ? Vector3(seen_->axis * (second - first).norm() / 2)
                                     : Vector3((second - first) / 2);
  return {{{middle - along, middle + along}, DrawnLine::Kind::kUnknown}};
}

void FoldPreview::draw(FoldDrawing& drawing) const {
  if (!fold_ || !seen_) {
    drawing.showLines({});
    drawing.showGhost({});
    return;
  }
  const ShownPaper& paper = *link_.paper();
  std::vector<DrawnLine> lines;
  std::vector<std::uint32_t> panels;
  for (const msg::FlatSegment& segment : segments_) {
    const PaperPlace start = paper.place({segment.start.x, segment.start.y});
    const PaperPlace end = paper.place({segment.end.x, segment.end.y}, start.triangle);
    panels.push_back(segment.panel);
    if (start.triangle < 0 || end.triangle < 0) continue;
    lines.push_back({{paper.point(start), paper.point(end)}, kindOf(segment.angle)});
  }
  drawing.showLines(lines.empty() ? plainLine() : lines);
  drawing.showGhost(ghostOf(*seen_, paper, panels, fold_->angle));
}

}  // namespace shell_origami
