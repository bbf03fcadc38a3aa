#include <shell_origami/origami/parameter_table.h>

#include <algorithm>

namespace shell_origami {
namespace {

constexpr bool kLive = true;
constexpr Bounds kUnbounded{};  // of words, and of what is true or false

template <class Value>
std::function<Place(SimulationConfig&)> of(Value Material::*member) {
  return [member](SimulationConfig& config) { return Place(&(config.material.*member)); };
}

template <class Value>
std::function<Place(SimulationConfig&)> of(Value SolverConfig::*member) {
  return [member](SimulationConfig& config) { return Place(&(config.solver.*member)); };
}

template <class Owner, class Value>
std::function<Place(Owner&)> at(Value Owner::*member) {
  return [member](Owner& owner) { return Place(&(owner.*member)); };
}

Place membrane(SimulationConfig& config) {
  return Choice(membraneNames(), config.material.membrane);
}

Place compliantRegion(SimulationConfig& config) {
  return Choice(compliantRegionNames(), config.compliance.where);
}

Place integrator(SimulationConfig& config) {
  return Choice(integratorNames(), config.solver.integrator);
}

}  // namespace

const ParameterTable<SheetSource>& sheetParameters() {
  using Sheet = SheetSource;
  static const ParameterTable<Sheet> table{
      {"sheet/width", at(&Sheet::width),
       "of the rectangle along x, or of the pattern that `recipe` names", "m", kPositive},
      {"sheet/height", at(&Sheet::height), "of the rectangle along y", "m", kPositive},
      {"sheet/max_edge", at(&Sheet::max_edge), "longest edge of a triangle", "m", kPositive}};
  return table;
}

const ParameterTable<SimulationConfig>& simulationParameters() {
  using Config = SimulationConfig;
  static const ParameterTable<Config> table{
      {"material/youngs_modulus", of(&Material::youngs_modulus), "Young's modulus", "Pa",
       kPositive},
      {"material/poisson_ratio", of(&Material::poisson_ratio), "Poisson's ratio", "",
       between(0, 0.49)},
      {"material/thickness", of(&Material::thickness), "thickness of the paper", "m", kPositive},
      {"material/density", of(&Material::density), "mass per volume", "kg/m^3", kPositive},
      // A hundred is 20,000 times a paper's crease: beyond it the matrix of a step is too badly
      // conditioned to be factorized.
      {"material/crease_stiffness", of(&Material::crease_stiffness),
       "of a fold that states no stiffness", "N*m/rad per m of crease", between(1e-9, 100)},
      {"material/air_damping", of(&Material::air_damping), "damping proportional to mass", "1/s",
       between(0, 1e6), kLive},
      {"material/membrane", membrane, "how stretching costs energy", "", kUnbounded},
      {"material/crease_height_term", of(&Material::crease_height_term),
       "whether narrow triangles beside a crease stiffen it", "", kUnbounded},
      {"material/yield_curvature", of(&Material::yield_curvature),
       "curvature beyond which paper keeps part of the bend; 0: never", "1/m", between(0, 1e6)},
      {"material/hardening", of(&Material::hardening),
       "rise of the yield curvature per plastic curvature", "", between(-0.99, 1e6)},
      {"gravity", at(&Config::gravity), "acceleration of free fall", "m/s^2", between(-1e4, 1e4),
       kLive},
      {"solver/integrator", integrator, "scheme of a time step", "", kUnbounded},
      {"solver/time_step", of(&SolverConfig::time_step), "simulated time of a step", "s",
       between(1e-8, 1)},
      {"solver/beta",
       of(&SolverConfig::beta),
       "Newmark's beta; 0: (gamma + 1/2)^2 / 4",
       "",
       {1e-3, 1, false, true}},
      {"solver/gamma", of(&SolverConfig::gamma), "Newmark's gamma; above 0.5 it damps", "",
       between(0.5, 1)},
      {"solver/tolerance", of(&SolverConfig::tolerance),
       "largest Newton step of a vertex over the time step", "m/s", kPositive},
      {"solver/max_iterations", of(&SolverConfig::max_iterations),
       "Newton iterations before a step is cut in two", "", between(1, 1000)},
      {"solver/threads", of(&SolverConfig::threads),
       "that share the work of a step, for the same result; 0: one for each core", "",
       between(0, 1024)},
      {"fold_duration", at(&Config::fold_duration), "of a fold that states none", "s", kPositive,
       kLive},
      {"contact/enabled", [](Config& config) { return Place(&config.contact.enabled); },
       "whether paper cannot pass through itself", "", kUnbounded},
      {"contact/distance", [](Config& config) { return Place(&config.contact.distance); },
       "within which paper begins to push paper away", "m", between(1e-6, 1e-2)},
      {"contact/friction", [](Config& config) { return Place(&config.contact.friction); },
       "Coulomb's coefficient, paper on paper", "", between(0, 10)},
      {"compliance/factor",
       [](Config& config) { return Place(&config.compliance.factor); },
       "times that the membrane is softer while creases fold; 0: where a pattern needs it",
       "",
       {1, 1e6, false, true}},
      {"compliance/where", compliantRegion, "which triangles are softer", "", kUnbounded}};
  return table;
}

const Bounds& boundsOf(const std::string& name) {
  const auto& table = simulationParameters();
  return std::find_if(table.begin(), table.end(),
                      [&](const auto& parameter) { return parameter.name == name; })
      ->bounds;
}

}  // namespace shell_origami
