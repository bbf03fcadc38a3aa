#include <shell_origami/rviz/plugin/paper_link.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace shell_origami {
namespace {

/// A node that sends no state for so long [s] may be gone.
constexpr double kSilence = 3;

std::vector<Vector2> flatPositions(const msg::Sheet& sheet) {
  std::vector<Vector2> points;
  for (const auto& p : sheet.flat_positions) points.emplace_back(p.x, p.y);
  return points;
}

/// \throws std::invalid_argument where it is none
Sheet sheetFrom(const msg::Sheet& message) {
  std::vector<Triangle> triangles;
  for (const auto& t : message.triangles) {
    const auto& v = t.vertex_indices;
    triangles.push_back({static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<int>(v[2])});
  }
  std::vector<Crease> creases;
  for (const msg::Crease& crease : message.creases) {
    creases.push_back({crease.id, crease.name, {crease.vertices.begin(), crease.vertices.end()}});
  }
  return Sheet(Triangulation(flatPositions(message), triangles), creases);
}

bool contains(const std::vector<std::uint32_t>& vertices, int vertex) {
  return std::find(vertices.begin(), vertices.end(), vertex) != vertices.end();
}

}  // namespace

PaperLink::PaperLink() {
  handle_.setCallbackQueue(&queue_);
  choose(kDefaultNode);
}

void PaperLink::choose(const std::string& node) {
  if (node == node_) return;
  node_ = node;
  paper_.reset();
  state_ = {};
  heard_ = {};
  unreadable_.clear();
  ++sheets_;
  sheet_subscriber_ = state_subscriber_ = ros::Subscriber();
  queue_.clear();
  try {
    sheet_subscriber_ = handle_.subscribe(resolved("sheet"), 1, &PaperLink::hearSheet, this);
    state_subscriber_ = handle_.subscribe(resolved("state"), 1, &PaperLink::hearState, this);
  } catch (const ros::InvalidNameException&) {
    unreadable_ = "\"" + node + "\" is no name of a node";
  }
}

std::string PaperLink::resolved(const std::string& name) const {
  return ros::names::resolve(node_ + "/" + name);
}

void PaperLink::poll() { queue_.callAvailable(); }

std::string PaperLink::problem() const {
  if (!unreadable_.empty()) return unreadable_;
  const std::string name = ros::names::resolve(node_);
  if (state_subscriber_.getNumPublishers() == 0) {
    return "there is no node " + name + ": start it, or choose another in the panel Origami";
  }
  if (!paper_ || heard_.isZero()) return "waiting for the paper of " + name;
  const double silent = (ros::WallTime::now() - heard_).toSec();
  if (silent < kSilence) return "";
  return name + " has been silent for " + std::to_string(std::lround(silent)) + " s";
}

const RayCaster& PaperLink::caster() {
  if (!caster_follows_) caster_->follow(paper_->positions());
  caster_follows_ = true;
  return *caster_;
}

bool PaperLink::isPinned(int vertex) const { return contains(state_.pinned, vertex); }
bool PaperLink::isGrasped(int vertex) const { return contains(state_.grasped, vertex); }

void PaperLink::hearSheet(const msg::Sheet& sheet) {
  // Obstacles make a node send the same sheet again.
  if (paper_ && revision_ == sheet.revision &&
      paper_->sheet().triangles().size() == sheet.triangles.size()) {
    return;
  }
  ++sheets_;
  revision_ = sheet.revision;
  unreadable_.clear();
  paper_.reset();
  try {
    paper_ = std::make_unique<ShownPaper>(sheetFrom(sheet));
    caster_.emplace(paper_->sheet().flatPositions(), paper_->sheet().triangles());
    caster_follows_ = false;
    if (!heard_.isZero() && state_.revision == revision_) hearState(msg::SheetState(state_));
  } catch (const std::exception& error) {
    unreadable_ = "the sheet of " + ros::names::resolve(node_) + " cannot be read: " + error.what();
  }
}

void PaperLink::hearState(const msg::SheetState& state) {
  state_ = state;
  heard_ = ros::WallTime::now();
  ++states_;
  if (!paper_ || state.revision != revision_) return;
  Positions positions(3, state.positions.size());
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    const auto& p = state.positions[v];
    positions.col(static_cast<int>(v)) = Vector3(p.x, p.y, p.z);
  }
  std::vector<double> angles;
  for (const msg::CreaseState& crease : state.creases) angles.push_back(crease.angle);
  try {
    paper_->move(std::move(positions), std::move(angles));
    caster_follows_ = false;
  } catch (const std::invalid_argument& error) {
    unreadable_ = error.what();
  }
}

std::shared_ptr<PaperLink> sharedPaperLink() {
  static std::weak_ptr<PaperLink> shared;
  std::shared_ptr<PaperLink> link = shared.lock();
  if (!link) shared = link = std::make_shared<PaperLink>();
  return link;
}

}  // namespace shell_origami
