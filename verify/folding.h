/// \file
/// Sheets with creases, and how to fold them slowly: scenes of rigid folding.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <string>
#include <utility>
#include <vector>

namespace shell_origami {

constexpr double kDegree = M_PI / 180;

/// A disc whose creases run from its center to its border, at these angles and each with the sign
/// of its assignment. They are called rho0, rho1, ...; the center is vertex 0.
Sheet vertexSheet(const std::vector<double>& directions, const std::vector<double>& signs,
                  double radius, double max_edge);

/// Slow enough to be quasi-static: Newton's velocities below a hundredth of what is seen.
SimulationConfig quasiStatic();

FoldEdit foldCrease(const std::string& name, double angle, double duration);

/// A recipe's sheet, coarse and flat, with nothing done to it yet.
Simulation fromRecipe(const std::string& name);

/// \throws std::runtime_error when a step does not converge.
void stepUntil(Simulation& simulation, double time);

/// Folds creases by name, each by its sign times `angle` [rad], and rests. \throws
/// std::runtime_error
void foldAndRest(Simulation& simulation, const std::vector<std::pair<std::string, double>>& creases,
                 double angle);

}  // namespace shell_origami
