// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session.h"
#include "shell/document.h"

namespace mesecina {

/// What a document shows of a session. Layers that the session does not name are hidden.
Document_state state_of(const Session& session, const Registry& registry);

/// A session with what a document has.
Session session_of(const Document_state& state, int dimension);

}  // namespace mesecina
