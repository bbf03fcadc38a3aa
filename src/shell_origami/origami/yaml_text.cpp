#include <shell_origami/origami/yaml_text.h>

#include <shell_origami/origami/parameter.h>
#include <shell_origami/origami/recipe_reader.h>

#include <cstdlib>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

namespace shell_origami {

std::string numbers(const Vector2& p) {
  return "[" + numberText(p.x()) + ", " + numberText(p.y()) + "]";
}

std::string numbers(const Vector3& v) {
  return "[" + numberText(v.x()) + ", " + numberText(v.y()) + ", " + numberText(v.z()) + "]";
}

std::string points(const std::vector<Vector2>& places) {
  return list(places, [](const Vector2& p) { return numbers(p); });
}

std::string word(const std::string& text) {
  static const std::regex kPlain("[A-Za-z_][A-Za-z0-9_-]*");
  static const std::set<std::string> kOther{"null", "Null", "NULL"};
  if (std::regex_match(text, kPlain) && kOther.count(text) == 0) return text;
  std::string quoted;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    std::ostringstream code;
    if (c == '"' || c == '\\') code << '\\' << c;
    else if (byte < 0x20 || byte == 0x7f)
      code << "\\x"
           << "0123456789abcdef"[byte >> 4] << "0123456789abcdef"[byte & 15];
    else code << c;
    quoted += code.str();
  }
  return '"' + quoted + '"';
}

std::string degrees(double angle) {
  const double exact = angle / kDegree;
  std::string text;
  for (int digits = 3; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    std::ostringstream out;
    out.precision(digits);
    out << exact;
    text = out.str();
    if (std::strtod(text.c_str(), nullptr) * kDegree == angle) break;
  }
  return numberText(std::strtod(text.c_str(), nullptr));
}

}  // namespace shell_origami
