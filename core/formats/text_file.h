// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mesecina {

/// A file in memory.
struct Text_file {
  std::filesystem::path path;
  std::string text;

  /// Line number, from 1, of the byte at `offset`. O(offset).
  std::size_t line_at(std::size_t offset) const;
};

/// The bytes of a file as they are. Throws File_error when there is no such file, when it is a directory or another
/// thing that is no file, may not be read, or is empty.
Text_file load_bytes(const std::filesystem::path& path);

/// What load_bytes gives, without the byte order mark. Throws File_error also when the file is blank, or holds zero
/// bytes and so is no text.
Text_file load_text(const std::filesystem::path& path);

/// What lies between the words of a file.
inline constexpr std::string_view blanks = " \t\r\n\v\f";

/// At most 40 characters of `found` between quotes, unprintable ones as '?'; "nothing" when it is empty.
std::string quote(std::string_view found);

/// ASCII letters only.
char lower_case(char c);
std::string lower_case(std::string_view text);

/// The lines of a text that hold something: blank lines are skipped, and so are comments, from "#" or "//" to the end
/// of the line.
class Line_scanner {
 public:
  explicit Line_scanner(std::string_view text) : rest_(text) {}
  /// Moves to the next line that holds something; false at the end.
  bool next();
  std::string_view line() const { return line_; }  ///< trimmed, without its comment
  std::size_t number() const { return number_; }   ///< from 1; after the end, the number of the last line

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

/// Splits at blanks, tabs, commas and semicolons into `fields`. Two commas with nothing between them make an empty
/// field, two blanks do not.
void split_fields(std::string_view line, std::vector<std::string_view>& fields);

/// Warnings of one file. Of very many only the first 20 are kept, and a last line says how many more there were.
class Warning_list {
 public:
  void add(std::string warning);
  std::vector<std::string> take();

 private:
  std::vector<std::string> warnings_;
  std::size_t count_ = 0;
};

}  // namespace mesecina
