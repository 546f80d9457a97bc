// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/json_text.h"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "core/formats/text_file.h"

namespace mesecina {

namespace {

constexpr std::size_t most_levels = 500;

std::string line_of(std::string_view text, std::size_t offset) {
  return "line " + std::to_string(1 + std::ranges::count(text.substr(0, offset), '\n')) + ": ";
}

/// Needs no valid JSON.
void refuse_deep(std::string_view text) {
  std::size_t levels = 0;
  bool is_in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_in_text) {
      if (c == '\\') ++i;
      if (c == '"') is_in_text = false;
    } else if (c == '"') {
      is_in_text = true;
    } else if (c == '[' || c == '{') {
      if (++levels > most_levels)
        throw std::invalid_argument(line_of(text, i) + "expected at most " + std::to_string(most_levels) +
                                    " lists and objects within each other, found more at byte " + std::to_string(i) +
                                    "; the file is damaged");
    } else if ((c == ']' || c == '}') && levels > 0) {
      --levels;
    }
  }
}

}  // namespace

nlohmann::json parse_json(std::string_view text) {
  refuse_deep(text);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t offset = std::min(text.size(), error.byte == 0 ? 0 : error.byte - 1);
    const std::string found = offset < text.size() ? quote(text.substr(offset, text.substr(offset).find('\n')))
                                                   : std::string("the end of the file");
    throw std::invalid_argument(line_of(text, offset) + "expected JSON, found " + found + " at byte " +
                                std::to_string(offset) + "; the file is damaged or cut off");
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(std::string("expected JSON, found ") + error.what());
  }
}

}  // namespace mesecina
