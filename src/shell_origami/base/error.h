/// \file
/// How the core refuses what makes no sense: one sentence that names the offending value.
#pragma once

#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace shell_origami {

/// Joins the parts into a sentence. \throws std::invalid_argument always
template <class... Parts>
[[noreturn]] void reject(const Parts&... parts) {
  std::ostringstream sentence;
  (sentence << ... << parts);
  throw std::invalid_argument(sentence.str());
}

/// The words that may stand where another stood: "a or b".
template <class Value>
std::string alternatives(const std::map<std::string, Value>& choices) {
  std::string words;
  for (const auto& entry : choices) words += (words.empty() ? "" : " or ") + entry.first;
  return words;
}

}  // namespace shell_origami
