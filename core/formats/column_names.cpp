// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/column_names.h"

#include <utility>

#include "core/formats/number.h"
#include "core/formats/text_file.h"

namespace mesecina {

std::vector<std::string> column_names(const std::vector<std::string_view>& fields) {
  std::vector<std::string> names;
  for (std::string_view field : fields) {
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    std::string name = lower_case(field);
    const bool is_word = !name.empty() && ((name[0] >= 'a' && name[0] <= 'z') || name[0] == '_');
    if (!is_word || parse_number(field) || name == "nan") return {};
    names.push_back(std::move(name));
  }
  return names;
}

std::string count_of_columns(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " column" : " columns");
}

}  // namespace mesecina
