// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mesecina {

/// How well `text` answers to what somebody types: 0 when it does not, else larger for a better match. Each word of the
/// query must be found, in any order: as letters of the text in their order, better together and at the beginnings of
/// words. An empty query gives 1. Case and accents of Latin letters do not matter. O(words · length).
int fuzzy_score(const QString& query, const QString& text);

/// The query against a name, and, for less, against an id and a longer text that must hold its words as they are.
int fuzzy_score(const QString& query, const QString& name, const QString& id, const QString& text);

}  // namespace mesecina
