/// \file
/// Between the words of the core and the messages. All units are SI and radians on both sides.
#pragma once

#include "node/messages.h"
#include "node/paper.h"
#include "origami/simulation.h"

#include <std_msgs/Header.h>

#include <vector>

namespace shell_origami {

msg::Sheet sheetMessage(const Paper& paper, const std_msgs::Header& header);
msg::SheetState stateMessage(const Paper& paper, const std_msgs::Header& header);
msg::Energy energyMessage(const Paper& paper, const StepReport& step, double real_time_factor,
                          const std_msgs::Header& header);

/// \throws std::invalid_argument unless exactly one of crease, vertices and line is given, with
///         two finite ends.
FoldRequest foldRequest(const msg::Fold::Request& request);

/// What to pin. The ball's center is taken as it stands, whatever its frame.
/// \throws std::invalid_argument unless exactly one of vertices, points, region and center with
///         radius is given, with finite numbers.
PinWhere pinWhere(const msg::Pin::Request& request);

/// \throws std::invalid_argument unless its numbers are finite.
Vector3 clickedPoint(const geometry_msgs::PointStamped& click);
/// The vertex nearest to a point of the world.
msg::Picked pickedMessage(const Paper& paper, const Vector3& point, const std_msgs::Header& header);

/// The header is left open.
msg::Edit editMessage(const EditRecord& edit);

std::vector<std::uint32_t> vertexIds(const std::vector<int>& vertices);
std::vector<std::int64_t> vertexIds(const std::vector<std::uint32_t>& vertices);

}  // namespace shell_origami
