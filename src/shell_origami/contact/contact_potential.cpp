#include <shell_origami/contact/contact_potential.h>

#include <shell_origami/base/parallel.h>
#include <shell_origami/contact/ccd.h>
#include <shell_origami/contact/contact_iterate.h>
#include <shell_origami/contact/guard.h>
#include <shell_origami/contact/start_filter.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace shell_origami {
namespace {

/// Part of the sheet's mean edge by which the room of candidates is larger than the motion that it
/// is made for.
constexpr double kMargin = 0.1;
/// A motion for which more pairs than this come into question is longer than one step may be: paper
/// that flies apart, in which everything could meet everything. A stack of 16 layers has 50 a
/// vertex.
constexpr std::size_t kMostPairs = 200000, kMostPairsPerVertex = 500;
/// Pairs that one thread looks at in one go.
constexpr std::size_t kPairsPerChunk = 512;
/// A spring at an anticipated impact: its stiffness over that of contact, and where it ends, in
/// reaches.
constexpr double kImpactStiffness = 3, kImpactGap = 0.7;

/// A number that tells lists of stencils apart (FNV-1a).
class Hash {
 public:
  void add(const ContactPair& pair) {
    for (int v : pair.vertices) value = (value ^ static_cast<std::uint64_t>(v)) * 0x100000001b3;
  }
  std::uint64_t value = 0xcbf29ce484222325;
};

/// The distance towards which the barrier grows without bound [m]: that which the guard keeps, or
/// steps would be stopped by a guard at which nothing pushes back. With obstacles it is 0: paper
/// that they press took six times as many iterations with the other.
double barrierEnd(const CollisionMesh& mesh) { return mesh.hasBodies() ? 0 : kClosestGap; }

/// How far a pair that is pushed from its reach on can still come closer [m].
double room(const CollisionMesh& mesh, const ContactPair& pair) {
  return pair.reach - barrierEnd(mesh);
}

Eigen::Matrix<double, 12, 1> distanceGradient(const ClosestPoints& closest) {
  const Vector3 direction = closest.direction();
  Eigen::Matrix<double, 12, 1> gradient;
  for (int k = 0; k < 4; ++k) gradient.segment<3>(3 * k) = closest.weights[k] * direction;
  return gradient;
}

}  // namespace

const ContactPotential::ContactIterate& ContactPotential::of(const Iterate& at) {
  return static_cast<const ContactIterate&>(at);
}
ContactPotential::ContactIterate& ContactPotential::of(Iterate& at) {
  return static_cast<ContactIterate&>(at);
}

ContactPotential::ContactPotential(const Sheet& sheet, const ContactParameters& parameters,
                                   const std::vector<TrianglePair>& crossing)
    : ContactPotential(CollisionMesh(sheet), sheet, parameters) {
  mesh_.leaveOut(crossing);
}

ContactPotential::ContactPotential(const Sheet& sheet, const std::vector<Body>& bodies,
                                   const ContactParameters& parameters)
    : ContactPotential(CollisionMesh(sheet, bodies), sheet, parameters) {
  friction_ = 0;
  for (const Body& body : bodies) friction_ = std::max(friction_, body.friction);
}

ContactPotential::ContactPotential(CollisionMesh mesh, const Sheet& sheet,
                                   const ContactParameters& parameters)
    : mesh_(std::move(mesh)),
      tree_(mesh_),
      distance_(parameters.distance),
      stiffness_(parameters.stiffness),
      friction_(parameters.friction),
      sticking_(parameters.sticking),
      margin_(kMargin * sheet.meanEdge()),
      most_(std::max<std::size_t>(kMostPairs, kMostPairsPerVertex * sheet.vertexCount())) {}

std::unique_ptr<Potential::Iterate> ContactPotential::makeIterate() const {
  return std::make_unique<ContactIterate>();
}

std::shared_ptr<const Candidates> ContactPotential::candidatesOf(const Positions& from,
                                                                 const Positions& to) const {
  return std::make_shared<Candidates>(mesh_, tree_, from, to, distance_, margin_, most_);
}

/// Makes the candidates of `at` cover `to` as well. Returns false where that would be too many.
bool ContactPotential::cover(ContactIterate& at, const Positions& to) const {
  if (at.candidates && at.candidates->cover(to)) return true;
  auto candidates = candidatesOf(at.x, to);
  if (!candidates->complete()) return false;
  at.candidates = std::move(candidates);
  measure(at);
  return true;
}

