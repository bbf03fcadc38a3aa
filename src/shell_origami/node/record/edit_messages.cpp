#include <shell_origami/node/record/edit_messages.h>

#include <shell_origami/base/bounded_json.h>
#include <shell_origami/base/error.h>
#include <shell_origami/node/conversions.h>
#include <shell_origami/origami/obstacle_json.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace shell_origami {
namespace {

using Json = nlohmann::json;

// Each kind of edit is one function below, which names its fields in the edit and in the message
// side by side and passes the pairs to `link`, and one row of kKinds. `link` copies one way or the
// other.

Vector3 vectorFrom(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

geometry_msgs::Vector3 vectorMessage(const Vector3& v) {
  geometry_msgs::Vector3 message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

struct IntoMessage {
  template <class Value>
  void operator()(const Value& value, Value& field) const {
    field = value;
  }
  void operator()(const std::optional<double>& value, double& field) const { field = *value; }
  void operator()(const Vector3& value, geometry_msgs::Vector3& field) const {
    field = vectorMessage(value);
  }
  void operator()(const Pose& value, geometry_msgs::Pose& field) const {
    field = poseMessage(value);
  }
  /// Records name vertices by their numbers.
  void operator()(const PinWhere& value, std::vector<std::uint32_t>& field) const {
    const auto& vertices = std::get<std::vector<std::int64_t>>(value);
    field.assign(vertices.begin(), vertices.end());
  }
  void operator()(const std::optional<PinWhere>& value, std::vector<std::uint32_t>& field) const {
    if (value) operator()(*value, field);
  }
  void operator()(const std::array<std::int64_t, 2>& value,
                  std::vector<std::uint32_t>& field) const {
    field.assign(value.begin(), value.end());
  }
  void operator()(const std::string& value, std::vector<std::string>& field) const {
    field = {value};
  }
  void operator()(const ObstacleShape& value, std::vector<std::uint8_t>& field) const {
    field = Json::to_cbor(toJson(value));
  }
  /// Records name two vertices by the line between them.
  void operator()(const decltype(FoldEdit::where)& value, std::string& crease,
                  std::vector<geometry_msgs::Point>& line) const {
    if (const auto* named = std::get_if<CreaseName>(&value)) {
      crease = named->name;
      return;
    }
    for (const Vector2& p : std::get<Segment>(value)) {
      line.push_back(pointMessage({p.x(), p.y(), 0}));
    }
  }
};

struct FromMessage {
  template <class Value>
  void operator()(Value& value, const Value& field) const {
    value = field;
  }
  void operator()(std::optional<double>& value, double field) const { value = field; }
  void operator()(Vector3& value, const geometry_msgs::Vector3& field) const {
    value = vectorFrom(field);
  }
  void operator()(Pose& value, const geometry_msgs::Pose& field) const { value = poseFrom(field); }
  void operator()(PinWhere& value, const std::vector<std::uint32_t>& field) const {
    value = vertexIds(field);
  }
  void operator()(std::optional<PinWhere>& value, const std::vector<std::uint32_t>& field) const {
    if (!field.empty()) value = vertexIds(field);
  }
  void operator()(std::array<std::int64_t, 2>& value,
                  const std::vector<std::uint32_t>& field) const {
    if (field.size() < 2) reject("a recorded edge has ", field.size(), " vertices, not two");
    value = {field[0], field[1]};
  }
  void operator()(std::string& value, const std::vector<std::string>& field) const {
    if (field.size() != 1) reject("an edit of ", field.size(), " ids, not of one");
    value = field[0];
  }
  void operator()(ObstacleShape& value, const std::vector<std::uint8_t>& field) const {
    try {
      value = shapeFrom(parseCbor(field));
    } catch (const Json::exception& error) {
      reject("a recorded obstacle has no shape: ", error.what());
    }
  }
  void operator()(decltype(FoldEdit::where)& value, const std::string& crease,
                  const std::vector<geometry_msgs::Point>& line) const {
    if (!crease.empty()) {
      value = CreaseName{crease};
      return;
    }
    if (line.size() != 2) reject("a recorded fold has ", line.size(), " ends, not two");
    value = Segment{Vector2(line[0].x, line[0].y), Vector2(line[1].x, line[1].y)};
  }
};

template <class Link, class Edit, class Message>
void linkFields(const Link& link, FoldEdit*, Edit& edit, Message& message) {
  link(edit.where, message.crease, message.line);
  link(edit.angle, message.angle);
  link(edit.part, message.part);
  link(edit.duration, message.duration);
  link(edit.stiffness, message.stiffness);
  link(edit.name, message.name);
}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, PinEdit*, Edit& edit, Message& message) {
  link(edit.where, message.vertices);
  link(edit.frame, message.frame_id);
  link(edit.pose, message.pose);
}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, UnpinEdit*, Edit& edit, Message& message) {
  link(edit.where, message.vertices);
}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, AddVertexEdit*, Edit& edit, Message& message) {
  link(edit.edge, message.vertices);
  link(edit.fraction, message.fraction);
}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, CarryEdit*, Edit& edit, Message& message) {
  link(edit.frame, message.frame_id);
  link(edit.pose, message.pose);
}

