#include "test/fuzz/fuzz.h"
#include "test/sheet/random_sheets.h"
#include "verify/crease_patterns.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

namespace shell_origami {
namespace {

using Polygon = std::vector<Vector2>;

/// Layers of paper are folded only where nothing becomes smaller than this part of the square.
constexpr double kSmallest = 0.04;
constexpr int kMostCreases = 30;

/// A convex piece of the unit square, and where it lies in the folded plane.
struct Layer {
  Polygon flat;
  Eigen::Affine2d place = Eigen::Affine2d::Identity();
  bool turned = false;  ///< whether its back is seen
};

struct CreaseLine {
  Vector2 a, b;
  bool valley;
};

/// A directed line of the folded plane; what lies left of it is folded over.
struct Line {
  Vector2 point, direction;

  double side(const Vector2& p) const { return cross(direction, p - point); }
  Eigen::Affine2d reflection() const {
    const Eigen::Matrix2d mirror =
        2 * direction * direction.transpose() - Eigen::Matrix2d::Identity();
    return Eigen::Translation2d(point) * Eigen::Affine2d(mirror) * Eigen::Translation2d(-point);
  }
};

/// Appends the parts of a layer beside the line, those left of it folded over. Returns false where
/// the line comes too close to a corner.
bool foldLayer(const Layer& layer, const Line& line, bool up, std::vector<Layer>& layers,
               std::vector<CreaseLine>& creases) {
  Polygon left, right, ends;
  for (std::size_t i = 0; i < layer.flat.size(); ++i) {
    const Vector2& p = layer.flat[i];
    const Vector2& q = layer.flat[(i + 1) % layer.flat.size()];
    const double at_p = line.side(layer.place * p), at_q = line.side(layer.place * q);
    if (std::abs(at_p) < kSmallest) return false;
    (at_p > 0 ? left : right).push_back(p);
    if ((at_p > 0) == (at_q > 0)) continue;
    ends.push_back(p + at_p / (at_p - at_q) * (q - p));
    left.push_back(ends.back());
    right.push_back(ends.back());
  }
  if (!ends.empty()) {
    if ((ends[1] - ends[0]).norm() < kSmallest) return false;
    creases.push_back({ends[0], ends[1], up != layer.turned});
  }
  if (right.size() > ends.size()) layers.push_back({right, layer.place, layer.turned});
  if (left.size() > ends.size()) {
    layers.push_back({left, line.reflection() * layer.place, !layer.turned});
  }
  return true;
}

/// The creases of a square that is folded flat through all layers, again and again.
std::vector<CreaseLine> foldRandomly(RandomSheets& random) {
  std::vector<Layer> layers(1);
  layers[0].flat = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<CreaseLine> creases;
  const int most = 2 + random.below(kMostCreases - 1);
  for (int attempt = 0; attempt < 200; ++attempt) {
    const Layer& hit = layers[random.below(static_cast<int>(layers.size()))];
    Vector2 center = Vector2::Zero();
    for (const Vector2& p : hit.flat) center += p / static_cast<double>(hit.flat.size());
    const double angle = random.between(0, 2 * M_PI);
    const Vector2 aside(random.between(-0.2, 0.2), random.between(-0.2, 0.2));
    const Line line{hit.place * center + aside, {std::cos(angle), std::sin(angle)}};
    const bool up = random.below(2) == 0;
    std::vector<Layer> folded;
    std::vector<CreaseLine> made = creases;
    const bool fits = std::all_of(layers.begin(), layers.end(), [&](const Layer& layer) {
      return foldLayer(layer, line, up, folded, made);
    });
    if (!fits || made.size() == creases.size()) continue;
    if (static_cast<int>(made.size()) > most) break;
    layers = std::move(folded);
    creases = std::move(made);
  }
  return creases;
}

void writePattern(const std::string& path, const std::vector<CreaseLine>& creases) {
  nlohmann::json points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  nlohmann::json edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}}, kinds{"B", "B", "B", "B"};
  for (const CreaseLine& crease : creases) {
    edges.push_back({points.size(), points.size() + 1});
    kinds.push_back(crease.valley ? "V" : "M");
    for (const Vector2& p : {crease.a, crease.b}) points.push_back({p.x(), p.y()});
  }
  std::ofstream(path) << nlohmann::json{
      {"vertices_coords", points}, {"edges_vertices", edges}, {"edges_assignment", kinds}};
}

}  // namespace

bool fuzzPatterns(int patterns, unsigned seed) {
  RandomSheets random(seed);
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("random_pattern_" + std::to_string(getpid()) + ".fold"))
                               .string();
  int right = 0, said = 0, silent = 0;
  for (int i = 0; i < patterns; ++i) {
    const std::vector<CreaseLine> creases = foldRandomly(random);
    writePattern(path, creases);
    const PatternOutcome outcome = foldPattern(path, 0);
    if (std::isnan(outcome.distance)) throw std::logic_error("a pattern that was folded is open");
    if (!outcome.isOff()) {
      ++right;
      continue;
    }
    ++(outcome.said.empty() ? silent : said);
    std::printf("pattern %d of %zu creases is off by %.3f widths, a crease by %.1f degrees: %s\n",
                i, creases.size(), outcome.distance, outcome.worst * 180 / M_PI,
                outcome.said.c_str());
  }
  std::filesystem::remove(path);
  std::printf("%d patterns right, %d off and said so, %d off in silence\n", right, said, silent);
  return silent == 0 && right >= 0.95 * patterns;
}

}  // namespace shell_origami
