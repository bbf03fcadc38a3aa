/// \file
/// The paper as a plain triangle mesh, for other programs. Metres; counter-clockwise seen from
/// the flat sheet's upper side.
#pragma once

#include <shell_origami/base/geometry.h>

#include <string>
#include <vector>

namespace shell_origami {

/// Wavefront OBJ.
std::string objText(const Positions& positions, const std::vector<Triangle>& triangles);
/// Binary STL: little-endian, single precision.
std::string stlText(const Positions& positions, const std::vector<Triangle>& triangles);
/// PLY, ascii.
std::string plyText(const Positions& positions, const std::vector<Triangle>& triangles);

}  // namespace shell_origami