/// Computes the distances of all candidates, and the contacts.
void ContactPotential::measure(ContactIterate& at) const {
  const std::vector<ContactPair>& pairs = at.candidates->pairs();
  at.gaps.resize(pairs.size());
  at.contacts.clear();
  at.impacts.clear();
  gatherChunks(pairs.size(), kPairsPerChunk, at.contacts, [&](const Chunk& chunk, auto& contacts) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const ClosestPoints closest = closestPoints(pairs[i].kind, pointsOf(pairs[i], at.x));
      at.gaps[i] = closest.distance;
      addContact(pairs[i], closest, at.x, contacts);
    }
  });
  finish(at);
}

/// Adds the pair unless it is too far apart to be one.
void ContactPotential::addContact(const ContactPair& pair, const ClosestPoints& closest,
                                  const Positions& x, std::vector<Contact>& contacts) const {
  if (closest.distance >= kNear * pair.reach) return;
  Contact contact{
      pair, closest, logBarrier((closest.distance - barrierEnd(mesh_)) / room(mesh_, pair)), {}};
  if (pair.kind == PairKind::kEdgeEdge) {
    contact.mollifier =
        mollifier(pointsOf(pair, x), kParallel * mesh_.squaredProduct(pair.vertices));
  }
  contacts.push_back(contact);
}

void ContactPotential::finish(ContactIterate& at) const {
  Hash hash;
  for (const Contact& contact : at.contacts) hash.add(contact.pair);
  for (const Impact& impact : at.impacts) hash.add(impact.pair);
  for (const FrictionPair& pair : at.friction->pairs) hash.add(pair.pair);
  at.stencils.restart(hash.value);
  for (const Contact& contact : at.contacts) at.stencils.add(contact.pair.vertices.data(), 4);
  for (const Impact& impact : at.impacts) at.stencils.add(impact.pair.vertices.data(), 4);
  for (const FrictionPair& pair : at.friction->pairs) {
    at.stencils.add(pair.pair.vertices.data(), 4);
  }
}

void ContactPotential::start(const Positions& x, Iterate& at) const {
  ContactIterate& own = of(at);
  own.x = x;
  own.friction = std::make_shared<Friction>();
  if (!own.candidates || !own.candidates->cover(x)) {
    own.candidates = std::make_shared<Candidates>(mesh_, tree_, x, x, distance_, margin_);
  }
  measure(own);
  own.friction = frictionFrom(own);
  finish(own);
}

void ContactPotential::filterStart(const Positions& before, Iterate& at, Positions& x) const {
  ContactIterate& own = of(at);
  if (!cover(own, x)) return;
  separate(own.candidates->pairs(), own.gaps, before, x);
}

double ContactPotential::value(const Positions& x, const Iterate& from, Iterate& at) const {
  const ContactIterate& source = of(from);
  ContactIterate& own = of(at);
  const bool covered = source.candidates->cover(x);
  own.x = x;
  own.candidates = covered ? source.candidates : candidatesOf(source.x, x);
  if (!own.candidates->complete()) return std::numeric_limits<double>::infinity();
  own.contacts.clear();
  own.impacts.clear();
  const std::vector<ContactPair>& pairs = own.candidates->pairs();
  own.gaps.resize(pairs.size());
  std::atomic<bool> free{true};
  gatherChunks(pairs.size(), kPairsPerChunk, own.contacts, [&](const Chunk& chunk, auto& contacts) {
    for (std::size_t i = chunk.begin; i < chunk.end && free; ++i) {
      const ContactPair& pair = pairs[i];
      const double before =
          covered ? source.gaps[i] : closestPoints(pair.kind, pointsOf(pair, source.x)).distance;
      own.gaps[i] = before - approach(pair, source.x, x);
      if (own.gaps[i] >= kNear * pair.reach) continue;
      if (!isFree(pair, source.x, x)) {
        free = false;
        return;
      }
      const ClosestPoints closest = closestPoints(pair.kind, pointsOf(pair, x));
      own.gaps[i] = closest.distance;
      addContact(pair, closest, x, contacts);
    }
  });
  if (!free) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (const Contact& contact : own.contacts) sum += energyOf(contact);
  own.friction = source.friction;
  for (const FrictionPair& pair : own.friction->pairs) {
    sum += pair.bound * smoothSlip(slip(pair, own.friction->start, x).norm(), sticking_).value;
  }
  finish(own);
  return sum;
}

