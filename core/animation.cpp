// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/formats/number.h"

namespace mesecina {

namespace {

Setting_value value_of(const Setting_spec& spec, double number) {
  if (std::holds_alternative<std::int64_t>(spec.default_value)) return static_cast<std::int64_t>(std::llround(number));
  return number;
}

std::vector<std::string> number_ids(const Registry& registry) {
  std::vector<std::string> ids;
  for (const Setting_spec& spec : registry.settings())
    if (std::holds_alternative<double>(spec.default_value) || std::holds_alternative<std::int64_t>(spec.default_value))
      ids.push_back(spec.id);
  return ids;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace

double Sweep::value(int frame) const {
  const int last = steps - 1;
  if (last <= 0) return from;
  int step = std::clamp(frame, 0, frames() - 1);
  if (step > last) step = 2 * last - step;
  const double part = static_cast<double>(step) / last;
  return std::lerp(from, to, easing == Easing::smooth ? part * part * (3 - 2 * part) : part);
}

Settings swept(const Registry& registry, Settings settings, std::span<const Sweep> sweeps, int frame) {
  for (const Sweep& sweep : sweeps) {
    const Setting_spec& spec = *registry.find_setting(sweep.setting);
    const Setting_value value = value_of(spec, sweep.value(frame));
    settings = value == spec.default_value ? settings.without(spec.id) : settings.with(spec.id, value);
  }
  return settings;
}

int frames_of(std::span<const Sweep> sweeps) {
  int frames = 0;
  for (const Sweep& sweep : sweeps) frames = std::max(frames, sweep.frames());
  return frames;
}

void check_sweep(const Registry& registry, const Sweep& sweep) {
  const Setting_spec* spec = registry.find_setting(sweep.setting);
  const std::vector<std::string> known = number_ids(registry);
  if (!spec) {
    const std::string nearest = nearest_name(sweep.setting, known);
    throw std::invalid_argument(
        "unknown setting '" + sweep.setting + "'" +
        (nearest.empty() ? "; --list settings shows them all" : "; did you mean '" + nearest + "'?"));
  }
  if (std::ranges::find(known, sweep.setting) == known.end())
    throw std::invalid_argument("the setting " + sweep.setting + " is no number, so it cannot move");
  for (const double end : {sweep.from, sweep.to}) {
    if (!std::isfinite(end))
      throw std::invalid_argument(sweep.setting + ": expected a finite number, found " + format_number(end));
    check_setting(*spec, value_of(*spec, end));
  }
  if (sweep.steps < 1 || sweep.steps > most_sweep_steps)
    throw std::invalid_argument(sweep.setting + ": expected 1 to " + std::to_string(most_sweep_steps) +
                                " steps, found " + std::to_string(sweep.steps));
}

Sweep parse_sweep(const Registry& registry, std::string_view text) {
  const auto refuse = [&](const std::string& found) {
    throw std::invalid_argument("expected ID=FROM:TO:STEPS, perhaps with :smooth or :ping-pong, found " + found);
  };
  const auto equals = text.find('=');
  if (equals == std::string_view::npos) refuse("'" + std::string(text) + "'");
  const std::vector<std::string_view> parts = split(text.substr(equals + 1), ':');
  constexpr std::size_t numbers = 3;
  if (parts.size() < numbers) refuse("'" + std::string(text) + "'");
  Sweep sweep;
  sweep.setting = text.substr(0, equals);
  const auto number = [&](std::string_view part) {
    const auto read = parse_number(part);
    if (!read) refuse("'" + std::string(part) + "' in place of a number");
    return *read;
  };
  sweep.from = number(parts[0]);
  sweep.to = number(parts[1]);
  const double steps = number(parts[2]);
  if (steps != std::floor(steps) || !(steps >= 1) || !(steps <= most_sweep_steps))
    throw std::invalid_argument("expected 1 to " + std::to_string(most_sweep_steps) + " steps, found '" +
                                std::string(parts[2]) + "'");
  sweep.steps = static_cast<int>(steps);
  for (std::size_t i = numbers; i < parts.size(); ++i) {
    if (parts[i] == "smooth") {
      sweep.easing = Sweep::Easing::smooth;
    } else if (parts[i] == "ping-pong") {
      sweep.is_ping_pong = true;
    } else if (parts[i] != "linear") {
      refuse("'" + std::string(parts[i]) + "'");
    }
  }
  check_sweep(registry, sweep);
  return sweep;
}

std::string to_text(const Sweep& sweep) {
  return sweep.setting + "=" + format_number(sweep.from) + ":" + format_number(sweep.to) + ":" +
         std::to_string(sweep.steps) + (sweep.easing == Sweep::Easing::smooth ? ":smooth" : "") +
         (sweep.is_ping_pong ? ":ping-pong" : "");
}

}  // namespace mesecina
