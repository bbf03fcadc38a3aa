/// \file
/// Cuts in the paper: slits, and the sides of them that fall apart.
#pragma once

#include <shell_origami/mesh/triangulate.h>

#include <array>
#include <vector>

namespace shell_origami {

/// Opens the mesh along the chains numbered `cuts`, which have paper on both sides. A vertex on
/// them is doubled where the fan of triangles around it falls apart; a slit's end inside the paper
/// is not. A slit of one edge gets a vertex in its middle, since its two ends alone keep it shut.
/// Vertices keep their indices, doubles and middles follow; the other chains run along the side
/// of the cut that they are on.
/// Returns for each vertex those before the cut that it lies midway between: mostly one, twice.
/// \throws std::invalid_argument when the paper falls into pieces
std::vector<std::array<int, 2>> openCuts(GraphMesh& mesh, const std::vector<std::size_t>& cuts);

}  // namespace shell_origami