std::optional<Infeasibility> ContactPotential::findInfeasibility(const Positions& x,
                                                                 const Iterate& from) const {
  const Positions& start = of(from).x;
  const auto candidates = candidatesOf(start, x);
  if (!candidates->complete()) return Infeasibility{"paper would jump", -1};
  for (const ContactPair& pair : candidates->pairs()) {
    if (isFree(pair, start, x)) continue;
    return mesh_.hasBodies()
               ? Infeasibility{"paper would pass through an obstacle",
                               *std::min_element(pair.vertices.begin(), pair.vertices.end())}
               : Infeasibility{"paper would pass through paper", pair.vertices[0]};
  }
  return std::nullopt;
}

/// Stiffness of a pair [N/m]: the shorter its reach, the stiffer, so that all bear the same force.
double ContactPotential::stiffnessOf(const ContactPair& pair) const {
  return stiffness_ * distance_ / pair.reach;
}

/// W = k r^2 m b((d - g) / r) for the stiffness k, the distance g where the barrier ends, the reach
/// r above it, the mollifier m and the barrier b.
double ContactPotential::energyOf(const Contact& contact) const {
  const double reach = room(mesh_, contact.pair);
  return stiffnessOf(contact.pair) * reach * reach * contact.mollifier.value *
         contact.barrier.value;
}

double ContactPotential::forceOf(const Contact& contact) const {
  return stiffnessOf(contact.pair) * room(mesh_, contact.pair) * contact.mollifier.value *
         contact.barrier.first;
}

void ContactPotential::addGradient(const Positions& x, Iterate& at, Positions& gradient) const {
  if (!of(at).impacts.empty()) {
    of(at).impacts.clear();
    finish(of(at));
  }
  for (const Contact& contact : of(at).contacts) {
    if (contact.barrier.value == 0) continue;
    const double reach = room(mesh_, contact.pair);
    const double force = forceOf(contact);
    const Vector3 direction = contact.closest.direction();
    for (int k = 0; k < 4; ++k) {
      auto column = gradient.col(contact.pair.vertices[k]);
      column += force * contact.closest.weights[k] * direction;
      if (contact.mollifier.value == 1) continue;
      column += stiffnessOf(contact.pair) * reach * reach * contact.barrier.value *
                contact.mollifier.gradient[k];
    }
  }
  addFriction(x, *of(at).friction, gradient);
}

const Stencils& ContactPotential::stencils(const Iterate& at) const { return of(at).stencils; }

void ContactPotential::addHessian(const Positions& x, const Iterate& at, HessianKind kind,
                                  HessianBlocks& blocks) const {
  blocks.inParts([&](HessianBlocks& part) { addHessianPart(x, of(at), kind, part); });
}

void ContactPotential::addHessianPart(const Positions& x, const ContactIterate& at,
                                      HessianKind kind, HessianBlocks& blocks) const {
  int stencil = -1;
  for (const Contact& contact : at.contacts) {
    if (!blocks.reach(++stencil) || contact.barrier.value == 0) continue;
    const double stiffness = stiffnessOf(contact.pair) * contact.mollifier.value;
    const Eigen::Matrix<double, 12, 1> gradient = distanceGradient(contact.closest);
    if (kind == HessianKind::kConvex || contact.mollifier.value < 1) {
      blocks.addRankOne(stencil, stiffness * contact.barrier.second, gradient);
      continue;
    }
    const Eigen::Matrix<double, 12, 12> curvature =
        distanceHessian(pointsOf(contact.pair, x), contact.pair.kind, contact.closest);
    blocks.add(stencil,
               Eigen::Matrix<double, 12, 12>(
                   stiffness * (contact.barrier.second * gradient * gradient.transpose() +
                                room(mesh_, contact.pair) * contact.barrier.first * curvature)));
  }
  for (const Impact& impact : at.impacts) {
    if (!blocks.reach(++stencil)) continue;
    blocks.addRankOne(stencil, kImpactStiffness * stiffnessOf(impact.pair),
                      distanceGradient(impact.closest));
  }
  addFrictionHessian(x, *at.friction, stencil + 1, blocks);
}

