#include <shell_origami/origami/layer_cuts.h>

#include <shell_origami/base/error.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

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
    if (off > std::max(kBent * length, kReach * size)) {
      reject("the layer at (", mean.x(), ", ", mean.y(),
             ") of the flat sheet is bent along the fold: let it settle first");
    }
  }
  return line;
}

/// The cuts of one plane.
class Cutter {
 public:
  Cutter(const Sheet& sheet, const ViewedPaper& paper, const FoldPlane& plane,
         const LayersBesidePlane& layers, const std::vector<bool>& moves)
      : sheet_(sheet), layers_(layers), moves_(moves), size_(sheet.size()) {
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      distances_.push_back(plane.distance(paper.positions.col(v)));
    }
  }

  std::vector<LayerCut> cuts() const {
    std::vector<LayerCut> cuts;
    const std::vector<int> features = featuresOf(sheet_);
    for (const auto& [panel, cut] : panelCuts()) {
      const Segment line = snapped(straightened(cut, size_), features);
      if ((line[1] - line[0]).norm() < kReach * size_) continue;
      cuts.push_back({panel, cut.triangle, line});
    }
    for (const auto& [place, cut] : creasesOnPlane()) {
      cuts.push_back({place.second, cut.triangle, straightened(cut, size_), place.first});
    }
    return cuts;
  }

 private:
  Segment snapped(Segment line, const std::vector<int>& features) const {
    for (Vector2& end : line) {
      for (int v : features) {
        const Vector2& feature = sheet_.flatPositions()[v];
        if ((feature - end).norm() < kSnap * size_) end = feature;
      }
    }
    return line;
  }

  /// The cut of each panel that the plane cuts through, and on whose moving side it moves.
  std::map<int, Cut> panelCuts() const {
    const double least = kReach * size_;
    std::map<int, std::pair<double, double>> range;
    for (std::size_t i = 0; i < sheet_.triangles().size(); ++i) {
      for (int v : sheet_.triangles()[i]) {
        auto& [low, high] = range[layers_.panel(i)];
        low = std::min(low, distances_[v]);
        high = std::max(high, moves_[i] ? distances_[v] : 0);
      }
    }
    std::map<int, Cut> cuts;
    for (std::size_t i = 0; i < sheet_.triangles().size(); ++i) {
      const auto [low, high] = range[layers_.panel(i)];
      // Triangles that hardly reach beyond the plane are of no flap.
      const bool cut_here = moves_[i] || !layers_.inFlap(i);
      if (!cut_here || low > -least || high < least) continue;
      addCut(static_cast<int>(i), cuts[layers_.panel(i)]);
    }
    for (auto cut = cuts.begin(); cut != cuts.end();) {
      cut = cut->second.points.empty() ? cuts.erase(cut) : std::next(cut);
    }
    return cuts;
  }

  void addCut(int triangle, Cut& cut) const {
    const Triangle& t = sheet_.triangles()[triangle];
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const double from = distances_[a], to = distances_[b];
      if ((from > 0) == (to > 0)) continue;
      const double part = from / (from - to);
      cut.triangle = triangle;
      cut.points.push_back((1 - part) * sheet_.flatPositions()[a] +
                           part * sheet_.flatPositions()[b]);
    }
  }

  /// Creases that lie on the plane, beside paper that moves, by crease and panel.
  std::map<std::pair<int, int>, Cut> creasesOnPlane() const {
    std::map<std::pair<int, int>, Cut> creases;
    for (const Edge& edge : sheet_.edges()) {
      if (edge.crease < 0 || edge.onBorder()) continue;
      const auto [a, b] = edge.vertices;
      if (std::max(std::abs(distances_[a]), std::abs(distances_[b])) > kReach * size_) continue;
      const bool first = movesBeside(edge, 0), second = movesBeside(edge, 1);
      if (first == second) continue;  // none of them moves, or both on one side of the fold
      const int triangle = edge.triangles[first ? 0 : 1];
      Cut& cut = creases[{edge.crease, layers_.panel(triangle)}];
      cut.triangle = triangle;
      for (int v : {a, b}) cut.points.push_back(sheet_.flatPositions()[v]);
    }
    return creases;
  }

  bool movesBeside(const Edge& edge, int side) const {
    return moves_[edge.triangles[side]] && distances_[edge.opposite[side]] > 0;
  }

  const Sheet& sheet_;
  const LayersBesidePlane& layers_;
  const std::vector<bool>& moves_;
  double size_;
  std::vector<double> distances_;  ///< of each vertex from the plane [m]
};

}  // namespace

double angleOf(const LayerCut& cut, double by, const std::vector<CreaseStatus>& creases) {
  if (cut.crease < 0) return by;
  const CreaseStatus& crease = creases[cut.crease];
  const double angle = crease.target_angle + by;
  if (std::abs(angle) >= M_PI) {
    reject("crease ", crease.name, " is at ", crease.target_angle * 180 / M_PI,
           " degrees and would pass 180");
  }
  return angle;
}

std::vector<LayerCut> cutLayers(const Sheet& sheet, const ViewedPaper& paper,
                                const FoldPlane& plane, const LayersBesidePlane& layers,
                                const std::vector<bool>& moves) {
  return Cutter(sheet, paper, plane, layers, moves).cuts();
}

}  // namespace shell_origami
