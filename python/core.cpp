/// \file
/// The Python module shell_origami.core: a paper in the process of the program that folds it.
#include <shell_origami/origami/outcome.h>
#include <shell_origami/origami/recipe.h>
#include <shell_origami/origami/surface_file.h>

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <iomanip>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace shell_origami {
namespace {

using Parameters = std::map<std::string, py::object>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A step or a recipe that ended early. The paper is as it was before the step.
class SimulationError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// As the words of a recipe's parameters: Python's True is YAML's true.
Overrides overridesOf(const Parameters& parameters) {
  Overrides overrides;
  for (const auto& [name, value] : parameters) {
    std::string text = py::str(value);
    if (py::isinstance<py::bool_>(value)) text = value.cast<bool>() ? "true" : "false";
    overrides.emplace_back(name, std::move(text));
  }
  return overrides;
}

Rows rowsOf(const Positions& columns) { return columns.transpose(); }

/// Lets other threads of Python run meanwhile, and Ctrl-C through.
void takeStep(Simulation& paper) {
  StepReport report;
  {
    const py::gil_scoped_release released;
    report = paper.step();
  }
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!report.converged) throw SimulationError(report.failure);
}

Simulation makeSheet(double width, double height, double max_edge, const Parameters& parameters) {
  std::ostringstream text;
  text << std::setprecision(17) << "sheet: {size: [" << width << ", " << height
       << "], max_edge: " << max_edge << "}\nsteps: []\n";
  const Recipe recipe = readRecipe({"the sheet", "", text.str()}, {}, {}, overridesOf(parameters));
  return makeSimulation(recipe.sheet, recipe.config);
}

Simulation load(const std::string& path, double width, const Parameters& parameters) {
  SheetSource sheet;
  if (!isRecipe(path)) sheet.width = width;
  const Recipe recipe = loadRecipe(path, {}, sheet, overridesOf(parameters));
  return makeSimulation(recipe.sheet, recipe.config);
}

/// Carries out all steps of a recipe on a paper. Returns what it warned of.
std::vector<std::string> run(Simulation& paper, const std::string& path, const std::string& text) {
  if (path.empty() == text.empty()) throw std::invalid_argument("give one of path and text");
  RecipeRunner runner(path.empty() ? readRecipe({"text", "", text}, paper.config())
                                   : loadRecipe(path, paper.config()));
  std::vector<std::string> warnings;
  const auto gather = [&] {
    for (std::string& warning : runner.takeWarnings()) warnings.push_back(std::move(warning));
  };
  while (runner.update(paper)) {
    takeStep(paper);
    gather();
  }
  gather();
  return warnings;
}

struct FoldWords {
  std::vector<Vector2> line;
  std::string crease, name;
  double angle, part;
  std::optional<double> duration, stiffness;
};

std::vector<std::uint32_t> fold(Simulation& paper, const FoldWords& words) {
  if (words.line.empty() == words.crease.empty()) {
    throw std::invalid_argument("give one of line and crease");
  }
  FoldEdit edit;
  if (!words.crease.empty()) {
    edit.where = CreaseName{words.crease};
  } else if (words.line.size() == 2) {
    edit.where = Segment{words.line[0], words.line[1]};
  } else {
    throw std::invalid_argument("line has " + std::to_string(words.line.size()) + " points, not 2");
  }
  edit.angle = words.angle;
  edit.part = words.part;
  edit.duration = words.duration;
  edit.stiffness = words.stiffness;
  edit.name = words.name;
  return paper.fold(edit).crease_ids;
}

/// Vertices by their numbers, or those nearest to flat points.
PinWhere whereOf(const std::vector<std::int64_t>& vertices, const std::vector<Vector2>& points) {
  if (vertices.empty() == points.empty()) {
    throw std::invalid_argument("give one of vertices and points");
  }
  if (points.empty()) return vertices;
  return points;
}

/// gcc 12 warns of pybind11's own caster of Eigen's small vectors.
using Triple = std::array<double, 3>;

Pose poseOf(const Triple& position, const std::array<double, 4>& orientation) {
  const auto& [x, y, z, w] = orientation;
  return {Vector3(position.data()), Eigen::Quaterniond(w, x, y, z)};
}

struct ShapeWords {
  bool plane;
  std::optional<Triple> box;
  std::optional<double> sphere;
  std::optional<std::array<double, 2>> cylinder;
  std::string mesh;
};

ObstacleShape shapeOf(const ShapeWords& words) {
  std::vector<ObstacleShape> shapes;
  if (words.plane) shapes.emplace_back(HalfSpace{});
  if (words.box) shapes.emplace_back(Box{Vector3(words.box->data())});
  if (words.sphere) shapes.emplace_back(Sphere{*words.sphere});
  if (words.cylinder) shapes.emplace_back(Cylinder{(*words.cylinder)[0], (*words.cylinder)[1]});
  if (!words.mesh.empty()) {
    const Vector3 scale = Vector3::Ones();
    shapes.emplace_back(MeshShape{std::make_shared<const Surface>(readSurface(words.mesh, scale)),
                                  words.mesh, scale});
  }
  if (shapes.size() != 1) {
    throw std::invalid_argument("give one of plane, box, sphere, cylinder and mesh");
  }
  return shapes[0];
}

py::dict wrenchesOf(const Simulation& paper) {
  py::dict wrenches;
  for (const auto& [id, wrench] : paper.obstacleWrenches()) {
    wrenches[py::str(id)] = py::make_tuple(wrench.force, wrench.torque);
  }
  return wrenches;
}

py::bytes snapshotBytes(const Simulation& paper) {
  std::string bytes;
  nlohmann::json::to_cbor(toJson(paper.snapshot()), bytes);
  return bytes;
}

Simulation simulationOf(const std::string& bytes) {
  try {
    return Simulation(snapshotFrom(nlohmann::json::from_cbor(bytes)));
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(std::string("the bytes are of no paper: ") + error.what());
  }
}

py::list creasesOf(const Simulation& paper) {
  py::list creases;
  for (const CreaseStatus& crease : paper.creases()) {
    creases.append(
        py::dict(py::arg("id") = crease.id, py::arg("name") = crease.name,
                 py::arg("angle") = crease.angle, py::arg("rest_angle") = crease.rest_angle,
                 py::arg("target_angle") = crease.target_angle, py::arg("moment") = crease.moment));
  }
  return creases;
}

using Orientation = std::array<double, 4>;
constexpr Orientation kUnturned{0, 0, 0, 1};

void defineEdits(py::class_<Simulation>& paper) {
  paper.def(
      "fold",
      [](Simulation& self, std::vector<Vector2> line, std::string crease, double angle, double part,
         std::optional<double> duration, std::optional<double> stiffness, std::string name) {
        return fold(self, {std::move(line), std::move(crease), std::move(name), angle, part,
                           duration, stiffness});
      },
      "Folds along a line of two flat points [m], or a crease or group of creases by its name, to "
      "an angle [rad] or a part of the pattern's, within a duration [s]. Returns the creases' ids.",
      py::arg("line") = std::vector<Vector2>(), py::arg("crease") = "", py::arg("angle") = 0.0,
      py::arg("part") = 0.0, py::arg("duration") = py::none(), py::arg("stiffness") = py::none(),
      py::arg("name") = "");
  paper.def(
      "pin",
      [](Simulation& self, const std::vector<std::int64_t>& vertices,
         const std::vector<Vector2>& points, const std::string& frame, const Triple& position,
         const Orientation& orientation) {
        return self.apply(PinEdit{whereOf(vertices, points), frame, poseOf(position, orientation)})
            .vertices;
      },
      "Holds vertices where they are: by number, or nearest to flat points [m]. With a frame, "
      "which is at a pose now, they follow it: see carry(). Returns them.",
      py::arg("vertices") = std::vector<std::int64_t>(), py::arg("points") = std::vector<Vector2>(),
      py::arg("frame") = "", py::arg("position") = Triple{0, 0, 0},
      py::arg("orientation") = kUnturned);
  paper.def(
      "carry",
      [](Simulation& self, const std::string& frame, const Triple& position,
         const Orientation& orientation) { self.carry(frame, poseOf(position, orientation)); },
      "Moves a frame to a pose within the next step, with the vertices, grasps and obstacles that "
      "it carries. The orientation is a quaternion (x, y, z, w).",
      py::arg("frame"), py::arg("position"), py::arg("orientation") = kUnturned);
  paper.def(
      "unpin",
      [](Simulation& self, const std::vector<std::int64_t>& vertices) {
        return vertices.empty() ? self.unpin() : self.unpin(PinWhere(vertices));
      },
      "Lets go of vertices; of all where none is given. Returns them.",
      py::arg("vertices") = std::vector<std::int64_t>());
  paper.def("add_vertex", &Simulation::addVertex,
            "Adds a vertex on the edge between two, at a fraction of its length. Returns it.",
            py::arg("a"), py::arg("b"), py::arg("fraction"));
  paper.def(
      "settle",
      [](Simulation& self) {
        const StepReport report = self.settle();
        if (!report.converged) throw SimulationError(report.failure);
      },
      "Moves the paper to equilibrium at once.", py::call_guard<py::gil_scoped_release>());
}

void defineObstacles(py::class_<Simulation>& paper) {
  paper.def(
      "add_obstacle",
      [](Simulation& self, const std::string& id, bool plane, std::optional<Triple> box,
         std::optional<double> sphere, std::optional<std::array<double, 2>> cylinder,
         const std::string& mesh, const Triple& position, const Orientation& orientation,
         std::optional<double> friction, const std::string& frame) {
        // A frame that carries an obstacle is where the obstacle is.
        const Pose pose = poseOf(position, orientation);
        self.apply(AddObstacleEdit{id, shapeOf({plane, box, sphere, cylinder, mesh}),
                                   frame.empty() ? pose : Pose{}, friction, frame, pose});
      },
      "Puts a rigid body beside the paper: the half space below the plane z = 0 of its pose, a box "
      "of a size, a sphere of a radius, a cylinder of (radius, length) about its z axis, or the "
      "mesh of a file [m]. The orientation is a quaternion (x, y, z, w). A frame of the same pose "
      "carries it: see carry().",
      py::arg("id"), py::arg("plane") = false, py::arg("box") = py::none(),
      py::arg("sphere") = py::none(), py::arg("cylinder") = py::none(), py::arg("mesh") = "",
      py::arg("position") = Triple{0, 0, 0}, py::arg("orientation") = kUnturned,
      py::arg("friction") = py::none(), py::arg("frame") = "");
  paper.def(
      "move_obstacle",
      [](Simulation& self, const std::string& id, const Triple& position,
         const Orientation& orientation, double duration) {
        self.apply(MoveObstacleEdit{id, poseOf(position, orientation), duration});
      },
      "Moves an obstacle to a pose within a duration [s], at a constant speed.", py::arg("id"),
      py::arg("position"), py::arg("orientation") = kUnturned, py::arg("duration") = 1.0);
  paper.def(
      "remove_obstacles",
      [](Simulation& self, const std::vector<std::string>& ids) {
        return self.apply(RemoveObstacleEdit{ids}).ids;
      },
      "Takes obstacles away; all where none is named. Returns their names.",
      py::arg("ids") = std::vector<std::string>());
  paper.def(
      "grasp",
      [](Simulation& self, const std::string& id, const std::vector<std::int64_t>& vertices,
         const std::vector<Vector2>& points, double stiffness, double max_force, double reach,
         const std::string& frame, const Triple& position, const Orientation& orientation) {
        return self
            .apply(GraspEdit{id,
                             whereOf(vertices, points),
                             {stiffness, max_force, reach},
                             frame,
                             poseOf(position, orientation)})
            .vertices;
      },
      "Holds vertices softly where they are: by springs of a stiffness [N/m] up to a force [N], of "
      "all of them together; beyond it they slip, and farther than `reach` [m] they are lost. With "
      "a frame, which is at a pose now, they follow it: see carry().",
      py::arg("id"), py::arg("vertices") = std::vector<std::int64_t>(),
      py::arg("points") = std::vector<Vector2>(), py::arg("stiffness") = Firmness().stiffness,
      py::arg("max_force") = Firmness().max_force, py::arg("reach") = Firmness().reach,
      py::arg("frame") = "", py::arg("position") = Triple{0, 0, 0},
      py::arg("orientation") = kUnturned);
  paper.def(
      "release",
      [](Simulation& self, const std::vector<std::string>& ids) {
        return self.apply(ReleaseEdit{ids}).ids;
      },
      "Ends grasps; all where none is named. Returns their names.",
      py::arg("ids") = std::vector<std::string>());
  paper.def_property_readonly(
      "wrenches", &wrenchesOf,
      "Force [N] and torque about the origin [N*m] of the paper on each obstacle.");
  paper.def_property_readonly(
      "stopped",
      [](const Simulation& self) {
        return self.stopped() ? self.stopped()->ids : std::vector<std::string>();
      },
      "Obstacles that paper slowed down or stopped in the last step.");
}

void defineTime(py::class_<Simulation>& paper) {
  paper.def(
      "step",
      [](Simulation& self, int steps) {
        if (steps < 0) throw std::invalid_argument("steps is " + std::to_string(steps));
        for (int i = 0; i < steps; ++i) takeStep(self);
      },
      "Lets so many time steps pass. Raises SimulationError where one does not converge.",
      py::arg("steps") = 1);
  paper.def("run", &run,
            "Carries out all steps of a recipe, by its path or its text, on this paper. Its sheet "
            "and parameters are passed over. Returns what it warned of.",
            py::arg("path") = "", py::arg("text") = "");
  paper.def("snapshot", &snapshotBytes, "All of the paper, to the bit.");
  paper.def(
      "restore", [](Simulation& self, const py::bytes& bytes) { self = simulationOf(bytes); },
      "Makes the paper again as it was at a snapshot.", py::arg("snapshot"));
  paper.def(py::pickle(&snapshotBytes, [](const py::bytes& bytes) { return simulationOf(bytes); }));
}

void defineState(py::class_<Simulation>& paper) {
  paper.def_property_readonly("time", &Simulation::time, "[s]");
  paper.def_property_readonly(
      "time_step", [](const Simulation& self) { return self.config().solver.time_step; }, "[s]");
  paper.def_property_readonly("settled", &Simulation::settled,
                              "Whether all folds are done and "
                              "nothing moves any more.");
  paper.def_property_readonly("folding", &Simulation::folding);
  paper.def_property_readonly(
      "positions", [](const Simulation& self) { return rowsOf(self.positions()); },
      "Of the vertices in space, one row each [m]: a copy.");
  paper.def_property_readonly(
      "velocities", [](const Simulation& self) { return rowsOf(self.velocities()); }, "[m/s]");
  paper.def_property_readonly(
      "flat_positions",
      [](const Simulation& self) {
        const auto& flat = self.sheet().flatPositions();
        Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> rows(flat.size(), 2);
        for (std::size_t i = 0; i < flat.size(); ++i) rows.row(i) = flat[i];
        return rows;
      },
      "Of the vertices on the flat sheet, one row each [m].");
  paper.def_property_readonly(
      "triangles",
      [](const Simulation& self) {
        const auto& triangles = self.sheet().triangles();
        Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> rows(triangles.size(), 3);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
          for (int k = 0; k < 3; ++k) rows(i, k) = triangles[i][k];
        }
        return rows;
      },
      "Vertices of each triangle, counter-clockwise seen from the front, one row each.");
  paper.def_property_readonly("creases", &creasesOf, "A dict for each piece of a crease.");
  paper.def_property_readonly("pinned", [](const Simulation& self) {
    return std::vector<int>(self.pinned().begin(), self.pinned().end());
  });
  paper.def_property_readonly("max_strain",
                              [](const Simulation& self) { return self.maxStrain(); });
  paper.def_property_readonly(
      "energies",
      [](const Simulation& self) {
        const Energies e = self.energies();
        return py::dict(py::arg("membrane") = e.membrane, py::arg("bending") = e.bending,
                        py::arg("kinetic") = e.kinetic, py::arg("gravity") = e.gravity,
                        py::arg("contact") = e.contact);
      },
      "[J]");
  paper.def(
      "crossings", [](const Simulation& self) { return self.crossings().size(); },
      "Counts the pairs of triangles that pass through each other.");
  paper.def(
      "shortfalls", [](const Simulation& self) { return shortfalls(self); },
      "A sentence for each thing that is not as it was asked for.");
}

}  // namespace
}  // namespace shell_origami

PYBIND11_MODULE(core, module) {
  using namespace shell_origami;
  module.doc() =
      "A paper in this process, without a node. Same calls, same bits. SI units, radians.";
  py::register_exception<SimulationError>(module, "SimulationError", PyExc_RuntimeError);
  py::class_<Simulation> paper(module, "Simulation",
                               "A sheet of paper. Edits raise ValueError with the value that is "
                               "wrong, and then have changed nothing.");
  paper.def(py::init(&makeSheet), py::arg("width") = 0.15, py::arg("height") = 0.15,
            py::arg("max_edge") = 0.01, py::arg("parameters") = Parameters(),
            "A flat sheet [m]; parameters by their names, as {'material/thickness': 2e-4}.");
  defineEdits(paper);
  defineObstacles(paper);
  defineTime(paper);
  defineState(paper);
  module.def("load", &load,
             "The paper of a recipe's sheet or of a crease pattern, `width` wide [m].",
             py::arg("path"), py::arg("width") = 0.0, py::arg("parameters") = Parameters());
}