bool ContactPotential::anticipate(const Positions& x, Iterate& at, const Positions& step) const {
  ContactIterate& own = of(at);
  const Positions to = x + step;
  if (!cover(own, to)) return false;
  const std::vector<ContactPair>& pairs = own.candidates->pairs();
  const std::size_t before = own.impacts.size();
  gatherChunks(pairs.size(), kPairsPerChunk, own.impacts, [&](const Chunk& chunk, auto& impacts) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const ContactPair& pair = pairs[i];
      // Within its reach a pair pushes by itself and needs no spring.
      if (own.gaps[i] < pair.reach) continue;
      if (own.gaps[i] - approach(pair, x, to) >= kNear * pair.reach) continue;
      const double part = freePart(pair, x, to);
      if (part == 1) continue;
      PairPoints there = pointsOf(pair, x);
      for (int k = 0; k < 4; ++k) there[k] += part * step.col(pair.vertices[k]);
      impacts.push_back({pair, closestPoints(pair.kind, there)});
    }
  });
  if (own.impacts.size() == before) return false;
  finish(own);
  return true;
}

void ContactPotential::addAnticipated(const Positions& x, const Iterate& at,
                                      Positions& gradient) const {
  for (const auto& [pair, closest] : of(at).impacts) {
    const Vector3 direction = closest.direction();
    double gap = 0;
    for (int k = 0; k < 4; ++k) gap += closest.weights[k] * direction.dot(x.col(pair.vertices[k]));
    const double force = kImpactStiffness * stiffnessOf(pair) * (gap - kImpactGap * pair.reach);
    for (int k = 0; k < 4; ++k) {
      gradient.col(pair.vertices[k]) += force * closest.weights[k] * direction;
    }
  }
}

double ContactPotential::maxFeasibleStep(const Positions& x, Iterate& at,
                                         const Positions& step) const {
  ContactIterate& own = of(at);
  double looked = 1;  // the part of the step whose pairs are not too many
  while (!cover(own, x + looked * step)) looked /= 4;
  return looked * smallestFreePart(own, x, x + looked * step);
}

/// Returns the part of the motion from x to `to` that the pairs permit, each looked at as far as
/// those before it do.
double ContactPotential::smallestFreePart(const ContactIterate& at, const Positions& x,
                                          const Positions& to) const {
  struct Near {
    std::size_t pair;
    double approach;
    double free;  // the part that it permits; -1: not looked at
  };
  const std::vector<ContactPair>& pairs = at.candidates->pairs();
  const auto isNear = [&](std::size_t i, double approach, double part) {
    return at.gaps[i] - part * approach < kNear * pairs[i].reach;
  };
  std::vector<Near> near;
  std::atomic<double> permitted{1};  // by the pairs looked at so far, in whatever order
  gatherChunks(pairs.size(), kPairsPerChunk, near, [&](const Chunk& chunk, auto& found) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const double closer = approach(pairs[i], x, to);
      if (!isNear(i, closer, 1)) continue;
      const bool looked_at = isNear(i, closer, permitted);
      found.push_back({i, closer, looked_at ? freePart(pairs[i], x, to) : -1});
      if (looked_at && found.back().free < permitted) permitted = found.back().free;
    }
  });
  double part = 1;
  for (const auto& [i, closer, free] : near) {
    if (!isNear(i, closer, part)) continue;
    part = std::min(part, free < 0 ? freePart(pairs[i], x, to) : free);
  }
  return part;
}

bool ContactPotential::rough(const Iterate& at) const {
  for (const Contact& contact : of(at).contacts) {
    if (contact.barrier.value > 0) return true;
  }
  return false;
}

double smallestGap(const std::vector<Contact>& contacts) {
  const auto smallest = std::min_element(
      contacts.begin(), contacts.end(),
      [](const Contact& a, const Contact& b) { return a.closest.distance < b.closest.distance; });
  return smallest == contacts.end() ? -1 : smallest->closest.distance;
}

std::vector<Contact> ContactPotential::contacts(const Positions& x) const {
  ContactIterate at;
  start(x, at);
  return contacts(at);
}

std::vector<Contact> ContactPotential::contacts(const Iterate& at) const {
  std::vector<Contact> within;
  for (const Contact& contact : of(at).contacts) {
    if (contact.closest.distance < contact.pair.reach) within.push_back(contact);
  }
  return within;
}

void ContactPotential::addGradient(const Positions& x, Positions& gradient) const {
  ContactIterate at;
  start(x, at);
  addGradient(x, at, gradient);
}

double ContactPotential::energy(const Positions& x) const {
  double sum = 0;
  for (const Contact& contact : contacts(x)) sum += energyOf(contact);
  return sum;
}

}  // namespace shell_origami
