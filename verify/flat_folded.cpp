/// Item 11: paper with fold angles of 180 degrees less d is O(d) away from the sheet reflected in
/// its creases.
#include <shell_origami/sheet/rigid_panels.h>
#include "verify/rigid_origami.h"
#include "verify/topics.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>

namespace shell_origami {
namespace {

const std::string kItem = "11 Flat-folded states";

/// The sheet with every crease folded to 180 degrees.
Positions foldedFlat(const Sheet& sheet) {
  return foldRigidly(sheet, std::vector<double>(sheet.creases().size(), M_PI));
}

/// Largest distance between points of two shapes after a rigid fit, over the size of the sheet.
double distance(const Positions& shape, const Positions& target, double size) {
  const Eigen::Affine3d fit(Eigen::umeyama(shape, target, false));
  return (fit * shape - target).colwise().norm().maxCoeff() / size;
}

struct Model {
  std::string name;
  std::vector<std::pair<std::string, double>> creases;  ///< those driven, with their signs
  std::function<Simulation()> make;
};

std::vector<Model> models() {
  const auto recipe = [](const char* name) { return [name] { return fromRecipe(name); }; };
  const auto vertex = [] {
    return Simulation(Degree4Vertex{60 * kDegree, 45 * kDegree, false}.sheet(), quasiStatic());
  };
  return {{"waterbomb base", {{"diagonal", 1}}, recipe("waterbomb")},
          {"preliminary base", {{"cross", 1}}, recipe("preliminary")},
          {"Miura-ori", {{"zigzag_valley", 1}, {"zigzag_mountain", -1}}, recipe("miura")},
          {"vertex of four creases", {{"rho0", 1}}, vertex}};
}

}  // namespace

void verifyFlatFolded(VerificationReport& report) {
  FigureData figure = report.figure("flat_folded", {"model", "d", "distance"});
  for (const Model& model : models()) {
    if (report.fast() && model.name == "Miura-ori") continue;
    Simulation simulation = model.make();
    const Positions target = foldedFlat(simulation.sheet());
    std::vector<double> distances;
    double miss = 0;  // [rad], of the crease that is farthest from 180 degrees
    for (const double d : {60.0, 20.0, 10.0, 5.0}) {
      foldAndRest(simulation, model.creases, (180 - d) * kDegree);
      miss = 0;
      for (const CreaseStatus& crease : simulation.creases()) {
        miss = std::max(miss, M_PI - std::abs(crease.angle));
      }
      distances.push_back(distance(simulation.positions(), target, simulation.sheet().size()));
      figure.row(model.name, {d, distances.back()});
    }
    report.add(
        {kItem, model.name + ": distance over the sheet's size, d = 5 degrees", 0, distances.back(),
         miss / 2,
         "half the angle, in radians, by which the farthest crease misses 180 degrees: layers "
         "reach half a sheet's size from the crease they turn about"});
    report.add({kItem, model.name + ": order of that distance in d", 1,
                std::log2(distances[2] / distances[3]), 0.03,
                "O(d), from d = 10 and 5 degrees; the other creases miss 180 degrees by tan(d / 2) "
                "times a factor, which adds terms of order d^3"});
  }
}

}  // namespace shell_origami
