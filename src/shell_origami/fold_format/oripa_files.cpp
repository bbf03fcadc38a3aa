/// Crease patterns of ORIPA and the programs that follow it: .cp and .opx.
#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/line_drawing.h>
#include <shell_origami/fold_format/text_scanner.h>
#include <shell_origami/fold_format/xml.h>

#include <cmath>
#include <map>
#include <sstream>

namespace shell_origami {
namespace {

/// Of a line: its type, then x and y of both ends.
constexpr std::size_t kNumbers = 5;

void addLine(const std::vector<double>& numbers, const std::string& place, LineDrawing& drawing) {
  DrawnLine line{{numbers[1], numbers[2]}, {numbers[3], numbers[4]}, 'F', 0, place};
  const double type = numbers[0];
  if (type == 1) line.kind = 'B';
  else if (type == 2) line.kind = 'M', line.angle = -M_PI;
  else if (type == 3) line.kind = 'V', line.angle = M_PI;
  else if (type != 0 && type != 4) {
    reject(place, " has type ", type,
           ", not 1 (border), 2 (mountain), 3 (valley), or 0 or 4 (auxiliary)");
  }
  drawing.add(std::move(line));
}

double numberAt(const std::string& text, const std::string& place) {
  const std::optional<double> number = numberFrom(text);
  if (!number) reject(place, " holds '", text.substr(0, 60), "', not a finite number");
  return *number;
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; words.size() <= kNumbers && stream >> word;) words.push_back(word);
  return words;
}

/// An object's properties; those that Java leaves out are 0.
void addProxy(const tinyxml2::XMLElement& object, LineDrawing& drawing) {
  std::map<std::string, double> values;
  for (const auto* item = object.FirstChildElement("void"); item;
       item = item->NextSiblingElement("void")) {
    const char* property = item->Attribute("property");
    const auto* value = item->FirstChildElement();
    if (!property || !value) reject(placeOf(*item), " is no property with a value");
    values[property] = numberAt(trimmed(textOf(*value)), placeOf(*value));
  }
  addLine({values["type"], values["x0"], values["y0"], values["x1"], values["y1"]}, placeOf(object),
          drawing);
}

void addProxies(const tinyxml2::XMLElement& element, LineDrawing& drawing) {
  const char* name = element.Attribute("class");
  if (localName(element) == "object" && name && std::string(name) == "oripa.OriLineProxy") {
    addProxy(element, drawing);
    return;
  }
  for (const auto* child = element.FirstChildElement(); child;
       child = child->NextSiblingElement()) {
    addProxies(*child, drawing);
  }
}

}  // namespace

LineDrawing readCp(const std::string& text) {
  LineDrawing drawing;
  std::istringstream stream(text);
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    const std::string place = "line " + std::to_string(++line_number);
    const std::vector<std::string> words = wordsOf(line);
    if (words.empty()) continue;
    if (words.size() != kNumbers) reject(place, " does not hold five numbers: type x1 y1 x2 y2");
    std::vector<double> numbers;
    for (const std::string& word : words) numbers.push_back(numberAt(word, place));
    addLine(numbers, place, drawing);
  }
  return drawing;
}

LineDrawing readOpx(const std::string& text) {
  tinyxml2::XMLDocument document;
  parseXml(text, document);
  LineDrawing drawing;
  addProxies(*document.RootElement(), drawing);
  return drawing;
}

}  // namespace shell_origami
