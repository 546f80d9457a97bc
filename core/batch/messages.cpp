// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/messages.h"

#include <cmath>
#include <ostream>

namespace mesecina {

void Messages::clear_line() {
  constexpr const char* to_start_and_erase = "\r\x1b[K";
  if (!shown_.empty()) stream_ << to_start_and_erase;
}

void Messages::say(Log_level level, const std::string& text) {
  if (level > most_) return;
  const std::lock_guard lock(mutex_);
  clear_line();
  stream_ << program_ << ": " << text << '\n' << shown_ << std::flush;
}

void Messages::show_progress(const std::string& text) {
  if (!is_terminal_) {
    say(Log_level::info, text);
    return;
  }
  if (most_ == Log_level::error) return;
  const std::lock_guard lock(mutex_);
  clear_line();
  shown_ = text;
  stream_ << shown_ << std::flush;
}

void Messages::end_progress() {
  const std::lock_guard lock(mutex_);
  clear_line();
  shown_.clear();
  stream_ << std::flush;
}

std::string Time_left::text(double seconds) const {
  if (bytes_computed_ == 0 || bytes_left_ == 0) return {};
  const double left = seconds * static_cast<double>(bytes_left_) / static_cast<double>(bytes_computed_);
  constexpr double minute = 60;
  constexpr double hour = 3600;
  const auto whole = [](double number) { return std::to_string(std::lround(number)); };
  if (left < 2 * minute) return "about " + whole(std::ceil(left)) + " s left";
  if (left < 2 * hour) return "about " + whole(left / minute) + " min left";
  const double hours = std::floor(left / hour);
  return "about " + whole(hours) + " h " + whole(std::floor((left - hours * hour) / minute)) + " min left";
}

}  // namespace mesecina
