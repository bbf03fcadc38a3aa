/// \file
/// Errors of the core: invalid input is rejected with a message that names the offending value.
#pragma once

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

}  // namespace shell_origami
