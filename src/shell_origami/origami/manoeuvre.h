/// \file
/// Folds that turn layers inside out, each a sequence of phases over ordinary folds.
#pragma once

#include <shell_origami/origami/petal_fold.h>
#include <shell_origami/origami/pleat_fold.h>
#include <shell_origami/origami/rabbit_ear.h>
#include <shell_origami/origami/reverse_fold.h>
#include <shell_origami/origami/squash_fold.h>

#include <variant>

namespace shell_origami {

using Manoeuvre = std::variant<PetalFold, PleatFold, RabbitEar, ReverseFold, SquashFold>;

/// Returns how a manoeuvre is carried out. Nothing is changed.
/// \throws std::invalid_argument with one sentence that says why the paper cannot be folded so
ManoeuvrePlan planManoeuvre(const Manoeuvre& manoeuvre, const ManoeuvreManner& manner,
                            const Viewpoint& view, const Simulation& simulation);

/// How long a manoeuvre takes, in durations of a single fold.
double lengthOf(const Manoeuvre& manoeuvre);
/// Its word in recipes.
const char* wordOf(const Manoeuvre& manoeuvre);

}  // namespace shell_origami
