/// \file
/// The paper's edits as messages, and back: what a recording is simulated again from.
#pragma once

#include <shell_origami/node/messages.h>
#include <shell_origami/node/session.h>

#include <string>

namespace shell_origami {

/// The header is left open.
msg::Edit editMessage(const EditRecord& record);
/// Kind paper, load, reset or undo: the whole paper after its last edit. The header is left open.
msg::Edit paperMessage(const Session& session, const std::string& kind,
                       const std::string& path = "");

/// The message's edit. \throws std::invalid_argument with a message when there is no such kind.
Edit editFrom(const msg::Edit& message);
/// Whether the message carries a whole paper.
bool carriesPaper(const msg::Edit& message);
/// \throws std::invalid_argument with one sentence when it carries none.
Session paperFrom(const msg::Edit& message);

}  // namespace shell_origami
