/// \file
/// The text in rviz's status bar while paper is folded.
#pragma once

#include <shell_origami/rviz/gesture.h>
#include <shell_origami/rviz/plugin/fold_preview.h>

#include <string>

namespace shell_origami {

/// Stands between two things in the status bar.
constexpr const char* kBetween = " &nbsp;&middot;&nbsp; ";

/// Returns where the pointer is and what can be done next, as rich text.
/// \pre the link has a paper
std::string statusText(const Gesture& gesture, const FoldPreview& preview, const PaperLink& link);

/// Returns an error message as rich text that stands out.
std::string refusal(const std::string& message);
/// Returns any other message as rich text.
std::string plain(const std::string& message);

}  // namespace shell_origami
