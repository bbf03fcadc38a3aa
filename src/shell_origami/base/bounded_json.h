/// \file
/// JSON and CBOR from unknown sources: reading them takes a bounded stack, however deeply they
/// nest.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace shell_origami {

/// Lists and objects may nest this deep; a FOLD file needs four levels, a snapshot seven.
constexpr int kDeepestJson = 100;

/// Returns the value that a JSON text holds.
/// Throws std::invalid_argument naming the line if the text is not JSON, holds a number out of
/// range, or nests deeper than kDeepestJson.
nlohmann::json parseJson(const std::string& text);

/// Returns the value that CBOR bytes hold.
/// Throws std::invalid_argument if they are not CBOR as nlohmann::json::to_cbor writes it (strings
/// and lists of known length), or nest deeper than kDeepestJson.
nlohmann::json parseCbor(const std::vector<std::uint8_t>& bytes);

/// Returns a short text for a message: a scalar as JSON, cut after 60 characters, or for a list or
/// an object its kind and size.
std::string describeJson(const nlohmann::json& value);

}  // namespace shell_origami
