#include <shell_origami/origami/bounded_yaml.h>

#include <yaml-cpp/eventhandler.h>

#include <set>
#include <sstream>
#include <vector>

namespace shell_origami {
namespace {

constexpr std::size_t kDeepest = 32;  // a recipe's points lie six deep

/// Checks a document before it is loaded. yaml-cpp recurses once a level, before 0.7 without a
/// bound; it announces each level before it enters it, which is when it can be stopped. Of a key
/// that occurs twice it keeps one value silently.
class Guard : public YAML::EventHandler {
 public:
  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    enter(mark, false);
  }
  void OnSequenceEnd() override { levels_.pop_back(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    enter(mark, true);
  }
  void OnMapEnd() override { levels_.pop_back(); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { take(mark, nullptr); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { take(mark, nullptr); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                const std::string& value) override {
    take(mark, &value);
  }

 private:
  /// A list or map that is being read.
  struct Level {
    bool is_map;
    bool at_key = true;  ///< of a map: whether a key is next
    std::set<std::string> keys = {};
  };

  void enter(const YAML::Mark& mark, bool is_map) {
    take(mark, nullptr);
    if (levels_.size() == kDeepest) {
      throw YAML::ParserException(
          mark, "lists and maps nest deeper than " + std::to_string(kDeepest) + " levels");
    }
    levels_.push_back({is_map});
  }

  /// Takes a key, a value of a map, or an entry of a list.
  void take(const YAML::Mark& mark, const std::string* scalar) {
    if (++values_ > kMostYamlValues) {
      throw YAML::ParserException(
          mark, "it holds more than " + std::to_string(kMostYamlValues) + " values");
    }
    if (levels_.empty() || !levels_.back().is_map) return;
    Level& map = levels_.back();
    if (map.at_key && scalar && !map.keys.insert(*scalar).second) {
      throw YAML::ParserException(mark, "the key '" + *scalar + "' occurs twice in one map");
    }
    map.at_key = !map.at_key;
  }

  std::vector<Level> levels_;  ///< around what is next, the innermost last
  std::size_t values_ = 0;
};

}  // namespace

YAML::Node loadBoundedYaml(const std::string& text) {
  std::istringstream stream(text);
  Guard guard;
  YAML::Parser(stream).HandleNextDocument(guard);
  return YAML::Load(text);
}

}  // namespace shell_origami
