/// \file
/// Crease patterns in; papers out as FOLD files (github.com/edemaine/fold, specification 1.2).
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
  double scale = 0;  ///< metres per unit of the file; 0: the frame_unit that a FOLD file states
  /// Longest edge wanted [m]; 0: keep the file's own triangles, or where it has none, add no
  /// vertices. Files of our own keep their triangles where these are not much larger, too.
  double max_edge = 0;
  FoldForm form = FoldForm::kFolded;
  double width = 0;  ///< of the flat pattern along x [m], in the place of a scale; 0: by the scale
};

/// The angle to which a step of a folding sequence folds each crease of its sheet [rad]; NaN: it
/// leaves the crease as it is.
using FoldStage = std::vector<double>;

/// A paper as a file describes it.
struct FoldPaper {
  Sheet sheet;
  /// Positions in space: the file's last folded form of this pattern, unless it is folded flat (an
  /// edge beyond 179.9 degrees). A form at another scale than its pattern is scaled to the pattern.
  /// Vertices that the file does not have are at their place in its faces.
  std::optional<Positions> positions;
  /// Rest angle of each crease [rad]; NaN: a free crease. Empty without positions.
  std::vector<double> rest_angles;
  /// The steps of a folding sequence in their order; empty: the file is none.
  std::vector<FoldStage> stages;
  /// A sentence for each thing in the file that was changed or passed over to read it.
  std::vector<std::string> notes;
};

/// Reads a crease pattern. Creases are grouped into straight lines named crease_0, crease_1, ...
/// or as the file names them (our own files do). Their pattern_angle is what the file asks of them:
/// M and V in a file without fold angles ask for -pi and pi; null, and U with 0, for nothing. Cuts
/// with paper on both sides, and border edges that lie on each other, are slits and open. Edges of
/// a file without faces may cross and need no border (makePlanar). Throws std::invalid_argument
/// naming the file and the place.
FoldPaper readFold(const std::string& path, const FoldReadOptions& options = {});

/// Reads a crease pattern by the extension of its file: .cp and .opx as ORIPA writes them, .svg in
/// the colors of Origami Simulator, all others as readFold(). Drawings have no unit, so that they
/// need a scale or a width; the lower left corner is the origin.
/// Throws std::invalid_argument naming the file and the place.
FoldPaper readPatternFile(const std::string& path, const FoldReadOptions& options = {});

/// Whether a file is a FOLD file of the class "diagrams", a folding sequence.
/// Throws std::invalid_argument naming the file where it cannot be read.
bool isFoldSequence(const std::string& path);

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
