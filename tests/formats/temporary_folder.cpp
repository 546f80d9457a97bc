// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/formats/temporary_folder.h"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <utility>

namespace mesecina {

Temporary_folder::Temporary_folder(Formats formats) : formats_(std::move(formats)) {
  for (int attempt = 0; path_.empty(); ++attempt) {
    const auto path = std::filesystem::temp_directory_path() /
                      ("mesecina-" + std::to_string(getpid()) + "-" + std::to_string(attempt));
    if (std::filesystem::create_directory(path)) path_ = path;
  }
}

Temporary_folder::~Temporary_folder() { std::filesystem::remove_all(path_); }

std::filesystem::path Temporary_folder::write(std::string_view name, std::string_view text) const {
  const std::filesystem::path file = path_ / name;
  std::filesystem::remove(file);  // some file systems wait for the disk when a file is cut to nothing and written anew
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

File_contents Temporary_folder::read(std::string_view name, std::string_view text) const {
  return read_file(formats_, write(name, text));
}

std::string Temporary_folder::error(std::string_view name, std::string_view text) const {
  try {
    read(name, text);
  } catch (const File_error& error) {
    const std::string message = error.what();
    const std::string prefix = path_.string() + "/";
    return message.starts_with(prefix) ? message.substr(prefix.size()) : "without its file: " + message;
  }
  return "";
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace mesecina
