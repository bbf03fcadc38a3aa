#include <shell_origami/origami/simulation.h>

#include <shell_origami/base/error.h>
#include <shell_origami/origami/named.h>

#include <utility>

namespace shell_origami {

void Simulation::remakeSprings() { springs_ = SpringPotential(grasps_.springs(0)); }

/// Puts the ends of the grasps' springs where they are a part s of the next step on.
void Simulation::moveSprings(double s) {
  const std::vector<Spring> springs = grasps_.springs(s);
  for (std::size_t i = 0; i < springs.size(); ++i) springs_.setPlace(i, springs[i].place);
}

GraspEdit Simulation::make(const GraspEdit& edit, EditRecord& record) {
  checkNewName("a grasp", edit.id);
  if (config_.solver.integrator == IntegratorKind::kSymplecticEuler) {
    reject("an explicit integrator steps no paper in a grasp");
  }
  checkFirmness(edit.firmness);
  checkPose(edit.pose);
  record.vertices = verticesAt(edit.where, sheet_, motion_.positions);
  const Pose pose = edit.frame.empty() ? Pose{} : edit.pose;
  grasps_.add(edit.id, {edit.firmness, edit.frame, pose, pose, {}}, record.vertices,
              motion_.positions);
  remakeSprings();
  pinsChanged();
  const std::vector<std::int64_t> numbers(record.vertices.begin(), record.vertices.end());
  return {edit.id, numbers, edit.firmness, edit.frame, pose};
}

ReleaseEdit Simulation::make(const ReleaseEdit& edit, EditRecord& record) {
  record.ids = namesOrAll(edit.ids, "grasp", grasps_.all());
  for (const std::string& id : record.ids) grasps_.remove(id);
  remakeSprings();
  pinsChanged();
  return {record.ids};
}

}  // namespace shell_origami
