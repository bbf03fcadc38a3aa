/// \file
/// Long random runs that look for what no one thought of. Each prints what it saw.
#pragma once

namespace shell_origami {

/// Random folds on random sheets, in sequences of up to twelve on one sheet, which is partly
/// folded in between. True when every promise of edge making was kept.
bool fuzzFolds(int folds, unsigned seed);

/// Random recipes: folds up to 175 degrees within no time to a second, materials over three
/// decades, pins, gravity. True when paper stayed whole throughout; a step that does not hold
/// must leave it so too, and say why.
bool fuzzRecipes(int recipes, unsigned seed);

}  // namespace shell_origami
