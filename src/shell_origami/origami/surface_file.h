/// \file
/// Surfaces of obstacles from mesh files; assimp is used here alone.
#pragma once

#include <shell_origami/contact/surface.h>

#include <string>

namespace shell_origami {

/// Reads an STL, OBJ or Collada file, with its coordinates multiplied by `scale`. Corners with one
/// place are one vertex.
/// \throws std::invalid_argument with one sentence that names the file.
Surface readSurface(const std::string& path, const Vector3& scale);

}  // namespace shell_origami
