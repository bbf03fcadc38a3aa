#include <shell_origami/origami/fold_through.h>

#include <shell_origami/base/error.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

/// Part of the sheet's size by which a panel must pass the fold's plane: by less it is only near.
constexpr double kNear = 0.004;
/// A panel whose cut leaves its straight line by more than this part of the cut's length is bent.
constexpr double kBent = 0.03;
/// A fold ends at a corner or at the end of a crease that is nearer than this part of the sheet's
/// size: layers do not lie exactly on each other.
constexpr double kSnap = 0.008;

/// Where a plane cuts a panel, on the flat sheet.
struct Cut {
  std::vector<Vector2> points;
  int triangle = -1;  ///< one of those cut
};

/// The straight line through the points of a cut. \throws std::invalid_argument where it is bent
Segment straightened(const Cut& cut, double size) {
  Vector2 mean = Vector2::Zero();
  for (const Vector2& p : cut.points) mean += p / static_cast<double>(cut.points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vector2& p : cut.points) spread += (p - mean) * (p - mean).transpose();
  const Vector2 along =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
  const auto before = [&](const Vector2& p, const Vector2& q) {
    return along.dot(p) < along.dot(q);
  };
  const auto [first, last] = std::minmax_element(cut.points.begin(), cut.points.end(), before);
  const Segment line{*first, *last};
  const double length = (line[1] - line[0]).norm();
  for (const Vector2& p : cut.points) {
    const double off = std::abs(cross(line[1] - line[0], p - line[0])) / length;
    if (off > std::max(kBent * length, kNear * size)) {
      reject("the layer at (", mean.x(), ", ", mean.y(),
             ") of the flat sheet is bent along the fold: let it settle first");
    }
  }
  return line;
}

/// One fold under way.
class Planner {
 public:
  Planner(const FoldThrough& fold, const Vector3& viewer, const Simulation& simulation)
      : fold_(fold),
        simulation_(simulation),
        sheet_(simulation.sheet()),
        size_(sheet_.size()),
        plane_(foldPlane(fold.axiom, sheet_, simulation.positions(), viewer)),
        layers_(simulation, plane_, viewer, kNear * size_),
        features_(featuresOf(sheet_)) {}

  FoldPlan plan() const {
    const std::vector<bool> moves = layers_.chosen(fold_.layers, fold_.count, flap());
    layers_.requireFree(moves, fold_.behind);
    FoldPlan plan{{}, layers_.viewOfRest(moves)};
    for (const auto& [panel, cut] : cuts(moves)) {
      const Segment line = snapped(straightened(cut, size_));
      if ((line[1] - line[0]).norm() < kNear * size_) continue;
      plan.layers.push_back({panel, line, turn(cut.triangle)});
    }
    addCreasesOnPlane(moves, plan.layers);
    if (plan.layers.empty()) reject("no layer is cut by the fold");
    return plan;
  }

 private:
  Segment snapped(Segment line) const {
    for (Vector2& end : line) {
      for (int v : features_) {
        const Vector2& feature = sheet_.flatPositions()[v];
        if ((feature - end).norm() < kSnap * size_) end = feature;
      }
    }
    return line;
  }

  std::optional<Vector2> flap() const {
    if (fold_.layers != FoldLayers::kFlap) return std::nullopt;
    return flatPoint(fold_.flap, sheet_);
  }

  double distance(int v) const { return plane_.distance(simulation_.positions().col(v)); }

  /// The angle of a crease through a triangle's layer: a valley where its front faces the viewer
  /// and the fold comes towards the viewer.
  double turn(int triangle) const {
    return std::copysign(fold_.angle, (fold_.behind ? -1 : 1) * layers_.facing(triangle));
  }

  /// The cut of each panel that the plane cuts through, and on whose moving side it moves.
  std::map<int, Cut> cuts(const std::vector<bool>& moves) const {
    const double least = kNear * size_;
    std::map<int, std::pair<double, double>> range;
    for (std::size_t i = 0; i < sheet_.triangles().size(); ++i) {
      for (int v : sheet_.triangles()[i]) {
        auto& [low, high] = range[layers_.panel(i)];
        low = std::min(low, distance(v));
        high = std::max(high, moves[i] ? distance(v) : 0);
      }
    }
    std::map<int, Cut> cuts;
    for (std::size_t i = 0; i < sheet_.triangles().size(); ++i) {
      const auto [low, high] = range[layers_.panel(i)];
      // Triangles that hardly reach beyond the plane are of no flap.
      const bool cut_here = moves[i] || !layers_.inFlap(i);
      if (!cut_here || low > -least || high < least) continue;
      const Triangle& t = sheet_.triangles()[i];
      for (int k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        const double from = distance(a), to = distance(b);
        if ((from > 0) == (to > 0)) continue;
        const double part = from / (from - to);
        Cut& cut = cuts[layers_.panel(i)];
        cut.triangle = static_cast<int>(i);
        cut.points.push_back((1 - part) * sheet_.flatPositions()[a] +
                             part * sheet_.flatPositions()[b]);
      }
    }
    return cuts;
  }

  /// Creases that lie on the plane, beside paper that moves, change by the fold's angle.
  void addCreasesOnPlane(const std::vector<bool>& moves, std::vector<LayerFold>& folds) const {
    const std::vector<CreaseStatus> creases = simulation_.creases();
    for (const Edge& edge : sheet_.edges()) {
      if (edge.crease < 0 || edge.onBorder()) continue;
      const auto [a, b] = edge.vertices;
      if (std::max(std::abs(distance(a)), std::abs(distance(b))) > kNear * size_) continue;
      const bool first = movesBeside(edge, 0, moves), second = movesBeside(edge, 1, moves);
      if (first == second) continue;  // none of them moves, or both on one side of the fold
      const int triangle = edge.triangles[first ? 0 : 1];
      const double angle = creases[edge.crease].angle + turn(triangle);
      if (std::abs(angle) >= M_PI) {
        reject("crease ", sheet_.creases()[edge.crease].name, " is at ",
               creases[edge.crease].angle * 180 / M_PI, " degrees and would pass 180");
      }
      folds.push_back(
          {layers_.panel(triangle), {sheet_.flatPositions()[a], sheet_.flatPositions()[b]}, angle});
    }
  }

  bool movesBeside(const Edge& edge, int side, const std::vector<bool>& moves) const {
    return moves[edge.triangles[side]] && distance(edge.opposite[side]) > 0;
  }

  const FoldThrough& fold_;
  const Simulation& simulation_;
  const Sheet& sheet_;
  double size_;
  FoldPlane plane_;
  LayersBesidePlane layers_;
  std::vector<int> features_;
};

}  // namespace

FoldPlan planFold(const FoldThrough& fold, const Viewpoint& view, const Simulation& simulation) {
  return Planner(fold, viewerOf(view, simulation), simulation).plan();
}

std::vector<FoldEdit> foldEdits(const FoldPlan& plan, const FoldThrough& fold) {
  std::vector<FoldEdit> edits;
  for (const LayerFold& layer : plan.layers) {
    FoldEdit edit;
    edit.where = layer.line;
    edit.angle = layer.angle;
    edit.duration = fold.duration;
    edits.push_back(std::move(edit));
  }
  return edits;
}

}  // namespace shell_origami
