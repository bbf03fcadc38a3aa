/// \file
/// Things of which each has a name.
#pragma once

#include <shell_origami/base/error.h>

#include <map>
#include <string>
#include <vector>

namespace shell_origami {

/// Returns the names that an edit gives, or where it gives none, those of all things.
/// \param what  that they are, such as "obstacle"
/// \throws std::invalid_argument for a name that none of them has
template <class Thing>
std::vector<std::string> namesOrAll(const std::vector<std::string>& names, const char* what,
                                    const std::map<std::string, Thing>& all) {
  for (const std::string& name : names) {
    if (!all.count(name)) reject("there is no ", what, " '", name, "'");
  }
  if (!names.empty()) return names;
  std::vector<std::string> every;
  for (const auto& [name, thing] : all) every.push_back(name);
  return every;
}

}  // namespace shell_origami
