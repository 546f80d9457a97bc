#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The colour of a number. Precedes all other shaders of vertices.

const int one_color = 0;
const int interpolated_map = 1;
const int stepped_map = 2;
const int classes_of_map = 3;
const int packed_colors = 4;
uniform int color_rule;
uniform vec4 color;
uniform vec4 missing_color;
uniform vec2 range;
uniform bool reversed;
uniform int texels;
uniform vec2 class_of_number;  // class = number * x + y
uniform sampler1D color_map;

vec4 color_by(float number, float rank) {
  if (color_rule == one_color) return color;
  if (color_rule == packed_colors) {
    int bits = int(number);
    return vec4(vec3(bits >> 16, (bits >> 8) & 255, bits & 255) / 255.0, color.a);
  }
  if (rank < -0.5) return missing_color;
  float t = 0.5;
  if (number > range.y) t = 1.0;
  else if (number < range.x) t = 0.0;
  else if (range.y > range.x) t = (number - range.x) / (range.y - range.x);
  if (color_rule == classes_of_map && abs(number) < 1e30) {
    int chosen = int(round(mod(number * class_of_number.x + class_of_number.y, float(texels)))) % texels;
    return vec4(texelFetch(color_map, chosen, 0).rgb, color.a);
  }
  if (reversed) t = 1.0 - t;
  if (color_rule == interpolated_map) {
    float texel = t * float(texels - 1);
    int low = min(int(texel), texels - 2);
    return vec4(mix(texelFetch(color_map, low, 0).rgb, texelFetch(color_map, low + 1, 0).rgb, texel - float(low)),
                color.a);
  }
  return vec4(texelFetch(color_map, min(int(t * float(texels)), texels - 1), 0).rgb, color.a);
}
