/// The orders of layers of patterns whose number is known.
#include "test/acceptance/layer_solver.h"

#include "verify/folding.h"

#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/mesh/triangulate.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

constexpr std::size_t kAll = 10000;

/// A map of squares, with a crease for each two that are neighbors.
Sheet makeMap(int columns, int rows) {
  PlanarGraph graph;
  std::vector<int> inner;
  const auto addSegment = [&](int from, int to, bool on_border) {
    if (!on_border) inner.push_back(static_cast<int>(graph.segments.size()));
    graph.segments.push_back({from, to});
  };
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      const int here = static_cast<int>(graph.points.size());
      if (x < columns) addSegment(here, here + 1, y == 0 || y == rows);
      if (y < rows) addSegment(here, here + columns + 1, x == 0 || x == columns);
      graph.points.push_back(Vector2(x, y));
    }
  }
  const GraphMesh mesh = meshGraph(graph, 0);
  std::vector<Crease> creases;
  for (int segment : inner) {
    const auto id = static_cast<std::uint32_t>(creases.size());
    creases.push_back({id, "crease_" + std::to_string(id), mesh.chains[segment]});
  }
  return Sheet(mesh.triangulation, creases);
}

/// The conditions of a sheet whose creases are mountains or valleys by their sign; 0: they are
/// flat.
LayerConditions conditionsOf(const Sheet& sheet, const std::vector<double>& signs) {
  std::vector<double> angles;
  for (double sign : signs) angles.push_back(sign * M_PI);
  return layerConditions(foldFlat(sheet, angles));
}

/// The conditions of a map whose creases may become mountains and valleys alike.
LayerConditions conditionsOfMap(int columns, int rows) {
  const Sheet map = makeMap(columns, rows);
  LayerConditions conditions = conditionsOf(map, std::vector<double>(map.creases().size(), 1));
  conditions.creased.clear();
  return conditions;
}

/// What becomes of the order of layers if two panels change places.
/// \pre all panels overlap
Stacking swapped(const LayerConditions& conditions, const Stacking& stacking, int a, int b) {
  const auto orderOf = [&](int one, int two) {
    for (std::size_t i = 0; i < stacking.size(); ++i) {
      if (conditions.pairs[i] == std::array<int, 2>{one, two}) return stacking[i];
      if (conditions.pairs[i] == std::array<int, 2>{two, one}) return -stacking[i];
    }
    return 0;
  };
  const auto other = [&](int panel) { return panel == a ? b : panel == b ? a : panel; };
  Stacking result;
  for (const auto& [one, two] : conditions.pairs) {
    result.push_back(orderOf(other(one), other(two)));
  }
  return result;
}

// Ways of folding a strip of stamps (OEIS A000136), and a map of two rows (A001415) or of as many
// rows as columns (A001418), onto one of its stamps.
TEST(LayerSolver, CountsTheFoldingsOfStampsAndMaps) {
  EXPECT_EQ(stackings(conditionsOfMap(2, 1), kAll).size(), 2u);
  EXPECT_EQ(stackings(conditionsOfMap(3, 1), kAll).size(), 6u);
  EXPECT_EQ(stackings(conditionsOfMap(4, 1), kAll).size(), 16u);
  EXPECT_EQ(stackings(conditionsOfMap(5, 1), kAll).size(), 50u);
  EXPECT_EQ(stackings(conditionsOfMap(2, 2), kAll).size(), 8u);
  EXPECT_EQ(stackings(conditionsOfMap(3, 2), kAll).size(), 60u);
  EXPECT_EQ(stackings(conditionsOfMap(3, 3), kAll).size(), 1368u);
}

TEST(LayerSolver, MountainsAndValleysShareTheFoldingsOfAStrip) {
  const Sheet strip = makeMap(4, 1);
  std::size_t sum = 0;
  for (int bits = 0; bits < 8; ++bits) {
    std::vector<double> signs;
    for (int i = 0; i < 3; ++i) signs.push_back((bits >> i) % 2 ? 1 : -1);
    sum += stackings(conditionsOf(strip, signs), kAll).size();
  }
  EXPECT_EQ(sum, 16u);
  EXPECT_EQ(stackings(conditionsOf(strip, {1, -1, 1}), kAll).size(), 1u);
  // A roll of three has either end inside.
  EXPECT_EQ(stackings(conditionsOf(makeMap(3, 1), {1, 1}), kAll).size(), 2u);
}

