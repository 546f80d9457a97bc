// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 3) in vec2 place;

uniform float point_radius;

flat out vec2 center;
flat out float radius;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  center = to_pixels(place);
  radius = point_radius;
  element_color = color_of_number(threshold_rank);
  gl_Position = is_drawn() ? at_pixel(center + corner * (point_radius + 1.0)) : nowhere;
}
