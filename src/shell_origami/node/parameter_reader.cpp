#include <shell_origami/node/parameter_reader.h>

#include <shell_origami/base/error.h>

#include <cmath>
#include <iterator>
#include <sstream>

namespace shell_origami {
namespace {

using XmlRpc::XmlRpcValue;

void flatten(const std::string& name, XmlRpcValue& value,
             std::map<std::string, XmlRpcValue>& flat) {
  if (value.getType() != XmlRpcValue::TypeStruct) {
    flat[name] = value;
    return;
  }
  for (auto& entry : value) {
    flatten(name.empty() ? entry.first : name + "/" + entry.first, entry.second, flat);
  }
}

std::string text(const XmlRpcValue& value) {
  std::ostringstream out;
  if (value.getType() == XmlRpcValue::TypeString) {
    out << '"' << static_cast<const std::string&>(value) << '"';
  } else {
    value.write(out);
  }
  return out.str();
}

[[noreturn]] void rejectValue(const std::string& name, const XmlRpcValue& value,
                              const std::string& wanted) {
  reject("parameter ~", name, " is ", text(value), ", but must be ", wanted);
}

/// YAML 1.1, which rosparam reads, takes 1e-4 for a word.
bool looksLikeNumber(const XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeString) return false;
  std::istringstream in(static_cast<const std::string&>(value));
  double number;
  return (in >> number) && in.eof();
}

double number(const std::string& name, const XmlRpcValue& parameter, const XmlRpcValue& value) {
  if (looksLikeNumber(value)) {
    rejectValue(name, parameter, "a number without quotes (YAML wants 1.0e-4, not 1e-4)");
  }
  const bool integer = value.getType() == XmlRpcValue::TypeInt;
  if (!integer && value.getType() != XmlRpcValue::TypeDouble) {
    rejectValue(name, parameter, "a number");
  }
  const double result =
      integer ? static_cast<const int&>(value) : static_cast<const double&>(value);
  if (!std::isfinite(result)) rejectValue(name, parameter, "finite");
  return result;
}

}  // namespace

ParameterReader::ParameterReader(const ros::NodeHandle& node) {
  XmlRpcValue tree;
  if (node.getParam(node.getNamespace(), tree) && tree.getType() == XmlRpcValue::TypeStruct) {
    flatten("", tree, unread_);
  }
}

void ParameterReader::read(const std::string& name, const Place& place) {
  const auto found = unread_.find(name);
  if (found == unread_.end()) return;
  std::visit([&](const auto& value) { set(name, found->second, value); }, place);
  unread_.erase(found);
}

void ParameterReader::set(const std::string& name, Value& given, bool* value) const {
  if (given.getType() != Value::TypeBoolean) rejectValue(name, given, "true or false");
  *value = static_cast<bool&>(given);
}

void ParameterReader::set(const std::string& name, Value& given, int* value) const {
  const double result = number(name, given, given);
  if (result != std::floor(result) || std::abs(result) > 1e9) {
    rejectValue(name, given, "an integer");
  }
  *value = static_cast<int>(result);
}

void ParameterReader::set(const std::string& name, Value& given, double* value) const {
  *value = number(name, given, given);
}

void ParameterReader::set(const std::string& name, Value& given, std::string* value) const {
  if (given.getType() != Value::TypeString) rejectValue(name, given, "a string");
  *value = static_cast<std::string&>(given);
}

void ParameterReader::set(const std::string& name, Value& given, Vector3* value) const {
  if (given.getType() != Value::TypeArray || given.size() != 3) {
    rejectValue(name, given, "a list of three numbers");
  }
  for (int i = 0; i < 3; ++i) (*value)[i] = number(name, given, given[i]);
}

void ParameterReader::set(const std::string& name, Value& given, const Choice& choice) const {
  std::string word;
  set(name, given, &word);
  if (!choice.set(word)) rejectValue(name, given, choice.text());
}

void ParameterReader::ignore(const std::string& name) {
  unread_.erase(name);
  const std::string prefix = name + "/";
  for (auto entry = unread_.begin(); entry != unread_.end();) {
    const bool within = entry->first.compare(0, prefix.size(), prefix) == 0;
    entry = within ? unread_.erase(entry) : std::next(entry);
  }
}

void ParameterReader::rejectUnread() const {
  if (unread_.empty()) return;
  const auto& [name, value] = *unread_.begin();
  reject("parameter ~", name, " (", text(value),
         ") is not one of this node; config/origami.yaml lists them all");
}

}  // namespace shell_origami
