/// \file
/// Scenes of rigid folding: sheets with creases that are folded slowly.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <string>
#include <utility>
#include <vector>

namespace shell_origami {

constexpr double kDegree = M_PI / 180;

/// Returns a disc whose creases rho0, rho1, ... run from its center, vertex 0, to its border in
/// these directions [rad], each with the sign of its assignment.
Sheet vertexSheet(const std::vector<double>& directions, const std::vector<double>& signs,
                  double radius, double max_edge);

/// Returns a configuration for quasi-static folding, with a Newton tolerance of 1e-5 m/s.
SimulationConfig quasiStatic();

FoldEdit foldCrease(const std::string& name, double angle, double duration);

/// Returns a recipe's sheet, coarse and flat, before its first step.
Simulation fromRecipe(const std::string& name);

/// Steps to this time [s]. Throws std::runtime_error if a step does not converge.
void stepUntil(Simulation& simulation, double time);

/// Folds creases by name, each by its sign times `angle` [rad], within 1.5 s and then waits for 2
/// s. Throws std::runtime_error if a step does not converge.
void foldAndRest(Simulation& simulation, const std::vector<std::pair<std::string, double>>& creases,
                 double angle);

}  // namespace shell_origami
