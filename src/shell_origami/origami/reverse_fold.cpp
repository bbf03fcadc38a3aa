#include <shell_origami/origami/reverse_fold.h>

#include <shell_origami/base/error.h>
#include <shell_origami/origami/layer_cuts.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace shell_origami {
namespace {

/// Parts of the whole duration, and stiffness of creases as multiples of the material's, by phase:
/// the body is loosened, the tip opened along its spine, its sides turned halfway, then all of it
/// on, and the body tightened. All at once ends on the wrong side. Between phases the paper does
/// not rest, or it would harden in shapes that it does not keep.
constexpr double kLoosen = 0.1, kOpen = 0.25, kHalfway = 0.2, kOn = 0.3, kTighten = 0.2;
constexpr double kLoose = 1, kOpening = 5, kTurning = 10, kShutting = 15, kTightenBeside = 5;
/// Part of the body's angles that is left when it is loosened.
constexpr double kOpenBody = 0.75, kOpenFarther = 0.5;

/// The fold along which the halves of a tip are joined.
struct Spine {
  int crease = -1;           ///< index into Sheet::creases(), at the tip
  std::vector<int> path;     ///< its vertices from the tip on
  std::vector<int> half_of;  ///< of each triangle that moves 0 or 1, else -1
};

class ReversePlanner {
 public:
  ReversePlanner(const ReverseFold& reverse, const ManoeuvreManner& manner, const Viewpoint& view,
                 const Simulation& simulation)
      : reverse_(reverse),
        manner_(manner),
        simulation_(simulation),
        sheet_(simulation.sheet()),
        folded_(foldedCreases(simulation)),
        paper_(viewedPaper(view, simulation)),
        plane_(foldPlane(reverse.axiom, sheet_, paper_.positions, paper_.viewer)),
        layers_(sheet_, paper_, plane_, kReach * sheet_.size()),
        moves_(layers_.chosen(FoldLayers::kFlap, 1, flatPoint(reverse.flap, sheet_))) {}

  ManoeuvrePlan plan() {
    findSpine();
    const std::vector<LayerCut> cuts = cutLayers(sheet_, paper_, plane_, layers_, moves_);
    const Vector2 bend = bendOf(cuts);
    const auto& flat = sheet_.flatPositions();
    const double before = shutAngle(spine_.crease, simulation_);
    const Segment tip{flat[spine_.path.front()], bend};
    ManoeuvrePlan plan{{}, {}, layers_.viewOfRest(moves_)};
    std::vector<FoldEdit> halfway, on, body = this->body(bend);
    on.push_back(fold(tip, -std::copysign(manner_.angle, before), kOn, kShutting));
    const std::vector<CreaseStatus> creases = simulation_.creases();
    const std::array<int, 2> at_bend = layersAtBend(cuts, bend);
    for (const LayerCut& cut : cuts) {
      const int half = halfOf(cut.panel);
      if (half < 0) reject("a layer that the fold cuts is of neither half of the flap");
      const double angle = angleOf(cut, turn(cut.triangle, at_bend[half], before), creases);
      halfway.push_back(fold(cut.line, angle / 2, kHalfway, kTurning));
      on.push_back(fold(cut.line, angle, kOn, kShutting));
    }
    plan.result = on;
    plan.result.insert(plan.result.end(), body.begin(), body.end());
    plan.phases = {{loosened(body)},
                   {{fold(tip, 0, kOpen, kOpening)}},
                   {std::move(halfway)},
                   {std::move(on)},
                   {std::move(body)}};
    return plan;
  }

 private:
  FoldEdit fold(const Segment& line, double angle, double part, double stiffness) const {
    FoldEdit fold = lineFold(line, angle, part * manner_.duration);
    fold.stiffness = stiffness * simulation_.config().material.crease_stiffness;
    return fold;
  }

  /// The halves lie one over the other: the fold that splits the tip into parts of sizes most
  /// alike.
  void findSpine() {
    const int tip = outlineVertexAt(reverse_.flap, "the flap's tip", sheet_);
    double best = 0;
    for (int next : folded_.at(tip)) {
      Spine spine{creaseBetween(sheet_, tip, next), folded_.along(tip, next), {}};
      const double balance = split(spine);
      if (balance <= best) continue;
      best = balance;
      spine_ = std::move(spine);
    }
    const Vector2& p = sheet_.flatPositions()[tip];
    if (best == 0) {
      reject("no fold at the flap's tip (", p.x(), ", ", p.y(), ") parts it into two halves");
    }
  }