TEST(LayerSolver, ACreaseThatStaysFlatPartsNoPanel) {
  const LayerConditions conditions = conditionsOf(makeMap(4, 1), {1, 0, 1});
  EXPECT_EQ(conditions.pairs.size(), 2u) << "a door with two wings";
  EXPECT_EQ(stackings(conditions, kAll).size(), 1u);
  EXPECT_TRUE(conditionsOf(makeMap(2, 1), {0}).pairs.empty());
}

// Kawasaki's theorem holds, but the smallest sector lies between the creases 0 and 1 and cannot be
// covered on the same side by both of its neighbors, which are larger.
TEST(LayerSolver, AVertexWhoseSmallestSectorIsBetweenEqualFoldsHasNone) {
  const std::vector<double> directions = {0, 40 * kDegree, 140 * kDegree, 280 * kDegree};
  const auto count = [&](const std::vector<double>& signs) {
    const Sheet sheet = vertexSheet(directions, signs, 0.03, 0.01);
    return stackings(conditionsOf(sheet, signs), kAll).size();
  };
  EXPECT_EQ(count({1, 1, 1, -1}), 0u);
  EXPECT_EQ(count({1, 1, -1, 1}), 0u);
  EXPECT_EQ(count({1, -1, 1, 1}), 1u);
  EXPECT_EQ(count({-1, 1, 1, 1}), 1u);
  EXPECT_EQ(count({1, -1, 1, -1}), 0u) << "Maekawa's theorem";
}

// Numbers of orders as flat-folder finds them. The first two patterns have none, although each of
// their vertices can be folded alone.
TEST(LayerSolver, AgreesWithFlatFolderOnItsExamples) {
  const std::vector<std::pair<std::string, std::size_t>> patterns = {
      {"17_bad-twist-UNSAT", 0},
      {"57_ff-UNSAT_007", 0},
      {"10_house-cp", 1},
      {"12_kabuto-cp", 9},
      {"15_crane-cp", 5},
      {"16_miura-cp", 1},
      {"50_ff-030_tanakaoripa_fish_base", 128},
      {"51_ff-045_traditionaloripa_Pig", 144},
      {"53_ff-021_chan_Simple_Dragon", 24},
      {"58_ff-122_brown_4x4_A100", 1}};
  for (const auto& [name, count] : patterns) {
    FoldReadOptions options;
    options.width = 0.15;
    const Sheet sheet = readFold("data/patterns/" + name + ".fold", options).sheet;
    std::vector<double> signs;
    for (const Crease& crease : sheet.creases()) signs.push_back(crease.pattern_angle / M_PI);
    const LayerConditions conditions = conditionsOf(sheet, signs);
    const std::vector<Stacking> found = stackings(conditions, kAll);
    EXPECT_EQ(found.size(), count) << name;
    for (const Stacking& stacking : found) EXPECT_TRUE(broken(conditions, stacking).empty());
  }
}

TEST(LayerSolver, RejectsWhatDoesNotFoldFlat) {
  const auto fold = [](const std::vector<double>& directions, double angle) {
    const std::vector<double> signs(directions.size(), 1);
    foldFlat(vertexSheet(directions, signs, 0.03, 0.01),
             std::vector<double>(directions.size(), angle));
  };
  fold({0, 40 * kDegree, 140 * kDegree, 280 * kDegree}, M_PI);
  EXPECT_THROW(fold({0, 40 * kDegree, 140 * kDegree, 270 * kDegree}, M_PI), std::invalid_argument)
      << "Kawasaki's theorem";
  EXPECT_THROW(fold({0, 40 * kDegree, 140 * kDegree, 280 * kDegree}, 3), std::invalid_argument);
}

TEST(LayerSolver, FindsLayersThatChangedPlaces) {
  const LayerConditions conditions = conditionsOf(makeMap(4, 1), {1, -1, 1});
  const std::vector<Stacking> found = stackings(conditions, kAll);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(broken(conditions, found[0]).empty());
  for (int a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b) {
      EXPECT_FALSE(broken(conditions, swapped(conditions, found[0], a, b)).empty()) << a << b;
    }
  }
}

}  // namespace
}  // namespace shell_origami
