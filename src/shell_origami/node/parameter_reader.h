/// \file
/// Reads the parameters of a namespace and remembers which of them nobody asked for.
#pragma once

#include <shell_origami/base/error.h>
#include <shell_origami/base/geometry.h>

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <algorithm>
#include <map>
#include <string>

namespace shell_origami {

/// Each read() leaves `value` alone when the parameter is not set.
/// \throws std::invalid_argument with one sentence that names the parameter and its value, when
///         the type is wrong or a number is not finite.
class ParameterReader {
 public:
  explicit ParameterReader(const ros::NodeHandle& node);

  void read(const std::string& name, bool& value);
  void read(const std::string& name, int& value);
  void read(const std::string& name, double& value);
  void read(const std::string& name, std::string& value);
  void read(const std::string& name, Vector3& value);

  /// Passes over every parameter of this folder.
  void ignore(const std::string& folder);

  /// \throws std::invalid_argument when a parameter is set that nobody has read.
  void rejectUnread() const;

 private:
  bool take(const std::string& name, XmlRpc::XmlRpcValue& value);

  std::map<std::string, XmlRpc::XmlRpcValue> unread_;
};

/// Reads a parameter that is one of a few words.
template <class Value>
void readChoice(ParameterReader& reader, const std::string& name,
                const std::map<std::string, Value>& choices, Value& value) {
  std::string word = std::find_if(choices.begin(), choices.end(), [&](const auto& entry) {
                       return entry.second == value;
                     })->first;
  reader.read(name, word);
  const auto found = choices.find(word);
  if (found == choices.end()) {
    reject("parameter ~", name, " is \"", word, "\", but must be ", alternatives(choices));
  }
  value = found->second;
}

}  // namespace shell_origami
