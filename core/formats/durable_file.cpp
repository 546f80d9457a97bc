// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/durable_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <locale>
#include <system_error>

#include "core/formats/format.h"

namespace mesecina {

namespace {

/// A file next to `file` that did not exist before and exists, empty, now.
std::filesystem::path create_temporary(const std::filesystem::path& file) {
  constexpr int most_attempts = 1000;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    std::filesystem::path temporary = file;
    temporary += ".part" + std::to_string(attempt);
    errno = 0;
    if (std::FILE* created = std::fopen(temporary.c_str(), "wx")) {
      std::fclose(created);
      return temporary;
    }
    if (errno != EEXIST) {
      throw File_error(file, 0,
                       "expected to create a file here, found '" + std::generic_category().message(errno) +
                           "'; check that the folder exists and may be written");
    }
  }
  throw File_error(file, 0, "expected to create a file here, found 1000 left-over .part files; delete them");
}

/// Waits until what the path names is on the disk. Throws File_error about `file`.
void wait_for_disk(const std::filesystem::path& path, const std::filesystem::path& file) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  // Not every file system can be waited for; one that cannot says EINVAL.
  const bool is_safe = descriptor >= 0 && (fsync(descriptor) == 0 || errno == EINVAL);
  const std::error_code error(errno, std::generic_category());
  if (descriptor >= 0) close(descriptor);
  if (!is_safe)
    throw File_error(file, 0, "expected to bring this to the disk, found '" + error.message() + "'; check the disk");
}

void write_whole(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write, bool is_durable) {
  const std::filesystem::path temporary = create_temporary(file);
  std::error_code error;
  try {
    std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
    stream.imbue(std::locale::classic());
    write(stream);
    stream.close();
    if (!stream) throw File_error(file, 0, "expected to write the whole file, found no room for it; free disk space");
    if (is_durable) wait_for_disk(temporary, file);
    std::filesystem::rename(temporary, file, error);
    if (error) {
      throw File_error(file, 0, "expected to replace this file, found '" + error.message() + "'; choose another name");
    }
  } catch (...) {
    std::filesystem::remove(temporary, error);
    throw;
  }
  const std::filesystem::path folder = file.parent_path();
  if (is_durable) wait_for_disk(folder.empty() ? "." : folder, file);
}

}  // namespace

void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
  write_whole(file, write, false);
}

void write_file_durably(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
  write_whole(file, write, true);
}

}  // namespace mesecina
