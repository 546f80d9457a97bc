// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/formats/format.h"

namespace mesecina {

/// A folder of its own for one test, removed at its end.
class Temporary_folder {
 public:
  /// The formats that `read` knows are the planar ones if none are given.
  explicit Temporary_folder(Formats formats = planar_formats());
  ~Temporary_folder();
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(std::string_view name, std::string_view text) const;

  /// What read_file makes of a file with this name and text.
  File_contents read(std::string_view name, std::string_view text) const;
  /// The message of the File_error that reading gives, after the folder's name; "" if there was none.
  std::string error(std::string_view name, std::string_view text) const;

 private:
  Formats formats_;
  std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& path);

}  // namespace mesecina
