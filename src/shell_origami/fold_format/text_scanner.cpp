#include <shell_origami/fold_format/text_scanner.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>

namespace shell_origami {
namespace {

constexpr const char* kDigits = "0123456789";
constexpr const char* kSpace = " \t\r\n\f\v";

/// Returns the end of the number in a text that begins at `at`; `at` where there is none.
std::size_t endOfNumber(const std::string& text, std::size_t at) {
  const auto skip = [&text](std::size_t from, const char* characters) {
    return std::min(text.find_first_not_of(characters, from), text.size());
  };
  const std::size_t start = at;
  if (at < text.size() && std::strchr("+-", text[at])) ++at;
  const std::size_t whole = skip(at, kDigits);
  std::size_t digits = whole - at;
  at = whole;
  if (at < text.size() && text[at] == '.') {
    const std::size_t end = skip(at + 1, kDigits);
    digits += end - at - 1;
    at = end;
  }
  if (digits == 0) return start;
  if (at < text.size() && std::strchr("eE", text[at])) {
    std::size_t exponent = at + 1;
    if (exponent < text.size() && std::strchr("+-", text[exponent])) ++exponent;
    const std::size_t end = skip(exponent, kDigits);
    if (end > exponent) at = end;
  }
  return at;
}

}  // namespace

std::optional<double> numberFrom(const std::string& text) {
  if (text.empty() || endOfNumber(text, 0) != text.size()) return std::nullopt;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0;
  if (!(stream >> value) || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
}

char TextScanner::take() {
  const char next = text_[at_++];
  skipSeparators();
  return next;
}

std::optional<double> TextScanner::number() {
  const std::size_t end = endOfNumber(text_, at_);
  const std::optional<double> value = numberFrom(text_.substr(at_, end - at_));
  if (value) {
    at_ = end;
    skipSeparators();
  }
  return value;
}

std::string TextScanner::word() {
  const std::size_t start = at_;
  while (!atEnd() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  const std::string word = text_.substr(start, at_ - start);
  skipSeparators();
  return word;
}

void TextScanner::skipSeparators() {
  while (!atEnd() && (std::strchr(kSpace, text_[at_]) || text_[at_] == ',')) ++at_;
}

}  // namespace shell_origami
