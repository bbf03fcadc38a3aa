/// \file
/// Long random runs that look for what no one thought of. Each prints what it saw.
#pragma once

namespace shell_origami {

/// Random folds on random sheets, in sequences of up to twelve on one sheet, which is partly
/// folded in between. True when every promise of edge making was kept.
bool fuzzFolds(int folds, unsigned seed);

/// Papers with contact, each folded one to three times through its layers, by random axioms,
/// landmarks, layers and angles. True when each fold either ended with every crease on its side and
/// no paper through paper, or was rejected with a reason and changed nothing. A step that does not
/// converge, which must leave the paper as it was, ends a paper's folds: it is stuck.
bool fuzzFoldsThrough(int papers, unsigned seed);

/// Random recipes: folds up to 175 degrees within no time to a second, materials over three
/// decades, pins, gravity. True when paper stayed whole throughout and came to rest where nothing
/// moves it; a step that does not converge must leave it whole too, and give a reason. So must an
/// edit that is rejected, one in fifty recipes at most.
bool fuzzRecipes(int recipes, unsigned seed);

/// FOLD files that are random changes of the patterns in test/data and recipes/, and snapshots that
/// are random changes of our own. True when each was read or rejected with a message, within two
/// seconds of processor time and two gigabytes.
bool fuzzFoldText(int inputs, unsigned seed);
bool fuzzCbor(int inputs, unsigned seed);

/// Random sequences of edits on random sheets. True when after each the sheet is valid and the
/// paper made again of its snapshot goes on to the bit.
bool fuzzEdits(int edits, unsigned seed);

/// Papers among up to four random obstacles, of which some are moved, for a second. True when paper
/// was whole, and passed neither through itself nor through an obstacle, after every step, and
/// steps that did not converge gave a reason.
bool fuzzObstacles(int scenes, unsigned seed);

/// Crease patterns of squares that were folded flat through all layers along random lines. True
/// when 95 % of them fold to within 2 % of the exact state, and what is amiss is said of the rest.
bool fuzzPatterns(int patterns, unsigned seed);

}  // namespace shell_origami
