/// \file
/// The paper as rviz shows it.
#pragma once

#include <shell_origami/node/draw/coloring.h>
#include <shell_origami/node/draw/labels.h>
#include <shell_origami/node/messages.h>

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace shell_origami {

/// Draws from the two messages alone, so that a live run and a recorded one look the same. Marker
/// ids stay the same from one drawing to the next.
class MarkerPainter {
 public:
  /// Of a contact point that has the strongest colour [N].
  static constexpr double kFullForce = 5e-3;

  MarkerPainter(const MarkerOptions& options, Coloring colouring)
      : labels_(options), colours_(colouring) {}

  void choose(const MarkerOptions& options, Coloring colouring);
  /// A sheet that names vertices it does not have is taken for none.
  void setSheet(const msg::Sheet& sheet);
  /// Whether the state belongs to the sheet that was set.
  bool fits(const msg::SheetState& state) const;
  /// Of the flat sheet [m].
  double size() const { return size_; }
  /// Whether it draws what states hold on demand only.
  bool showsPressures() const { return colours_.coloring() == Coloring::kContact; }
  bool showsContactPoints() const { return labels_.options().contact_points; }
  /// \pre fits(state)
  visualization_msgs::MarkerArray draw(const msg::SheetState& state);

 private:
  using Marker = visualization_msgs::Marker;
  using Points = Eigen::Matrix3Xd;

  Marker side(bool front, const Points& middle, const Points& normals,
              const std::vector<SheetColours::Sides>& colours) const;
  Marker creases(const std::vector<Points>& sides, const msg::SheetState& state) const;
  Marker border(const std::vector<Points>& sides) const;
  Marker held(const std::string& name, const Points& points,
              const std::vector<std::uint32_t>& vertices, const std_msgs::ColorRGBA& color) const;
  Marker contactPoints(const msg::SheetState& state) const;
  Points normals(const Points& points) const;

  double ground(const Points& points, const msg::SheetState& state) const;

  Labels labels_;
  msg::Sheet sheet_;
  SheetColours colours_;
  std_msgs::Header header_;  ///< of the markers; without a sequence number, which live differs
  std::vector<std::array<std::uint32_t, 2>> border_;
  std::vector<bool> on_crease_;  ///< for each vertex
  double size_ = 0;              ///< of the flat sheet [m]
};

}  // namespace shell_origami
