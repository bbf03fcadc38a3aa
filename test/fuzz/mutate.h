/// \file
/// Random changes of well-formed inputs.
#pragma once

#include "test/sheet/random_sheets.h"

#include <nlohmann/json.hpp>

#include <string>

namespace shell_origami {

/// Replaces, removes, swaps or repeats one to three values anywhere in a document.
void mutate(nlohmann::json& document, RandomSheets& random);

/// Changes, removes, inserts or repeats one to four runs of bytes.
void mutate(std::string& bytes, RandomSheets& random);

}  // namespace shell_origami
