#include <shell_origami/fold_format/xml.h>

#include <shell_origami/base/error.h>

#include <algorithm>

namespace shell_origami {

void parseXml(const std::string& text, tinyxml2::XMLDocument& document) {
  const tinyxml2::XMLError error = document.Parse(text.c_str(), text.size());
  if (error == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    reject("its elements nest too deep in line ", document.ErrorLineNum());
  }
  if (error != tinyxml2::XML_SUCCESS) {
    reject("is not XML from line ", std::max(1, document.ErrorLineNum()), " on");
  }
  if (!document.RootElement()) reject("holds no XML element");
}

std::string localName(const tinyxml2::XMLElement& element) {
  const std::string name = element.Name();
  return name.substr(name.find(':') + 1);  // all of it without a colon
}

std::string placeOf(const tinyxml2::XMLElement& element) {
  return "<" + std::string(element.Name()).substr(0, 60) + "> in line " +
         std::to_string(element.GetLineNum());
}

std::string textOf(const tinyxml2::XMLElement& element) {
  std::string text;
  for (const auto* node = element.FirstChild(); node; node = node->NextSibling()) {
    if (node->ToText()) text += node->Value();
  }
  return text;
}

}  // namespace shell_origami
