/// \file
/// Where a viewer's camera stands, and what it looks at.
#pragma once

#include <shell_origami/origami/recipe.h>

#include <optional>

namespace shell_origami {

/// A recipe's view, or one that shows a sheet of this size [m] where there is no recipe or it
/// states none.
View viewOf(const Recipe* recipe, double sheet_size);

bool same(const View& a, const View& b);

/// The camera's target, the middle of the paper. It stays where it is until the paper has
/// moved a part of its size away, and is then pulled along: folding does not move the picture, a
/// hand that drags paper is not dragged by it, and paper that falls stays in view.
class CameraTarget {
 public:
  /// \param size  of the flat sheet [m]
  const Vector3& follow(const Positions& positions, double size);
  /// Another paper takes the place of this one.
  void forget() { target_.reset(); }

 private:
  std::optional<Vector3> target_;
};

}  // namespace shell_origami
