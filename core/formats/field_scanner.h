// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/formats/text_file.h"

namespace mesecina {

/// Reads a text line by line, and each line field by field, without copying it: made for files of millions of lines.
/// Blank lines are skipped, and so are comments, from "#" to the end of the line. Fields are separated by blanks, tabs,
/// commas and semicolons; two commas with nothing between them make an empty field, two blanks do not.
class Field_scanner {
 public:
  enum class Comments { hash, hash_or_slashes };  ///< slashes: "//" starts a comment as well

  /// `file` must outlive the scanner, which starts at the byte `offset`.
  explicit Field_scanner(const Text_file& file, Comments comments = Comments::hash, std::size_t offset = 0);

  /// Moves to the next line that holds something; false at the end.
  bool next_line();
  std::string_view line() const { return line_; }               ///< trimmed, without its comment
  std::size_t line_number() const { return number_; }           ///< from 1; after the end, that of the last line
  std::size_t size() const { return file_.text.size(); }        ///< of the file, in bytes
  bool has_field() const { return next_ != end_ || is_owed_; }  ///< on this line
  std::string_view field();                                     ///< the next one; empty if there is none on this line

  /// The next field as a finite number. Throws File_error, in which it is called `name`.
  double number(std::string_view name);
  /// The next field as an integer of at least 0. Throws File_error, in which it is called `name`.
  std::uint64_t count(std::string_view name);
  /// The next field as a vertex number from 0 to vertex_count - 1. Throws File_error.
  int index(std::size_t vertex_count);

  /// Throws File_error for the present line.
  [[noreturn]] void fail(const std::string& expected, const std::string& found,
                         const std::string& remedy = "correct or delete this line") const;

 private:
  void skip_to_field();
  void finish_field();
  bool ends_field(const char* position) const;

  const Text_file& file_;
  Comments comments_;
  std::string_view rest_;
  std::string_view line_;
  const char* next_ = nullptr;
  const char* end_ = nullptr;
  bool is_owed_ = false;  ///< a comma was the last thing on the line, so an empty field follows
  std::size_t number_ = 0;
};

}  // namespace mesecina
