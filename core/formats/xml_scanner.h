// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/text_file.h"

namespace mesecina {

struct Xml_tag {
  bool opens = false;   ///< <name ...> or <name ... />
  bool closes = false;  ///< </name> or <name ... />
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string>> attributes;  ///< values with their entities replaced
  std::size_t line = 0;

  /// Null when there is no such attribute.
  const std::string* find(std::string_view attribute) const;
};

/// The tags of an XML file in their order. Texts, comments, processing instructions, CDATA and the DOCTYPE are skipped;
/// entities that a DOCTYPE defines are left as they are, which bounds the memory.
class Xml_scanner {
 public:
  /// The file must outlive the scanner.
  explicit Xml_scanner(const Text_file& file) : file_(file), text_(file.text) {}
  /// False at the end. Throws File_error when a tag is no XML or is cut off.
  bool next(Xml_tag& tag);

 private:
  [[noreturn]] void fail(const std::string& expected);
  void count_lines();
  void skip_blanks();
  void skip_past(std::string_view end, const std::string& expected);
  void skip_doctype();
  std::string_view scan_name();
  void scan_attributes(Xml_tag& tag);

  const Text_file& file_;
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t counted_ = 0;  ///< up to where line_ counts
  std::size_t line_ = 1;
};

}  // namespace mesecina
