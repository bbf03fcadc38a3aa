/// \file
/// The fold tool's drawing over the paper.
#pragma once

#include <shell_origami/rviz/plugin/ogre_conversions.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Ogre {
class ManualObject;
class SceneManager;
class SceneNode;
}  // namespace Ogre
namespace rviz {
class BillboardLine;
class Shape;
}  // namespace rviz

namespace shell_origami {

/// A line of a fold in space, in the color of its kind.
struct DrawnLine {
  enum class Kind { kMountain, kValley, kUnknown };
  std::array<Vector3, 2> ends;  ///< [m]
  Kind kind;
};

/// Draws in the paper's world frame, through the paper: lines on hidden layers show.
class FoldDrawing {
 public:
  explicit FoldDrawing(Ogre::SceneManager* manager);
  FoldDrawing(const FoldDrawing&) = delete;
  FoldDrawing& operator=(const FoldDrawing&) = delete;
  ~FoldDrawing();

  void place(const FramePose& world);
  /// \param size  of the sheet, to which widths are relative [m]
  void setSize(double size) { size_ = size; }
  void clear();
  /// Shows a ball where the pointer snaps to. \param firm  whether it snaps to anything
  void showPointer(const Vector3& point, bool firm);
  void hidePointer();
  void showLines(const std::vector<DrawnLine>& lines);
  /// \param corners  three for each triangle [m]
  void showGhost(const std::vector<Vector3>& corners);

 private:
  Ogre::SceneManager* manager_;
  Ogre::SceneNode* node_;
  std::unique_ptr<rviz::BillboardLine> lines_;
  std::unique_ptr<rviz::Shape> pointer_;
  Ogre::ManualObject* ghost_;
  std::string ghost_material_;
  double size_ = 1;
};

}  // namespace shell_origami
