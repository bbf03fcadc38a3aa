/// \file
/// XML from unknown sources.
#pragma once

#include <tinyxml2.h>

#include <string>

namespace shell_origami {

/// Reads an XML text. Entities that it declares are not expanded.
/// Throws std::invalid_argument naming the line if it is not XML or nests too deep.
void parseXml(const std::string& text, tinyxml2::XMLDocument& document);

/// Returns an element's name without the prefix of a namespace.
std::string localName(const tinyxml2::XMLElement& element);

/// Returns an element's place for a message, such as "<path> in line 12".
std::string placeOf(const tinyxml2::XMLElement& element);

/// Returns the text of an element's own text nodes.
std::string textOf(const tinyxml2::XMLElement& element);

}  // namespace shell_origami
