/// \file
/// A sheet on a cylinder.
#pragma once

#include <shell_origami/sheet/sheet.h>

namespace shell_origami {

/// The vertices on a cylinder of a curvature [1/m], towards the front, whose rulings are
/// perpendicular to `direction` [rad from x].
Positions onCylinder(const Sheet& sheet, double curvature, double direction);

}  // namespace shell_origami
