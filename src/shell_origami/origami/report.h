/// \file
/// The results of a run: report.json, final.fold, final.obj.
#pragma once

#include <shell_origami/base/files.h>
#include <shell_origami/origami/simulation.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace shell_origami {

/// Data of a run that its paper does not hold.
struct RunRecord {
  std::string recipe;              ///< its name
  double wall_time = 0;            ///< [s]
  std::string failure = {};        ///< why it ended early; empty: it did not
  std::vector<int> timeouts = {};  ///< steps of the recipe that ended unsettled, 0-based
};

/// Returns the figures of a run by the names of doc/reference.md.
nlohmann::json makeReport(const Simulation& simulation, const RunRecord& run);

/// The paper as it is now as a FOLD document.
nlohmann::json foldDocument(const Simulation& simulation, const std::string& title);

/// The paper as it is now as a frame of a film (foldedFrame).
nlohmann::json foldFrame(const Simulation& simulation, int mesh_frame);

/// Writes the paper as it is now to .fold, .obj, .stl or .ply, by the path's extension. The file
/// is written beside and renamed, so that an error leaves an older one as it was.
/// \throws std::invalid_argument for another extension, std::runtime_error when it cannot be
/// written.
void savePaper(const Simulation& simulation, const std::string& path);

/// final.fold, final.obj and report.json, with `more` files named within the folder, into the
/// folder, which is made when it is missing.
void writeResults(const Simulation& simulation, const RunRecord& run, const std::string& folder,
                  std::vector<TextFile> more = {});

}  // namespace shell_origami