  /// Returns the smaller over the larger half's area.
  double split(Spine& spine) const {
    const std::vector<int> parts = connectedTriangles(sheet_, [&](const Edge& edge) {
      return !edge.onBorder() && moves_[edge.triangles[0]] && moves_[edge.triangles[1]] &&
             !onPath(edge, spine.path);
    });
    std::map<int, double> areas;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (moves_[i]) areas[parts[i]] += areaOf(i);
    }
    std::vector<std::pair<double, int>> halves;
    for (const auto& [part, area] : areas) halves.emplace_back(area, part);
    std::sort(halves.rbegin(), halves.rend());
    if (halves.size() < 2) return 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const int half = parts[i] == halves[0].second ? 0 : parts[i] == halves[1].second ? 1 : -1;
      spine.half_of.push_back(moves_[i] ? half : -1);
    }
    return halves[1].first / halves[0].first;
  }

  static bool onPath(const Edge& edge, const std::vector<int>& path) {
    const auto on = [&](int v) { return std::find(path.begin(), path.end(), v) != path.end(); };
    return on(edge.vertices[0]) && on(edge.vertices[1]);
  }

  double areaOf(std::size_t triangle) const {
    const auto& [a, b, c] = sheet_.triangles()[triangle];
    const auto& flat = sheet_.flatPositions();
    return doubleArea(flat[a], flat[b], flat[c]);
  }

  /// Where the fold crosses the spine, on the flat sheet.
  Vector2 bendOf(const std::vector<LayerCut>& cuts) const {
    const Segment spine{sheet_.flatPositions()[spine_.path.front()],
                        sheet_.flatPositions()[spine_.path.back()]};
    const double length = (spine[1] - spine[0]).norm();
    for (const LayerCut& cut : cuts) {
      for (const Vector2& end : cut.line) {
        const double off = cross(spine[1] - spine[0], end - spine[0]) / length;
        const double along = (spine[1] - spine[0]).dot(end - spine[0]) / length;
        if (std::abs(off) < kReach * sheet_.size() && along > 0 && along <= length) return end;
      }
    }
    reject("the fold does not cross the fold at which the flap's halves are joined");
  }

  /// 0 or 1; -1: a panel that does not move.
  int halfOf(int panel) const {
    for (std::size_t i = 0; i < spine_.half_of.size(); ++i) {
      if (layers_.panel(i) == panel && spine_.half_of[i] >= 0) return spine_.half_of[i];
    }
    return -1;
  }

  /// A triangle of each half whose cut ends at the bend.
  std::array<int, 2> layersAtBend(const std::vector<LayerCut>& cuts, const Vector2& bend) const {
    std::array<int, 2> found{-1, -1};
    for (const LayerCut& cut : cuts) {
      const int half = halfOf(cut.panel);
      for (const Vector2& end : cut.line) {
        if (half >= 0 && (end - bend).norm() < kReach * sheet_.size()) found[half] = cut.triangle;
      }
    }
    if (found[0] < 0 || found[1] < 0) reject("the fold does not cut both halves of the flap");
    return found;
  }

  /// The angle of a crease through a triangle's layer. Where the halves meet at the bend, the
  /// sides' creases go to the side of the body's spine, inside, or to the other one; from there on
  /// they alternate from layer to layer. (Of four creases at a flat vertex three go to one side.)
  double turn(int triangle, int at_bend, double spine) const {
    const bool alike = layers_.facing(triangle) * layers_.facing(at_bend) > 0;
    return std::copysign(manner_.angle, alike == reverse_.inside ? spine : -spine);
  }

  /// The folds beside the bend that must give way: the rest of the spine, and those next to it
  /// where it ends.
  std::vector<FoldEdit> body(const Vector2& bend) const {
    const auto& flat = sheet_.flatPositions();
    const int end = spine_.path.back();
    std::vector<FoldEdit> body;
    if ((flat[end] - bend).norm() < kReach * sheet_.size()) return body;
    body.push_back(keeping({bend, flat[end]}, spine_.crease, kShutting));
    const std::vector<int> around = folded_.at(end);
    const auto own = std::find(around.begin(), around.end(), spine_.path[spine_.path.size() - 2]);
    const auto count = static_cast<int>(around.size()), at = static_cast<int>(own - around.begin());
    if (count < 3 || sheet_.triangulation().onBorder(end)) return body;
    for (int next : {around[(at + 1) % count], around[(at + count - 1) % count]}) {
      const Segment line{flat[end], flat[folded_.along(end, next).back()]};
      body.push_back(keeping(line, creaseBetween(sheet_, end, next), kTightenBeside));
    }
    return body;
  }

  FoldEdit keeping(const Segment& line, int crease, double stiffness) const {
    return fold(line, simulation_.creases()[crease].target_angle, kTighten, stiffness);
  }

  std::vector<FoldEdit> loosened(std::vector<FoldEdit> body) const {
    for (FoldEdit& edit : body) {
      edit.duration = kLoosen * manner_.duration;
      edit.angle *= manner_.looser ? kOpenFarther : kOpenBody;
      edit.stiffness = kLoose * simulation_.config().material.crease_stiffness;
    }
    return body;
  }

  const ReverseFold& reverse_;
  const ManoeuvreManner& manner_;
  const Simulation& simulation_;
  const Sheet& sheet_;
  FoldedCreases folded_;
  ViewedPaper paper_;
  FoldPlane plane_;
  LayersBesidePlane layers_;
  std::vector<bool> moves_;
  Spine spine_;
};

}  // namespace

ManoeuvrePlan planReverseFold(const ReverseFold& reverse, const ManoeuvreManner& manner,
                              const Viewpoint& view, const Simulation& simulation) {
  return ReversePlanner(reverse, manner, view, simulation).plan();
}

}  // namespace shell_origami
