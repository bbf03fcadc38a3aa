#include <shell_origami/origami/manoeuvre.h>

namespace shell_origami {
namespace {

struct Plan {
  const ManoeuvreManner& manner;
  const Viewpoint& view;
  const Simulation& simulation;

  ManoeuvrePlan operator()(const PetalFold& petal) const {
    return planPetalFold(petal, manner, view, simulation);
  }
  ManoeuvrePlan operator()(const PleatFold& pleat) const {
    return planPleatFold(pleat, manner, view, simulation);
  }
  ManoeuvrePlan operator()(const RabbitEar& ear) const {
    return planRabbitEar(ear, manner, view, simulation);
  }
  ManoeuvrePlan operator()(const ReverseFold& reverse) const {
    return planReverseFold(reverse, manner, view, simulation);
  }
  ManoeuvrePlan operator()(const SquashFold& squash) const {
    return planSquashFold(squash, manner, view, simulation);
  }
};

struct LengthIs {
  double operator()(const PetalFold&) const { return 1.5; }
  double operator()(const PleatFold&) const { return 1.5; }
  double operator()(const RabbitEar&) const { return 1.5; }
  double operator()(const ReverseFold&) const { return 10; }
  double operator()(const SquashFold&) const { return 6; }
};

struct WordIs {
  const char* operator()(const PetalFold&) const { return "petal"; }
  const char* operator()(const PleatFold&) const { return "pleat"; }
  const char* operator()(const RabbitEar&) const { return "rabbit_ear"; }
  const char* operator()(const ReverseFold&) const { return "reverse"; }
  const char* operator()(const SquashFold&) const { return "squash"; }
};

}  // namespace

ManoeuvrePlan planManoeuvre(const Manoeuvre& manoeuvre, const ManoeuvreManner& manner,
                            const Viewpoint& view, const Simulation& simulation) {
  return std::visit(Plan{manner, view, simulation}, manoeuvre);
}

double lengthOf(const Manoeuvre& manoeuvre) { return std::visit(LengthIs{}, manoeuvre); }

const char* wordOf(const Manoeuvre& manoeuvre) { return std::visit(WordIs{}, manoeuvre); }

}  // namespace shell_origami
