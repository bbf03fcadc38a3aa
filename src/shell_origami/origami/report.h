/// \file
/// What a run leaves behind: report.json, final.fold, final.obj.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace shell_origami {

/// The figures of a run, as interface names them.
nlohmann::json makeReport(const Simulation& simulation, const std::string& recipe,
                          double wall_time);

/// The paper as it is now as a FOLD document.
nlohmann::json foldDocument(const Simulation& simulation, const std::string& title);

/// The paper as it is now as a frame of a film (foldedFrame).
nlohmann::json foldFrame(const Simulation& simulation, int mesh_frame);

/// Writes the paper as it is now to .fold, .obj, .stl or .ply, by the path's extension. The file
/// is written beside and renamed, so that an error leaves an older one as it was.
/// \throws std::invalid_argument for another extension, std::runtime_error when it cannot be
/// written.
void savePaper(const Simulation& simulation, const std::string& path);

/// A text and where it belongs.
struct TextFile {
  std::string path;
  std::string text;
};

/// Writes texts the same careful way: all of them, before any takes the place of an older file.
/// \throws std::runtime_error naming path and reason
void writeFiles(const std::vector<TextFile>& files);

/// final.fold, final.obj and report.json, with `more` files named within the folder, into the
/// folder, which is made when it is missing.
void writeResults(const Simulation& simulation, const std::string& recipe, double wall_time,
                  const std::string& folder, std::vector<TextFile> more = {});

}  // namespace shell_origami
