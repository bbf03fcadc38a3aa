#include "node/recipe_run.h"

#include "origami/report.h"

#include <ros/console.h>

#include <utility>

namespace shell_origami {

RecipeRun::RecipeRun(Recipe recipe, std::string output)
    : runner_(std::move(recipe)), output_(std::move(output)) {}

bool RecipeRun::update(Simulation& simulation) {
  if (start_.isZero()) start_ = ros::SteadyTime::now();
  if (!runner_.update(simulation)) {
    finish(simulation);
    return false;
  }
  if (told_ != runner_.stepIndex()) {
    told_ = runner_.stepIndex();
    ROS_INFO("%s: step %d of %zu: %s", recipe().name.c_str(), told_ + 1, recipe().steps.size(),
             runner_.doing().c_str());
  }
  return true;
}

void RecipeRun::finish(const Simulation& simulation) const {
  const double wall_time = (ros::SteadyTime::now() - start_).toSec();
  ROS_INFO("%s: done after %.2f s of simulation, %.2f s elapsed", recipe().name.c_str(),
           simulation.time(), wall_time);
  if (output_.empty()) return;
  writeResults(simulation, recipe().name, wall_time, output_);
  ROS_INFO("%s: results are in %s", recipe().name.c_str(), output_.c_str());
}

}  // namespace shell_origami
