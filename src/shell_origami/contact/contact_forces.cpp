#include <shell_origami/contact/contact_forces.h>

namespace shell_origami {
namespace {

/// Each vertex's third of its triangles [m^2].
std::vector<double> vertexAreas(const Sheet& sheet) {
  const std::vector<Vector2>& flat = sheet.flatPositions();
  std::vector<double> areas(flat.size(), 0);
  for (const Triangle& t : sheet.triangles()) {
    for (int v : t) areas[v] += doubleArea(flat[t[0]], flat[t[1]], flat[t[2]]) / 6;
  }
  return areas;
}

}  // namespace

std::vector<ContactForce> contactForces(const ContactPotential& contact, const Positions& x) {
  std::vector<ContactForce> forces;
  for (const Contact& touching : contact.contacts(x)) {
    const ContactPair& pair = touching.pair;
    const ClosestPoints& closest = touching.closest;
    Vector3 first = Vector3::Zero();
    for (int k = 0; k < firstSize(pair.kind); ++k) {
      first += closest.weights[k] * x.col(pair.vertices[k]);
    }
    forces.push_back({pair.vertices, closest.weights,
                      -contact.forceOf(touching) * closest.direction(),
                      first - closest.difference / 2});
  }
  return forces;
}

std::vector<double> contactPressures(const Sheet& sheet, const std::vector<ContactForce>& forces) {
  struct Load {
    double both_sides = 0;
    Vector3 resultant = Vector3::Zero();
  };
  std::vector<Load> loads(sheet.vertexCount());
  for (const ContactForce& force : forces) {
    for (int k = 0; k < 4; ++k) {
      // Those of bodies have numbers after the sheet's.
      if (force.vertices[k] >= sheet.vertexCount()) continue;
      Load& load = loads[force.vertices[k]];
      load.both_sides += force.on(k).norm();
      load.resultant += force.on(k);
    }
  }
  std::vector<double> pressures = vertexAreas(sheet);
  for (std::size_t v = 0; v < pressures.size(); ++v) {
    // The larger of two numbers by their sum and their difference.
    const double larger = (loads[v].both_sides + loads[v].resultant.norm()) / 2;
    pressures[v] = larger / pressures[v];
  }
  return pressures;
}

}  // namespace shell_origami
