#include <shell_origami/node/record/edit_messages.h>

#include <shell_origami/base/error.h>
#include <shell_origami/node/conversions.h>

#include <map>

namespace shell_origami {
namespace {

using Json = nlohmann::json;

const std::map<std::string, EditRecord::Kind>& kinds() {
  static const std::map<std::string, EditRecord::Kind> kKinds = {
      {msg::Edit::FOLD, EditRecord::kFold},
      {msg::Edit::PIN, EditRecord::kPin},
      {msg::Edit::UNPIN, EditRecord::kUnpin},
      {msg::Edit::CARRY, EditRecord::kCarry},
      {msg::Edit::ADD_VERTEX, EditRecord::kAddVertex},
      {msg::Edit::SETTLE, EditRecord::kSettle},
      {msg::Edit::STOP, EditRecord::kStop},
      {msg::Edit::CONFIGURE, EditRecord::kConfigure}};
  return kKinds;
}

std::string wordFor(EditRecord::Kind kind) {
  for (const auto& [word, known] : kinds()) {
    if (known == kind) return word;
  }
  return "";
}

}  // namespace

msg::Edit editMessage(const EditRecord& edit) {
  msg::Edit message;
  message.number = edit.number;
  message.step = edit.step;
  message.revision = edit.revision;
  message.kind = wordFor(edit.kind);
  message.crease = edit.crease;
  message.name = edit.name;
  for (const Vector2& p : edit.line) message.line.push_back(pointMessage({p.x(), p.y(), 0}));
  message.vertices = vertexIds(edit.vertices);
  message.angle = edit.angle;
  message.duration = edit.duration;
  message.stiffness = edit.stiffness;
  message.fraction = edit.fraction;
  message.gravity.x = edit.gravity.x();
  message.gravity.y = edit.gravity.y();
  message.gravity.z = edit.gravity.z();
  message.air_damping = edit.air_damping;
  message.frame_id = edit.frame;
  message.pose = poseMessage(edit.pose);
  return message;
}

EditRecord editRecord(const msg::Edit& message) {
  const auto kind = kinds().find(message.kind);
  if (kind == kinds().end()) reject("there is no edit of the kind \"", message.kind, "\"");
  EditRecord edit;
  edit.kind = kind->second;
  edit.number = message.number;
  edit.step = message.step;
  edit.revision = message.revision;
  edit.crease = message.crease;
  edit.name = message.name;
  for (const geometry_msgs::Point& p : message.line) edit.line.emplace_back(p.x, p.y);
  edit.vertices.assign(message.vertices.begin(), message.vertices.end());
  edit.angle = message.angle;
  edit.duration = message.duration;
  edit.stiffness = message.stiffness;
  edit.fraction = message.fraction;
  edit.gravity = {message.gravity.x, message.gravity.y, message.gravity.z};
  edit.air_damping = message.air_damping;
  edit.frame = message.frame_id;
  edit.pose = poseFrom(message.pose);
  return edit;
}

msg::Edit paperMessage(const Session& session, const std::string& kind, const std::string& path) {
  msg::Edit message;
  message.number = session.edits();
  message.step = session.steps();
  message.revision = session.revision();
  message.kind = kind;
  message.path = path;
  message.pose = poseMessage({});
  message.paper = Json::to_cbor(session.toJson());
  return message;
}

bool carriesPaper(const msg::Edit& message) {
  return message.kind == msg::Edit::PAPER || message.kind == msg::Edit::LOAD ||
         message.kind == msg::Edit::RESET;
}

Session paperFrom(const msg::Edit& message) {
  try {
    return Session(Json::from_cbor(message.paper));
  } catch (const Json::exception& error) {
    reject("edit ", message.number, " (", message.kind, ") holds no paper: ", error.what());
  }
}

}  // namespace shell_origami
