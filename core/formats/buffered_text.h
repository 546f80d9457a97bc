// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

#include "core/formats/number.h"

namespace mesecina {

/// Collects text and hands it to a stream in large pieces, without the stream's formatting and its locale. The rest is
/// handed over at the end of its life.
class Buffered_text {
 public:
  explicit Buffered_text(std::ostream& stream) : stream_(stream) {}
  Buffered_text(const Buffered_text&) = delete;
  Buffered_text& operator=(const Buffered_text&) = delete;
  ~Buffered_text() { flush(); }

  Buffered_text& operator<<(std::string_view text) {
    text_ += text;
    constexpr std::size_t enough = 1 << 20;
    if (text_.size() >= enough) flush();
    return *this;
  }
  Buffered_text& operator<<(std::int64_t number) { return *this << std::string_view(std::to_string(number)); }
  Buffered_text& operator<<(std::size_t number) { return *this << std::string_view(std::to_string(number)); }
  Buffered_text& operator<<(int number) { return *this << static_cast<std::int64_t>(number); }
  Buffered_text& operator<<(double number) {
    append_number(text_, number);
    return *this;
  }

 private:
  void flush() {
    stream_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

  std::ostream& stream_;
  std::string text_;
};

/// `text` with line ends and other control characters as blanks, fit for a comment.
inline std::string on_one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return line;
}

}  // namespace mesecina
