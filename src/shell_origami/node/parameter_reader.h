/// \file
/// Reads the parameters of a namespace and remembers which of them nobody asked for.
#pragma once

#include <shell_origami/origami/parameter.h>

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <map>
#include <string>

namespace shell_origami {

/// Reads into places, and leaves those alone whose parameters are not set.
/// \throws std::invalid_argument that names the parameter and its value, when the type is wrong, a
///         number is not finite, or a word is not one of a choice's.
class ParameterReader {
 public:
  explicit ParameterReader(const ros::NodeHandle& node);

  void read(const std::string& name, const Place& place);

  /// Passes over the parameter of this name, or every one of the folder of this name.
  void ignore(const std::string& name);

  /// \throws std::invalid_argument when a parameter is set that nobody has read.
  void rejectUnread() const;

 private:
  using Value = XmlRpc::XmlRpcValue;
  void set(const std::string& name, Value& given, bool* value) const;
  void set(const std::string& name, Value& given, int* value) const;
  void set(const std::string& name, Value& given, double* value) const;
  void set(const std::string& name, Value& given, std::string* value) const;
  void set(const std::string& name, Value& given, Vector3* value) const;
  void set(const std::string& name, Value& given, const Choice& choice) const;

  std::map<std::string, Value> unread_;
};

}  // namespace shell_origami
