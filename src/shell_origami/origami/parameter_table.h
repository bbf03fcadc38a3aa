/// \file
/// The parameters of the paper and of its simulation: the one list that the node, recipes,
/// snapshots, checks and the tests of the documentation read.
#pragma once

#include <shell_origami/origami/config.h>
#include <shell_origami/origami/parameter.h>
#include <shell_origami/origami/sheet_source.h>

#include <string>

namespace shell_origami {

/// Those of a rectangle.
const ParameterTable<SheetSource>& sheetParameters();

const ParameterTable<SimulationConfig>& simulationParameters();

/// Returns the bounds of a parameter of a simulation, such as material/thickness.
/// \pre there is one of this name
const Bounds& boundsOf(const std::string& name);

}  // namespace shell_origami
