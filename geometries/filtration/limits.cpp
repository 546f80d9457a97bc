// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/filtration/limits.h"

#include <limits>
#include <utility>

namespace mesecina {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void add_limit(Registry& registry, std::string_view id, std::string label, std::string help, std::string unit,
               double default_value, double minimum, double maximum) {
  Setting_spec setting;
  setting.id = id;
  setting.label = std::move(label);
  setting.help = std::move(help);
  setting.unit = std::move(unit);
  setting.default_value = default_value;
  setting.minimum = minimum;
  setting.maximum = maximum;
  setting.tags = {"filtration", "threshold"};
  registry.add_setting(std::move(setting));
}

}  // namespace

void add_filtration_limits(Registry& registry, const std::string& ball) {
  add_limit(
      registry, lambda_limit_setting.id, "Lambda limit",
      "Keeps what has at least this lambda: half the distance of the contact points. 0 keeps all; a hundredth of the "
      "diagonal removes fine detail. [F. Chazal, A. Lieutier: The lambda-medial axis, 2005]",
      "units of the input", 0, 0, infinity);
  add_limit(
      registry, angle_limit_setting.id, "Angle limit",
      "Keeps what has at least this contact angle: under which its contact points are seen from the axis. 0 keeps all, "
      "180 only what runs between parallel sides. [M. Foskey, M. Lin, D. Manocha: Efficient computation of a "
      "simplified medial axis, 2003]",
      "degrees", 60, 0, 180);
  add_limit(registry, scale_limit_setting.id, "Scale limit",
            "Keeps what no larger medial " + ball + " covers when all " + ball +
                "s have grown by this factor. 1 keeps all; 1.1 to 1.5 are usual. [B. Miklos: The Scale Axis Transform, "
                "2010, section 6.2]",
            "factor", 1.1, 1, infinity);
}

}  // namespace mesecina
