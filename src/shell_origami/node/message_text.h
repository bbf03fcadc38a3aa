/// \file
/// Messages about bad input, which may be as long as a book.
#pragma once

#include <string>

namespace shell_origami {

/// The text on one line, and cut short in its middle where it is longer than a thousand bytes: a
/// refusal begins with what is wrong and ends with why. Letters stay whole.
std::string asMessageText(const std::string& text);

}  // namespace shell_origami
