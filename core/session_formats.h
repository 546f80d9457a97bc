// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/formats/format.h"
#include "core/session.h"

namespace mesecina {

/// Reads a file of a session, or a picture with one within. Throws File_error, also for a picture without.
Session read_session_file(const std::filesystem::path& file, const Registry& registry);

/// Adds the reader of sessions, and lets pictures (PNG, SVG, PDF) with a scene within be read as the session that they
/// hold; others are read as before. To be called when all other readers are there.
void add_session_formats(Formats& formats, const std::shared_ptr<const Registry>& registry);

}  // namespace mesecina
