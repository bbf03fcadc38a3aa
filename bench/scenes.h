/// \file
/// Named scenes: recipes with a sheet of any fineness.
#pragma once

#include <shell_origami/origami/recipe.h>

#include <string>

namespace shell_origami {

/// A square of 0.15 m in about so many triangles.
SheetSource square(double triangles);

/// The dog's back alone: a whole diagonal to 170 degrees within a second, and 0.2 s more.
Recipe firstFold(double triangles);

/// recipes/dog.yaml, the flat sheet in about so many triangles.
Recipe dog(double triangles);

/// A square held along one side, falling under gravity for two seconds.
Recipe cantilever(double triangles);

/// A square of 0.2 m of heavier, stiffer paper, held along one side, falling and swinging under
/// gravity for a second. Nothing but the scheme damps it.
Recipe swing(double triangles);

/// bench/recipes/<name>.yaml, in which paper meets paper, the flat sheet in about so many
/// triangles.
Recipe touching(const std::string& name, double triangles);

/// recipes/<name>.yaml as it is.
Recipe recipeNamed(const std::string& name);

}  // namespace shell_origami
