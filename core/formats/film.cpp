// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/film.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace mesecina {

namespace {

namespace fs = std::filesystem;

/// Where a pattern has the place for the number, and to how many digits it is filled with zeros.
struct Place {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t digits = 0;
};

std::optional<Place> place_in(std::string_view pattern) {
  const std::size_t begin = pattern.find('%');
  if (begin == std::string_view::npos) return std::nullopt;
  std::size_t i = begin + 1;
  Place place{begin, 0, 0};
  if (i < pattern.size() && pattern[i] == '0') {
    ++i;
    constexpr std::size_t most_digits = 9;
    if (i >= pattern.size() || pattern[i] < '1' || pattern[i] > '9') return std::nullopt;
    place.digits = static_cast<std::size_t>(pattern[i++] - '0');
    if (place.digits > most_digits) return std::nullopt;
  }
  if (i >= pattern.size() || pattern[i] != 'd') return std::nullopt;
  place.end = i + 1;
  if (pattern.find('%', place.end) != std::string_view::npos) return std::nullopt;
  return place;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::optional<Film_kind> film_kind_of(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  if (extension == ".mp4") return Film_kind::mp4;
  if (extension == ".webm") return Film_kind::webm;
  if (extension == ".gif") return Film_kind::gif;
  if (extension == ".png" && place_in(file.filename().string())) return Film_kind::frames;
  return std::nullopt;
}

std::string reason_against(const Film_request& request) {
  const auto kind = film_kind_of(request.file);
  const std::string name = request.file.string();
  if (!kind)
    return name +
           ": expected a name that ends in .mp4, .webm or .gif, or one like frame-%05d.png for numbered pictures";
  if (*kind == Film_kind::mp4 && request.is_transparent)
    return name + ": mp4 has no transparency; choose .webm, .gif or frame-%05d.png";
  constexpr double least_rate = 0.01;
  constexpr double most_rate = 240;
  if (!(request.frames_per_second >= least_rate && request.frames_per_second <= most_rate))
    return name + ": expected 0.01 to 240 frames per second";
  constexpr int most_side = 16384;
  if (*kind != Film_kind::frames && std::max(request.width, request.height) > most_side)
    return name + ": expected at most 16384 pixels in width and height; choose a smaller size, or frame-%05d.png";
  return {};
}

fs::path frame_name(const fs::path& pattern, int number) {
  const std::string name = pattern.filename().string();
  const auto place = place_in(name);
  if (!place) return pattern;
  std::string digits = std::to_string(number);
  if (digits.size() < place->digits) digits.insert(0, place->digits - digits.size(), '0');
  return pattern.parent_path() / (name.substr(0, place->begin) + digits + name.substr(place->end));
}

fs::path unfinished_film(const fs::path& file) {
  return file.parent_path() / ("." + file.filename().string() + ".unfinished");
}

}  // namespace mesecina
