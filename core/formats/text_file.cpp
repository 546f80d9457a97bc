// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/text_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "core/formats/format.h"

namespace mesecina {
namespace {

constexpr std::size_t most_warnings = 20;

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

void check_is_readable_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  switch (status.type()) {
    case std::filesystem::file_type::regular:
      return;
    case std::filesystem::file_type::not_found:
      throw File_error(path, 0, "expected a file, found nothing of this name; check the name and the folder");
    case std::filesystem::file_type::directory:
      throw File_error(path, 0, "expected a file, found a folder; name a file in it");
    case std::filesystem::file_type::none:
      throw File_error(path, 0,
                       "expected a file, found none that can be reached: " + error.message() +
                           "; check the permissions of its folder");
    default:
      throw File_error(path, 0, "expected a file, found a device or a pipe; copy it to a file first");
  }
}

}  // namespace

std::size_t Text_file::line_at(std::size_t offset) const {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

Text_file load_bytes(const std::filesystem::path& path) {
  check_is_readable_file(path);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw File_error(path, 0, "expected a file that may be read, found no permission; change its mode");
  Text_file file{path, {}};
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error) file.text.resize(size);
  stream.read(file.text.data(), static_cast<std::streamsize>(file.text.size()));
  file.text.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream) file.text.append(std::istreambuf_iterator<char>(stream), {});
  if (stream.bad()) throw File_error(path, 0, "expected to read to the end, found an error of the disk; copy it anew");
  if (file.text.empty()) throw File_error(path, 0, "expected data, found an empty file; write it again");
  return file;
}

Text_file load_text(const std::filesystem::path& path) {
  Text_file file = load_bytes(path);
  const std::string_view text = file.text;
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw File_error(path, 1, "expected UTF-8 text, found UTF-16; save it as UTF-8");
  if (text.starts_with("\xEF\xBB\xBF")) file.text.erase(0, 3);
  if (const std::size_t zero = file.text.find('\0'); zero != std::string::npos) {
    throw File_error(path, file.line_at(zero),
                     "expected text, found a zero byte; this is a binary or damaged file, export it as text");
  }
  if (trim(file.text).empty()) throw File_error(path, 0, "expected data, found an empty file; write it again");
  return file;
}

std::string quote(std::string_view found) {
  found = trim(found);
  if (found.empty()) return "nothing";
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : found.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  text += '\'';
  if (found.size() > longest) text += "...";
  return text;
}

char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](char c) { return lower_case(c); });
  return result;
}

bool Line_scanner::next() {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    line_ = trim(line_.substr(0, std::min(line_.find('#'), line_.find("//"))));
    if (!line_.empty()) return true;
  }
  line_ = {};
  return false;
}

void split_fields(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::size_t end = std::min(line.find_first_of(" \t\r\n\v\f,;"), line.size());
    fields.push_back(line.substr(0, end));
    line.remove_prefix(end);
    const std::size_t after_blanks = std::min(line.find_first_not_of(blanks), line.size());
    line.remove_prefix(after_blanks);
    if (line.empty()) return;
    if (line.front() == ',' || line.front() == ';') line.remove_prefix(1);
  }
}

void Warning_list::add(std::string warning) {
  if (++count_ <= most_warnings) warnings_.push_back(std::move(warning));
}

std::vector<std::string> Warning_list::take() {
  if (count_ > most_warnings) warnings_.push_back("and " + std::to_string(count_ - most_warnings) + " more warnings");
  count_ = 0;
  return std::exchange(warnings_, {});
}

}  // namespace mesecina
