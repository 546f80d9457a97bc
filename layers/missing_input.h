// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mesecina {

/// Whether a layer with this reason shows nothing only because there is no input of the kind that it is about: nothing
/// is wrong then. Such reasons begin with "there is no", "there are no", "there are neither" or "there is nothing".
inline bool is_input_missing(const QString& reason) {
  for (const char* start : {"there is no ", "there are no ", "there are neither ", "there is nothing "})
    if (reason.startsWith(QLatin1String(start))) return true;
  return false;
}

}  // namespace mesecina
