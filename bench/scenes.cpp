#include "bench/scenes.h"

#include <cmath>

namespace shell_origami {
namespace {

const std::string kRecipes = RECIPE_FOLDER;
constexpr double kSide = 0.15;  // [m]

SheetSource squareOf(double side, double triangles) {
  SheetSource source;
  source.width = source.height = side;
  // Equilateral triangles with this edge would be a fifth fewer, because most edges are shorter.
  source.max_edge = 1.1 * side * std::sqrt(4 / std::sqrt(3.0) / triangles);
  return source;
}

}  // namespace

SheetSource square(double triangles) { return squareOf(kSide, triangles); }

Recipe firstFold(double triangles) {
  FoldEdit back;
  back.where = Segment{Vector2(0, 0), Vector2(kSide, kSide)};
  back.angle = -170 * M_PI / 180;
  Recipe recipe;
  recipe.name = "first_fold";
  recipe.sheet = square(triangles);
  recipe.steps = {FoldStep{{back}, {}, 1.0}, SettleStep{0.2}};
  return recipe;
}

Recipe dog(double triangles) {
  Recipe recipe = loadRecipe(kRecipes + "/dog.yaml");
  recipe.sheet.max_edge = square(triangles).max_edge;
  return recipe;
}

Recipe cantilever(double triangles) {
  Recipe recipe;
  recipe.name = "cantilever";
  recipe.sheet = square(triangles);
  recipe.config.gravity.z() = -9.81;
  const double clamp = recipe.sheet.max_edge;
  const Region side{{{0, 0}, {clamp, 0}, {clamp, kSide}, {0, kSide}}};
  recipe.steps = {PinStep{side}, SettleStep{2.0}};
  return recipe;
}

Recipe swing(double triangles) {
  constexpr double side = 0.2, clamp = 0.02;
  Recipe recipe;
  recipe.name = "swing";
  recipe.sheet = squareOf(side, triangles);
  recipe.config.gravity.z() = -9.81;
  recipe.config.material.youngs_modulus = 5e9;
  recipe.config.material.density = 1000;
  recipe.config.material.air_damping = 0;
  const Region held{{{0, 0}, {clamp, 0}, {clamp, side}, {0, side}}};
  // It does not come to rest within that time.
  recipe.steps = {PinStep{held}, SettleStep{1.0}};
  return recipe;
}

Recipe touching(const std::string& name, double triangles) {
  Recipe recipe = loadRecipe(kRecipes + "/../bench/recipes/" + name + ".yaml");
  recipe.sheet.max_edge = square(triangles).max_edge;
  return recipe;
}

Recipe recipeNamed(const std::string& name) { return loadRecipe(kRecipes + "/" + name + ".yaml"); }

}  // namespace shell_origami
