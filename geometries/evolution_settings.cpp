// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/evolution_settings.h"

#include <algorithm>

namespace mesecina {

void add_smoothing_settings(Registry& registry) {
  {
    Setting_spec setting;
    setting.id = smoothing_factor_setting.id;
    setting.label = "Smoothing: factor";
    setting.help =
        "How far a step of {laplacian-smoothing} moves a point toward the middle of its neighbours: 0 not at all, 0.5 "
        "half of the way, 1 all of it. With {smoothing-keeps-size} at most 0.69 is used.";
    setting.unit = "part of the way";
    setting.default_value = 0.5;
    setting.minimum = 0;
    setting.maximum = 1;
    setting.tags = {"evolution", "smoothing"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = smoothing_keeps_size_setting.id;
    setting.label = "Smoothing: keep the size";
    setting.help =
        "Each step of {laplacian-smoothing} goes back by a slightly larger factor after it went forth, so that the "
        "shape "
        "does not shrink: only what is small is smoothed away (the lambda|mu scheme with pass band 0.1). [G. Taubin: A "
        "signal processing approach to fair surface design, 1995]";
    setting.default_value = false;
    setting.tags = {"evolution", "smoothing", "taubin"};
    registry.add_setting(std::move(setting));
  }
}

void add_noise_settings(Registry& registry) {
  {
    Setting_spec setting;
    setting.id = noise_amplitude_setting.id;
    setting.label = "Noise: amplitude";
    setting.help =
        "How far a step of noise moves a point at most, relative to the distance of its neighbours; a ball or disk, "
        "relative to its radius.";
    setting.unit = "fraction of the distance";
    setting.default_value = 0.1;
    setting.minimum = 0;
    setting.maximum = 10;
    setting.tags = {"evolution", "noise"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = evolution_seed_setting.id;
    setting.label = "Noise: seed";
    setting.help =
        "Chooses the random numbers of noise: the same seed gives the same noise, step by step, on every machine. "
        "--seed sets it too.";
    setting.default_value = std::int64_t{0};
    setting.tags = {"evolution", "noise", "random"};
    registry.add_setting(std::move(setting));
  }
}

void add_growing_settings(Registry& registry) {
  Setting_spec setting;
  setting.id = growing_step_setting.id;
  setting.label = "Growing: step";
  setting.help =
      "By how much radii change in a step: of {grow-balls} and {shrink-balls} in percent of what they were at first, "
      "of "
      "{stepped-growing} in percent of what they are.";
  setting.unit = "percent";
  setting.default_value = 3.0;
  setting.minimum = 0;
  setting.maximum = 100;
  setting.tags = {"evolution", "growing"};
  registry.add_setting(std::move(setting));
}

std::vector<double> smoothing_passes(double factor, bool keeps_size) {
  if (!keeps_size) return {factor};
  constexpr double pass_band = 0.1;
  constexpr double largest_stable_factor = 0.69;
  const double forth = std::min(factor, largest_stable_factor);
  return {forth, -forth / (1 - pass_band * forth)};
}

double growth_of_step(double percent, std::uint64_t step) {
  const double part = percent / 100;
  const double before = 1 + static_cast<double>(step - 1) * part;
  const double after = 1 + static_cast<double>(step) * part;
  // A billionth, so that rounding does not let a hundred times one percent leave something.
  constexpr double nothing = 1e-9;
  return before > nothing && after > nothing ? after / before : 0;
}

std::uint64_t seed_of_step(std::int64_t seed, std::uint64_t step) {
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
  return static_cast<std::uint64_t>(seed) * odd + step;
}

}  // namespace mesecina
