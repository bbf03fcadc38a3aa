#include <shell_origami/origami/recipe_reader.h>

#include <shell_origami/origami/bounded_yaml.h>

#include <cmath>
#include <variant>

namespace shell_origami {

void RecipeReader::readMap(const YAML::Node& node, const std::string& what,
                           const Handlers& handlers) const {
  if (!node.IsMap()) refuseAt(node, what, " must be a map of key: value");
  for (const auto& entry : node) {
    const std::string key = text(entry.first, what);
    const auto handler = handlers.find(key);
    if (handler == handlers.end()) refuseAt(entry.first, what, " knows no '", key, "'");
    handler->second(entry.second);
  }
}

std::string RecipeReader::text(const YAML::Node& node, const std::string& what) const {
  countValue();
  if (!node.IsScalar()) refuseAt(node, what, " must be a word");
  return node.Scalar();
}

double RecipeReader::number(const YAML::Node& node, const std::string& what) const {
  countValue();
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    refuseAt(node, what, " must be a finite number",
             node.IsScalar() ? ", not '" + node.Scalar() + "'" : "");
  }
  return value;
}

bool RecipeReader::truth(const YAML::Node& node, const std::string& what) const {
  bool value = false;
  if (!node.IsScalar() || !YAML::convert<bool>::decode(node, value)) {
    refuseAt(node, what, " must be true or false");
  }
  return value;
}

std::vector<double> RecipeReader::numbers(const YAML::Node& node, std::size_t count,
                                          const std::string& what) const {
  if (!node.IsSequence() || node.size() != count) {
    refuseAt(node, what, " must be a list of ", count, " numbers");
  }
  std::vector<double> values;
  for (const YAML::Node& entry : node) values.push_back(number(entry, what));
  return values;
}

std::vector<Vector2> RecipeReader::points(const YAML::Node& node, const std::string& what) const {
  if (!node.IsSequence() || node.size() == 0) {
    refuseAt(node, what, " must be a list of points [x, y]");
  }
  std::vector<Vector2> points;
  for (const YAML::Node& entry : node) {
    const std::vector<double> p = numbers(entry, 2, what);
    points.emplace_back(p[0], p[1]);
  }
  return points;
}

void RecipeReader::read(const YAML::Node& node, const std::string& what, double* value) const {
  *value = number(node, what);
}

void RecipeReader::read(const YAML::Node& node, const std::string& what, int* value) const {
  const double count = number(node, what);
  if (count != std::floor(count) || std::abs(count) > 1e9) {
    refuseAt(node, what, " must be an integer, not ", count);
  }
  *value = static_cast<int>(count);
}

void RecipeReader::read(const YAML::Node& node, const std::string& what, bool* value) const {
  *value = truth(node, what);
}

void RecipeReader::read(const YAML::Node& node, const std::string& what, std::string* value) const {
  *value = text(node, what);
}

void RecipeReader::read(const YAML::Node& node, const std::string& what, Vector3* value) const {
  const std::vector<double> list = numbers(node, 3, what);
  *value = {list[0], list[1], list[2]};
}

void RecipeReader::read(const YAML::Node& node, const std::string& what,
                        const Choice& choice) const {
  if (choice.set(text(node, what))) return;
  refuseAt(node, what, " must be ", choice.text(), ", not '", node.Scalar(), "'");
}

std::function<void(const YAML::Node&)> RecipeReader::into(const Place& place,
                                                          const std::string& what) const {
  return [this, place, what](const YAML::Node& node) {
    std::visit([&](const auto& value) { read(node, what, value); }, place);
  };
}

void RecipeReader::countValue() const {
  if (++values_ > kMostYamlValues)
    reject(file_, ": it holds more than ", kMostYamlValues, " values");
}

}  // namespace shell_origami
