/// \file
/// The place on the paper that a person means who points somewhere near it.
#pragma once

#include <shell_origami/rviz/camera.h>
#include <shell_origami/rviz/ray_caster.h>
#include <shell_origami/rviz/shown_paper.h>

#include <optional>
#include <string>

namespace shell_origami {

/// What a pointer snaps to; what stands first is preferred.
enum class SnapKind {
  kCorner,     ///< of the outline
  kVertex,     ///< where creases end, meet or turn
  kMiddle,     ///< of a crease or a side of the outline
  kCrossing,   ///< of a direction from the first point with a crease or the outline
  kPoint,      ///< a vertex of the mesh on a crease or the outline
  kCrease,     ///< anywhere on it
  kOutline,    ///< anywhere on it
  kDirection,  ///< a multiple of 22.5 degrees from the first point
  kFree,       ///< nothing
};

struct Spot {
  SnapKind kind = SnapKind::kFree;
  PaperPlace place;
  Vector2 flat = Vector2::Zero();  ///< [m] on the flat sheet
  int vertex = -1;                 ///< it, or the nearest corner of the place's triangle
  int crease = -1;                 ///< an index into Sheet::creases(); -1: it is on none
  double direction = 0;            ///< of kCrossing and kDirection [degrees, 0 to 360)
};

/// How near a pointer must be to snap to something [pixel].
constexpr double kSnapPixels = 10;
/// Of kPoint, whose vertices lie where the mesh has them.
constexpr double kPointPixels = 3;

/// Returns what a pointer means. Only places on the panel that it is on count. A pointer beside
/// the paper by less than kSnapPixels is taken to be on it.
/// \param from  the first point of a line, on the flat sheet [m]
/// \pre the caster follows the paper
std::optional<Spot> spotAt(const Vector2& pixel, const Camera& camera, const ShownPaper& paper,
                           const RayCaster& caster, const std::optional<Vector2>& from);

/// Returns the spot in words, as "corner (0.0, 150.0) mm".
std::string describe(const Spot& spot, const ShownPaper& paper);

}  // namespace shell_origami