template <class Link, class Edit, class Message>
void linkFields(const Link&, SettleEdit*, Edit&, Message&) {}

template <class Link, class Edit, class Message>
void linkFields(const Link&, StopEdit*, Edit&, Message&) {}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, ConfigureEdit*, Edit& edit, Message& message) {
  link(edit.live.gravity, message.gravity);
  link(edit.live.air_damping, message.air_damping);
  link(edit.live.fold_duration, message.duration);
}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, AddObstacleEdit*, Edit& edit, Message& message) {
  link(edit.id, message.ids);
  link(edit.shape, message.shape);
  link(edit.pose, message.obstacle_pose);
  link(edit.friction, message.friction);
  link(edit.frame, message.frame_id);
  link(edit.frame_pose, message.pose);
}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, RemoveObstacleEdit*, Edit& edit, Message& message) {
  link(edit.ids, message.ids);
}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, MoveObstacleEdit*, Edit& edit, Message& message) {
  link(edit.id, message.ids);
  link(edit.pose, message.obstacle_pose);
  link(edit.duration, message.duration);
}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, GraspEdit*, Edit& edit, Message& message) {
  link(edit.id, message.ids);
  link(edit.where, message.vertices);
  link(edit.firmness.stiffness, message.stiffness);
  link(edit.firmness.max_force, message.max_force);
  link(edit.firmness.reach, message.reach);
  link(edit.frame, message.frame_id);
  link(edit.pose, message.pose);
}

template <class Link, class Edit, class Message>
void linkFields(const Link& link, ReleaseEdit*, Edit& edit, Message& message) {
  link(edit.ids, message.ids);
}

struct Kind {
  std::string name;
  void (*write)(const Edit& edit, msg::Edit& message);
  Edit (*read)(const msg::Edit& message);
};

template <class Struct>
Kind kind(const std::string& name) {
  return {name,
          [](const Edit& edit, msg::Edit& message) {
            const auto& fields = std::get<Struct>(edit);
            linkFields(IntoMessage(), static_cast<Struct*>(nullptr), fields, message);
          },
          [](const msg::Edit& message) -> Edit {
            Struct fields{};
            linkFields(FromMessage(), static_cast<Struct*>(nullptr), fields, message);
            return fields;
          }};
}

/// In the order of the variant.
const std::array<Kind, std::variant_size_v<Edit>>& kinds() {
  static const std::array<Kind, std::variant_size_v<Edit>> kKinds = {
      kind<FoldEdit>(msg::Edit::FOLD),
      kind<PinEdit>(msg::Edit::PIN),
      kind<UnpinEdit>(msg::Edit::UNPIN),
      kind<AddVertexEdit>(msg::Edit::ADD_VERTEX),
      kind<CarryEdit>(msg::Edit::CARRY),
      kind<SettleEdit>(msg::Edit::SETTLE),
      kind<StopEdit>(msg::Edit::STOP),
      kind<ConfigureEdit>(msg::Edit::CONFIGURE),
      kind<AddObstacleEdit>(msg::Edit::ADD_OBSTACLE),
      kind<RemoveObstacleEdit>(msg::Edit::REMOVE_OBSTACLE),
      kind<MoveObstacleEdit>(msg::Edit::MOVE_OBSTACLE),
      kind<GraspEdit>(msg::Edit::GRASP),
      kind<ReleaseEdit>(msg::Edit::RELEASE)};
  return kKinds;
}

}  // namespace

msg::Edit editMessage(const EditRecord& record) {
  msg::Edit message;
  message.number = record.number;
  message.step = record.step;
  message.revision = record.revision;
  message.pose = message.obstacle_pose = poseMessage({});
  const Kind& kind = kinds()[record.edit.index()];
  message.kind = kind.name;
  kind.write(record.edit, message);
  // Readers also get the vertices that a fold or a new vertex has made.
  const bool makes = std::holds_alternative<FoldEdit>(record.edit) ||
                     std::holds_alternative<AddVertexEdit>(record.edit);
  if (makes) {
    message.vertices.insert(message.vertices.end(), record.vertices.begin(), record.vertices.end());
  }
  return message;
}

Edit editFrom(const msg::Edit& message) {
  for (const Kind& kind : kinds()) {
    if (kind.name == message.kind) return kind.read(message);
  }
  reject("there is no edit of the kind \"", message.kind, "\"");
}

msg::Edit paperMessage(const Session& session, const std::string& kind, const std::string& path) {
  msg::Edit message;
  message.number = session.edits();
  message.step = session.steps();
  message.revision = session.revision();
  message.kind = kind;
  message.path = path;
  message.pose = message.obstacle_pose = poseMessage({});
  message.paper = Json::to_cbor(session.toJson());
  return message;
}

bool carriesPaper(const msg::Edit& message) {
  return message.kind == msg::Edit::PAPER || message.kind == msg::Edit::LOAD ||
         message.kind == msg::Edit::RESET || message.kind == msg::Edit::UNDO;
}

Session paperFrom(const msg::Edit& message) {
  try {
    return Session(parseCbor(message.paper));
  } catch (const std::exception& error) {
    reject("edit ", message.number, " (", message.kind, ") holds no paper: ", error.what());
  }
}

}  // namespace shell_origami
