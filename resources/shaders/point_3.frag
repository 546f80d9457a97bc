// SPDX-License-Identifier: GPL-3.0-or-later
uniform float point_radius;

in vec2 from_center;
in vec3 eye_place;

void main() {
  float way = length(from_center);
  if (way > point_radius || is_sliced_off(eye_place)) discard;
  paint(vec4(element_color.rgb * (1.0 - 0.35 * pow(way / point_radius, 4.0)), element_color.a), gl_FragCoord.z);
}
