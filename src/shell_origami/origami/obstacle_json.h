/// \file
/// Obstacles, grasps and poses as JSON.
#pragma once

#include <shell_origami/origami/grasps.h>
#include <shell_origami/origami/obstacles.h>

#include <nlohmann/json.hpp>

namespace shell_origami {

nlohmann::json toJson(const Pose& pose);
nlohmann::json toJson(const ObstacleShape& shape);
nlohmann::json toJson(const Obstacles& obstacles);
nlohmann::json toJson(const Grasps& grasps);

// Each throws std::invalid_argument or nlohmann::json::exception for anything else than what
// toJson() made.
Pose poseFrom(const nlohmann::json& json);
ObstacleShape shapeFrom(const nlohmann::json& json);
Obstacles obstaclesFrom(const nlohmann::json& json);
Grasps graspsFrom(const nlohmann::json& json, int vertex_count);

}  // namespace shell_origami
