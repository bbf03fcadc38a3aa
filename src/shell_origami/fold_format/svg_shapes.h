/// \file
/// The shapes of an SVG drawing as polylines, and its transforms.
#pragma once

#include <shell_origami/base/geometry.h>

#include <tinyxml2.h>

#include <Eigen/Geometry>

#include <vector>

namespace shell_origami {

using Polyline = std::vector<Vector2>;

/// Returns the polylines of a <line>, <polyline>, <polygon>, <rect> or <path>; a closed one ends
/// where it begins. Empty for elements of other names.
/// Throws std::invalid_argument naming the element if its numbers are not in order, or its path is
/// curved or holds an unknown command.
std::vector<Polyline> polylinesOf(const tinyxml2::XMLElement& element);

/// Returns an element's transform attribute: matrix, translate, scale and rotate in a row.
/// Throws std::invalid_argument naming the element if it holds others or is not in order.
Eigen::Affine2d transformOf(const tinyxml2::XMLElement& element);

}  // namespace shell_origami
