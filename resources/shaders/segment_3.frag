// SPDX-License-Identifier: GPL-3.0-or-later
uniform float half_width;

flat in vec2 from;
flat in vec2 to;
in vec3 eye_place;

void main() {
  vec2 along = to - from;
  float square = dot(along, along);
  vec2 way = gl_FragCoord.xy - from;
  if (square > 0.0) way -= clamp(dot(way, along) / square, 0.0, 1.0) * along;
  if (length(way) > half_width || is_sliced_off(eye_place)) discard;
  paint(element_color, gl_FragCoord.z);
}
