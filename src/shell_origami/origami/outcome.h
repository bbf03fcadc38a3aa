/// \file
/// How folded paper falls short of what was asked for.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <cstdint>
#include <string>
#include <vector>

namespace shell_origami {

/// A crease whose mean angle is farther than this from its target has missed it [rad].
constexpr double kMissedBy = 2 * M_PI / 180;

struct MissedCrease {
  std::uint32_t id = 0;
  std::string name;
  double target = 0;  ///< [rad]
  double angle = 0;   ///< mean [rad]
  std::string why;    ///< the likely cause, one clause
};

/// The creases that folds have named and that are not where these folds end, in the order of the
/// sheet's creases. Complete once no fold is running: one that runs has not missed anything yet.
std::vector<MissedCrease> missedCreases(const Simulation& simulation);

/// One sentence: how many creases missed their targets, and which one by most. Empty: none.
std::string missedSentence(const std::vector<MissedCrease>& missed);

/// Panels whose creases are at angles at which rigid panels close are meant to stay flat. One that
/// has a part farther than this from its mean normal is bent [rad].
constexpr double kBentBy = 10 * M_PI / 180;

/// One sentence: which panel is bent most of those that are meant to stay flat. Empty: none is.
std::string bentSentence(const Simulation& simulation);

/// One sentence: paper is stretched further than paper bears. Empty: it is not.
std::string stretchedSentence(const Simulation& simulation);

/// One sentence: how much of the paper passes through itself, and where. Empty: nothing.
std::string crossingSentence(const Simulation& simulation);

/// All that the paper, once it has settled, is not as it was asked for: the sentences above that
/// are not empty.
/// \param missed  missedCreases() of the simulation
std::vector<std::string> shortfalls(const Simulation& simulation,
                                    const std::vector<MissedCrease>& missed);
std::vector<std::string> shortfalls(const Simulation& simulation);

/// Returns the sentences of shortfalls() in one text.
std::string shortfallText(const std::vector<std::string>& sentences);

}  // namespace shell_origami
