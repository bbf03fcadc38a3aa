/// \file
/// How hard layers press on each other.
#pragma once

#include <shell_origami/contact/contact_potential.h>

#include <vector>

namespace shell_origami {

/// The normal force between the two primitives of a pair.
struct ContactForce {
  std::array<int, 4> vertices;    ///< of the pair, in the order of PairPoints
  std::array<double, 4> weights;  ///< the share of each of them, as ClosestPoints has them
  Vector3 force;                  ///< on the first primitive [N]; on the second the opposite
  Vector3 point;                  ///< midway between the closest points [m]

  Vector3 on(int k) const { return weights[k] * force; }  ///< the k-th of the vertices [N]
};

/// Returns the force of each pair within its reach, in a fixed order. The couples of nearly
/// parallel edges, which have no resultant, and friction are left out.
std::vector<ContactForce> contactForces(const ContactPotential& contact, const Positions& x);

/// Returns the pressure at each vertex [Pa]: the normal force on it over a third of the flat area
/// of its triangles. Of its two sides the one under the larger force counts: a layer between two
/// others is pressed as much as these, although the forces on it cancel.
std::vector<double> contactPressures(const Sheet& sheet, const std::vector<ContactForce>& forces);

}  // namespace shell_origami
