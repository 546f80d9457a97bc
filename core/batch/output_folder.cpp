// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/output_folder.h"

#include <algorithm>
#include <fstream>
#include <ostream>
#include <system_error>

#include "core/formats/format.h"

namespace mesecina {

namespace fs = std::filesystem;

std::optional<std::string> Output_folder::create() const {
  std::error_code error;
  fs::create_directories(folder_ / ".mesecina", error);
  if (error) return error.message();
  return std::nullopt;
}

std::optional<std::string> Output_folder::find_complete(const fs::path& input, const std::string& fingerprint,
                                                        const std::vector<std::string>& names) const {
  std::ifstream stream(record_of(input));
  std::string line;
  if (!std::getline(stream, line) || line != fingerprint) return std::nullopt;
  const auto exists = [&](const std::string& name) {
    std::error_code error;
    return fs::is_regular_file(place(input, name), error);
  };
  if (!std::ranges::all_of(names, exists)) return std::nullopt;
  line.clear();
  std::getline(stream, line);
  return line;
}

void Output_folder::begin(const fs::path& input) const {
  discard(input);
  std::error_code error;
  fs::create_directory(workplace_of(input), error);
  if (error) throw File_error(workplace_of(input), 0, "expected to make a folder here, found: " + error.message());
}

bool Output_folder::is_begun(const fs::path& input) const {
  std::error_code error;
  return fs::is_directory(workplace_of(input), error);
}

fs::path Output_folder::place(const fs::path& input, const std::string& name) const {
  return folder_ / (input.stem().string() + name);
}

fs::path Output_folder::unfinished(const fs::path& input, const std::string& name) const {
  return workplace_of(input) / (input.stem().string() + name);
}

void Output_folder::publish(const fs::path& input, const std::string& fingerprint, const std::string& record,
                            const std::vector<std::string>& refused) {
  const std::lock_guard lock(publishing_);
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(workplace_of(input))) files.push_back(entry.path());
  // From here on what lies there is a mixture, should the process be killed.
  std::error_code error;
  fs::remove(record_of(input), error);
  for (const fs::path& file : files)
    if (const fs::path place = folder_ / file.filename(); fs::is_directory(place, error))
      throw File_error(place, 0, "expected to put a file here, found a folder; move it away");
  std::vector<fs::path> published;
  for (const fs::path& file : files) {
    const fs::path place = folder_ / file.filename();
    fs::rename(file, place, error);
    if (error) {
      std::error_code ignored;
      for (const fs::path& other : published) fs::remove(other, ignored);
      throw File_error(place, 0, "expected to put a file here, found: " + error.message());
    }
    published.push_back(place);
  }
  for (const std::string& name : refused)
    if (const fs::path earlier = place(input, name); fs::is_regular_file(earlier, error)) fs::remove(earlier, error);
  write_file(record_of(input), [&](std::ostream& stream) { stream << fingerprint << '\n' << record << '\n'; });
  discard(input);
}

void Output_folder::discard(const fs::path& input) const {
  std::error_code error;
  fs::remove_all(workplace_of(input), error);
}

}  // namespace mesecina
