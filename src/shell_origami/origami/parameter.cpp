#include <shell_origami/origami/parameter.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <type_traits>

namespace shell_origami {
namespace {

void checkNumber(const std::string& name, double value, const std::string& shown,
                 const char* subject, const Bounds& bounds) {
  if (bounds.contain(value)) return;
  const std::string text = bounds.text();
  const bool infinite = std::isinf(bounds.high);
  reject(name, " is ", shown, ", but ", subject, "must be ", text,
         infinite ? (text.empty() ? "finite" : " and finite") : "");
}

std::string listText(const Vector3& values) {
  return "[" + numberText(values.x()) + ", " + numberText(values.y()) + ", " +
         numberText(values.z()) + "]";
}

}  // namespace

bool Bounds::contain(double value) const {
  if (!std::isfinite(value)) return false;
  if (or_zero && value == 0) return true;
  return (open ? value > low : value >= low) && value <= high;
}

std::string Bounds::text() const {
  if (std::isinf(low)) return "";
  if (std::isinf(high)) return (open ? "> " : ">= ") + numberText(low);
  return (or_zero ? "0 or from " : "from ") + numberText(low) + " to " + numberText(high);
}

std::string numberText(double value) {
  std::string text;
  for (int digits = 6; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    std::ostringstream out;
    out << std::setprecision(digits) << value;
    text = out.str();
    if (std::strtod(text.c_str(), nullptr) == value) break;
  }
  // 1e-09 and 1e+06 are written 1e-9 and 1e6.
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  return text.substr(0, exponent) + "e" + std::to_string(std::stoi(text.substr(exponent + 1)));
}

bool Choice::set(const std::string& word) const {
  if (std::find(words_.begin(), words_.end(), word) == words_.end()) return false;
  set_(word);
  return true;
}

std::string Choice::text() const {
  std::string text;
  for (const std::string& word : words_) text += (text.empty() ? "" : " or ") + word;
  return text;
}

void checkValue(const std::string& name, const Place& place, const Bounds& bounds) {
  if (const auto* number = std::get_if<double*>(&place)) {
    checkNumber(name, **number, numberText(**number), "", bounds);
  } else if (const auto* count = std::get_if<int*>(&place)) {
    checkNumber(name, **count, std::to_string(**count), "", bounds);
  } else if (const auto* list = std::get_if<Vector3*>(&place)) {
    const Vector3& values = **list;
    for (int i = 0; i < 3; ++i) {
      checkNumber(name, values[i], listText(values), "each of its numbers ", bounds);
    }
  }
}

}  // namespace shell_origami
