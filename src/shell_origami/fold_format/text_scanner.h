/// \file
/// Numbers and words in the text of a file.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace shell_origami {

/// Returns the number that a text is, in C's notation whatever the locale. Nothing if it is not
/// one, has other text around it, or is not finite.
std::optional<double> numberFrom(const std::string& text);

/// Returns the text without white space at its ends.
std::string trimmed(const std::string& text);

/// Reads numbers and letters one after the other, as in the attributes of SVG: separated by white
/// space and commas, or by nothing where a sign, a point or a letter begins the next one.
class TextScanner {
 public:
  explicit TextScanner(std::string text) : text_(std::move(text)) { skipSeparators(); }

  bool atEnd() const { return at_ == text_.size(); }
  /// The next character; a zero at the end.
  char peek() const { return atEnd() ? '\0' : text_[at_]; }
  /// Takes the next character. \pre not at the end
  char take();
  /// Takes a number. Nothing if there is none or it is not finite.
  std::optional<double> number();
  /// Takes letters as far as there are any.
  std::string word();
  /// Up to 20 characters from here on, for a message.
  std::string rest() const { return text_.substr(at_, 20); }

 private:
  void skipSeparators();

  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace shell_origami
