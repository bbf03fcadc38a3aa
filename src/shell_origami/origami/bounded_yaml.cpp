#include <shell_origami/origami/bounded_yaml.h>

#include <yaml-cpp/eventhandler.h>

#include <sstream>

namespace shell_origami {
namespace {

constexpr int kDeepest = 32;  // a recipe's points lie six deep

/// yaml-cpp calls itself once a level, and before 0.7 without a bound. It tells of each level
/// before it goes there, which is when it can be stopped.
class DepthGuard : public YAML::EventHandler {
 public:
  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    enter(mark);
  }
  void OnSequenceEnd() override { --depth_; }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    enter(mark);
  }
  void OnMapEnd() override { --depth_; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}

 private:
  void enter(const YAML::Mark& mark) {
    if (++depth_ > kDeepest) {
      throw YAML::ParserException(
          mark, "lists and maps nest deeper than " + std::to_string(kDeepest) + " levels");
    }
  }

  int depth_ = 0;
};

}  // namespace

YAML::Node loadBoundedYaml(const std::string& text) {
  std::istringstream stream(text);
  DepthGuard guard;
  YAML::Parser(stream).HandleNextDocument(guard);
  return YAML::Load(text);
}

}  // namespace shell_origami
