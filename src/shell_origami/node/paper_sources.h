/// \file
/// Where the node's papers come from: parameters, a checkpoint, a recipe, a file.
#pragma once

#include <shell_origami/node/checkpoint.h>
#include <shell_origami/node/parameters.h>

#include <string>
#include <vector>

namespace shell_origami {

/// Returns the run of the checkpoint's file, or a new one of the parameters where there is none.
/// \throws std::exception with one sentence when there is no such recipe, sheet or checkpoint
Run beginRun(const NodeConfig& config, const Checkpoint& checkpoint);

/// Makes the paper of a recipe. What was changed to read its pattern is told in the log.
NewPaper paperOf(const Recipe& recipe);

/// Reads the paper of a crease pattern or a recipe.
/// \param scale  metres per unit of a crease pattern; 0: the unit that the file states
/// \param notes  takes a sentence for each thing that was changed to read the file
/// \throws std::invalid_argument with one sentence
NewPaper paperFromFile(const NodeConfig& config, const std::string& path, double scale,
                       std::vector<std::string>& notes);

}  // namespace shell_origami
