/// Folds a square along its diagonal by 90 degrees and reports the fold angle reached.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>

#include <cmath>
#include <cstdio>

int main() {
  using namespace shell_origami;
  Simulation paper(Sheet(triangulateRectangle(0.15, 0.15, 0.015)), SimulationConfig());
  FoldEdit fold;
  fold.where = Segment{Vector2(0, 0), Vector2(0.15, 0.15)};
  fold.angle = M_PI / 2;
  paper.fold(fold);
  while (!paper.settled() && paper.time() < 30) paper.step();
  const double angle = paper.creases()[0].angle;
  std::printf("folded to %.2f degrees after %.2f s\n", angle * 180 / M_PI, paper.time());
  return paper.settled() && std::abs(angle - fold.angle) < 0.1 ? 0 : 1;
}
