// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <string>
#include <vector>

#include "core/registry.h"

namespace mesecina {

/// What a Primitive_set itself tells of one of its elements: its id and values.
std::vector<Fact> own_facts(const Primitive_set& set, std::size_t element);
/// Adds those whose names are not told yet.
void add_facts(std::vector<Fact>& told, std::vector<Fact> more);

/// The label, then "name: text" lines.
QString facts_text(const std::string& label, const std::vector<Fact>& facts);
/// The same text with numbers of at most six digits, for reading.
QString with_short_numbers(const QString& text);

}  // namespace mesecina
