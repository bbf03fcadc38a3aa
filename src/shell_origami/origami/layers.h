/// \file
/// The layers of folded paper on the moving side of a fold's plane, as a viewer sees them.
#pragma once

#include <shell_origami/origami/fold_plane.h>
#include <shell_origami/origami/viewed_paper.h>

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <vector>

namespace shell_origami {

enum class FoldLayers {
  kAll,   ///< whatever is on the side that moves
  kTop,   ///< the layers nearest to the viewer
  kFlap,  ///< the flap that a landmark is on
};

class LayersBesidePlane {
 public:
  /// \param near  what passes the plane by less does not reach beyond it [m]
  LayersBesidePlane(const Sheet& sheet, const ViewedPaper& paper, const FoldPlane& plane,
                    double near);

  int panel(std::size_t triangle) const { return panels_[triangle]; }
  bool inFlap(std::size_t triangle) const { return flaps_[triangle] >= 0; }
  /// Whether its middle is on the side that moves.
  bool beyond(int triangle) const;
  /// Returns the cosine between a triangle's normal and the viewer: positive where its front shows.
  /// \throws std::invalid_argument where it stands on edge
  double facing(int triangle) const;
  /// Returns the angle of a crease through a triangle's layer at which the fold comes by an angle
  /// [rad] towards the viewer, or goes behind: a valley where its front faces that way.
  double turn(int triangle, double angle, bool behind) const;

  /// Returns of each triangle whether it moves: its flap is chosen. Flaps are the parts of the
  /// paper beyond the plane that are joined to each other there.
  /// \throws std::invalid_argument where nothing is there, or a chosen flap has layers that should
  /// stay
  std::vector<bool> chosen(FoldLayers layers, int count, const std::optional<Vector2>& flap) const;
  /// \throws std::invalid_argument where a layer that stays is in the way of one that moves
  void requireFree(const std::vector<bool>& moves, bool behind) const;
  /// Returns the same view of the paper at its largest triangle that stays or, where the fold cuts
  /// all of them, at the largest part of one.
  /// \throws std::invalid_argument where nothing stays
  Viewpoint viewOfRest(const std::vector<bool>& moves) const;

 private:
  /// A layer under a point, as the viewer sees it.
  struct Hit {
    double height;  ///< towards the viewer [m]
    int triangle;
  };
  std::vector<Hit> hitsAt(const Vector3& point) const;
  Vector2 seen(const Vector3& point) const {
    return {across_[0].dot(point), across_[1].dot(point)};
  }
  void findBoxes();
  std::vector<Hit> hitsAtMover() const;
  double cosine(int triangle) const;
  bool standsOnEdge(int triangle) const;
  void findFlaps();
  std::vector<Vector2> partThatStays(int triangle) const;
  Vector2 pointThatStays() const;
  void requireOnly(const std::vector<bool>& chosen, const std::vector<Hit>& hits,
                   std::size_t count) const;

  const Sheet& sheet_;
  const ViewedPaper& paper_;
  FoldPlane plane_;
  double near_;
  std::vector<int> panels_, flaps_;         ///< of each triangle; no flap: -1
  std::array<Vector3, 2> across_;           ///< the viewer's direction
  std::vector<Eigen::AlignedBox2d> boxes_;  ///< around each triangle as the viewer sees it
};

}  // namespace shell_origami
