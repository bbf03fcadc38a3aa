/// \file
/// Papers folded exactly, and what a manoeuvre's plan makes of them.
#pragma once

#include <shell_origami/origami/manoeuvre.h>
#include <shell_origami/sheet/rigid_panels.h>
#include "test/origami/squares.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace shell_origami {

/// tan(22.5 degrees): where the bisector of the angle at a flap's tip meets its side.
constexpr double kBisector = 0.41421356237309503;

using Creases = std::vector<std::pair<Segment, double>>;  // angles in degrees

inline Landmark at(double x, double y) { return {Vector2(x * kSide, y * kSide)}; }
inline Segment line(double x, double y, double z, double w) {
  return {Vector2(x * kSide, y * kSide), Vector2(z * kSide, w * kSide)};
}

/// The angles that a paper's creases are asked for, those that are to be shut shut altogether.
inline std::vector<double> exactAngles(const Simulation& paper) {
  std::vector<double> angles;
  for (const CreaseStatus& crease : paper.creases()) {
    const double target = crease.target_angle;
    angles.push_back(std::abs(target) > 3 ? std::copysign(M_PI, target) : target);
  }
  return angles;
}

/// A square with rigid panels whose creases have these angles.
inline Simulation folded(const Creases& creases) {
  Simulation paper = square();
  for (const auto& [where, degrees] : creases) {
    FoldEdit fold;
    fold.where = where;
    fold.angle = degrees * kDegree;
    fold.duration = 0;
    paper.fold(fold);
  }
  std::vector<double> angles;
  for (const CreaseStatus& crease : paper.creases()) angles.push_back(crease.target_angle);
  return Simulation(paper.sheet(), {}, foldRigidly(paper.sheet(), exactAngles(paper)), angles);
}

/// The preliminary base, its cross valleys.
inline Creases preliminary() {
  return {{line(0, 0.5, 0.5, 0.5), 178}, {line(0.5, 0.5, 1, 0.5), 178},
          {line(0.5, 0, 0.5, 0.5), 178}, {line(0.5, 0.5, 0.5, 1), 178},
          {line(0, 1, 0.5, 0.5), -178},  {line(0.5, 0.5, 1, 0), -178}};
}

/// The square folded along both diagonals, a triangle of four layers.
inline Creases twiceAcross() {
  return {{line(0, 0, 0.5, 0.5), 178},
          {line(0.5, 0.5, 1, 1), 178},
          {line(0, 1, 0.5, 0.5), 178},
          {line(0.5, 0.5, 1, 0), -178}};
}

inline ManoeuvrePlan planOf(const Manoeuvre& manoeuvre, const Simulation& paper) {
  return planManoeuvre(manoeuvre, {}, frontOf(paper.sheet()), paper);
}

inline std::string refusal(const Manoeuvre& manoeuvre, const Simulation& paper) {
  try {
    planOf(manoeuvre, paper);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// The angle that a plan's result gives to a line [degrees]; 1000: it has no such line.
inline double angleAt(const ManoeuvrePlan& plan, const Segment& line) {
  for (const FoldEdit& fold : plan.result) {
    const Segment made = std::get<Segment>(fold.where);
    for (int k = 0; k < 2; ++k) {
      const double off = (made[k] - line[0]).norm() + (made[1 - k] - line[1]).norm();
      if (off < 1e-9) return fold.angle / kDegree;
    }
  }
  return 1000;
}

/// Whether the creases of the paper, as a plan leaves them, let it lie flat: panels close around
/// every vertex.
inline double closingErrorAfter(const ManoeuvrePlan& plan, const Simulation& before) {
  Simulation paper(before.snapshot());
  for (FoldEdit fold : plan.result) {
    fold.duration = 0;
    paper.fold(fold);
  }
  const std::vector<double> angles = exactAngles(paper);
  double worst = 0;
  for (int v : innerCreaseVertices(paper.sheet())) {
    worst = std::max(worst, closingError(paper.sheet(), v, angles));
  }
  return worst;
}

}  // namespace shell_origami
