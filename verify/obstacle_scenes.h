/// \file
/// Scenes of paper among obstacles whose outcome has a closed form.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <string>

namespace shell_origami {

/// Returns the edit that puts an obstacle into the world.
AddObstacleEdit obstacle(const std::string& id, const ObstacleShape& shape, const Pose& pose = {},
                         double friction = 0.4);

/// Steps on. Throws std::runtime_error if a step does not converge, or paper crosses itself or an
/// obstacle.
void advance(Simulation& simulation, int steps);

/// Returns a square sheet, 0.15 m wide, that has fallen 2 cm onto the half space "table" below
/// z = 0, and rests there.
Simulation droppedSheet(double max_edge);

/// A sheet on a slope, 1.5 s after it was let go there.
struct Slide {
  double speed;         ///< down the slope [m/s]
  double acceleration;  ///< mean of the last second [m/s^2]
};

/// \param slope the angle of a half space [rad], on which the sheet begins at rest
Slide slideDown(double slope, double friction, double max_edge);

/// A strip that was pulled 2 mm out of two jaws.
struct Pull {
  double force;    ///< of the hand that pulls, in the last step [N]
  double pressed;  ///< sum of the normal forces of both jaws when that step began [N]
};

Pull pullOutOfJaws(double friction, double max_edge);

/// A strip at rest that hangs over an obstacle's edge across it. L is the length that would hang if
/// the strip lay flat.
struct HangingStrip {
  double row;          ///< height of its rows of triangles, over L
  double drop, reach;  ///< of the tip, down from the flat part and out from the edge, over L
  double bulge;        ///< of the part behind the edge, the largest height over L
};

/// A sheet between two jaws that end half way between two rows of vertices; no vertex is held. The
/// hinges of a row stand for the paper half a row to either side: it is clamped where jaws end.
/// \param rows number of rows of triangles before the jaws
HangingStrip hangFromJaws(double gamma, int rows);

/// A sheet on a smooth table, a box, over whose edge a part of it hangs. Its other end is held by
/// a box that lies on it, by friction; in between it is free to lift off.
HangingStrip hangOverEdge(double gamma, int rows);

}  // namespace shell_origami
