#include <shell_origami/origami/simulation.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace shell_origami {
namespace {

/// After so many steps what contact leaves out is looked at again.
constexpr std::uint64_t kPartingSteps = 10;

// Of ascending lists.

std::vector<TrianglePair> united(const std::vector<TrianglePair>& a,
                                 const std::vector<TrianglePair>& b) {
  std::vector<TrianglePair> pairs;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(pairs));
  return pairs;
}

std::vector<TrianglePair> common(const std::vector<TrianglePair>& a,
                                 const std::vector<TrianglePair>& b) {
  std::vector<TrianglePair> pairs;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(pairs));
  return pairs;
}

}  // namespace

/// Whether paper cannot pass through itself now. A pattern folded all at once, for which paper
/// softens by itself, passes through itself: its layers come to lie in their order on no path that
/// is known.
bool Simulation::contactOn() const {
  const bool by_itself = config_.compliance.factor == 0;
  return contact_ && !(by_itself && (compliance_.folding() || compliance_.soft()));
}

/// The pairs of triangles within reach of each other, ascending, whatever contact leaves out.
std::vector<TrianglePair> Simulation::touching() const {
  const ContactPotential whole(sheet_, contactParameters(config_));
  std::set<TrianglePair> pairs;
  for (const Contact& contact : whole.contacts(motion_.positions)) pairs.insert(contact.pair.faces);
  return {pairs.begin(), pairs.end()};
}

/// Makes contact of paper that may cross or touch itself already: such parts are left out.
void Simulation::startContact() {
  left_out_ = united(crossings(), touching());
  remakeContact();
}

void Simulation::remakeContact() {
  if (!config_.contact.enabled) return;
  contact_.emplace(sheet_, contactParameters(config_), left_out_);
}

/// Takes what has parted into contact again.
void Simulation::takeInWhatParted() {
  if (left_out_.empty() || counters_.steps % kPartingSteps != 0 || !contactOn()) return;
  std::vector<TrianglePair> still = united(crossings(), common(touching(), left_out_));
  if (still == left_out_) return;
  left_out_ = std::move(still);
  remakeContact();
  pinsChanged();
}

/// Looks for held vertices that the last step left behind what holds them.
void Simulation::findBlocked() {
  blocked_.reset();
  if (!contactOn() || !held_.moving()) return;
  Positions wanted = motion_.positions;
  held_.place(1, wanted);
  for (const auto& [frame, grip] : held_.grips()) {
    for (const auto& [v, place] : grip.places) {
      if (wanted.col(v) == motion_.positions.col(v)) continue;
      blocked_ = Blocked{v, frame, inTheWayOf(v)};
      return;
    }
  }
}

/// Returns a vertex of what is closest to v and no part of its surroundings.
int Simulation::inTheWayOf(int v) const {
  int by = v;
  double closest = std::numeric_limits<double>::infinity();
  for (const Contact& contact : contacts()) {
    const auto& vertices = contact.pair.vertices;
    const auto own = std::find(vertices.begin(), vertices.end(), v);
    if (own == vertices.end() || contact.closest.distance >= closest) continue;
    closest = contact.closest.distance;
    const bool first = own - vertices.begin() < firstSize(contact.pair.kind);
    by = first ? vertices[firstSize(contact.pair.kind)] : vertices[0];
  }
  return by;
}

std::vector<TrianglePair> Simulation::crossings() const {
  return shell_origami::crossings(sheet_, motion_.positions);
}

std::vector<Contact> Simulation::contacts() const {
  std::vector<Contact> all;
  if (contactOn()) all = contact_->contacts(motion_.positions);
  if (!obstacle_contact_) return all;
  const std::vector<Contact> more = obstacle_contact_->contacts(positionsWithObstacles());
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<ContactForce> Simulation::contactForces() const {
  std::vector<ContactForce> all;
  if (contactOn()) all = shell_origami::contactForces(*contact_, motion_.positions);
  if (!obstacle_contact_) return all;
  const auto more = shell_origami::contactForces(*obstacle_contact_, positionsWithObstacles());
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Adds dW/dx of contact [N] at the vertices of the paper.
void Simulation::addContactForces(Positions& forces) const {
  if (contactOn()) contact_->addGradient(motion_.positions, forces);
  if (!obstacle_contact_) return;
  const Positions all = positionsWithObstacles();
  Positions on_all = Positions::Zero(3, all.cols());
  obstacle_contact_->addGradient(all, on_all);
  forces += on_all.leftCols(forces.cols());
}

}  // namespace shell_origami
