/// \file
/// FOLD files (github.com/edemaine/fold, specification 1.2): crease patterns in, papers out.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace shell_origami {

/// The form in which the paper of a file is loaded.
enum class FoldForm {
  kFolded,  ///< the last folded form of the pattern, where there is one that is not folded flat
  kFlat,    ///< flat, as the crease pattern lies
};

struct FoldReadOptions {
  double scale = 0;  ///< metres per unit of the file; 0: the frame_unit the file states
  /// Longest edge wanted [m]; 0: keep the file's own triangles, or where it has none, add no
  /// vertices. Files of our own keep their triangles where these are not much larger, too.
  double max_edge = 0;
  FoldForm form = FoldForm::kFolded;
};

/// A paper as a FOLD file describes it.
struct FoldPaper {
  Sheet sheet;
  /// Positions in space: the file's last folded form of this pattern, unless it is folded flat (an
  /// edge beyond 179.9 degrees). A form at another scale than its pattern is scaled to the pattern.
  /// Vertices that the file does not have are at their place in its faces.
  std::optional<Positions> positions;
  /// Rest angle of each crease [rad]; NaN: a free crease. Empty without positions.
  std::vector<double> rest_angles;
};

/// Reads a crease pattern. Creases are grouped into straight lines named crease_0, crease_1, ...
/// or as the file names them (our own files do). Their pattern_angle is what the file asks of them:
/// M and V in a file without fold angles ask for -pi and pi; null, and U with 0, for nothing. Cuts
/// with paper on both sides, and border edges that lie on each other, are slits and open.
/// \throws std::invalid_argument with one sentence that names the file and the place.
FoldPaper readFold(const std::string& path, const FoldReadOptions& options = {});

/// One crease as it is written.
struct FoldCrease {
  double angle = 0;       ///< now [rad]
  double rest_angle = 0;  ///< [rad]; NaN: a free crease
};

/// A FOLD document: the flat pattern as its key frame and the folded form as a frame that inherits
/// from it. edges_foldAngle of the key frame holds achieved angles, but of creases that no fold has
/// driven what their pattern asks for; the folded form then has angles of its own. In metres. The
/// sides of a slit are border edges that lie on each other, with vertices of their own.
nlohmann::json writeFold(const Sheet& sheet, const std::vector<FoldCrease>& creases,
                         const Positions& positions, const std::string& title);

/// A folded form at a time, to append to a document's file_frames, with its own fold angles. It
/// brings its mesh, or where `mesh_frame` > 0 inherits that of the frame with this number.
nlohmann::json foldedFrame(const Sheet& sheet, const std::vector<FoldCrease>& creases,
                           const Positions& positions, double time, int mesh_frame = 0);

/// The document as text, one line for each of its words.
std::string foldText(const nlohmann::json& document);

}  // namespace shell_origami
