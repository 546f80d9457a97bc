// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 3) in vec4 first_corners;
layout(location = 4) in vec2 last_corner;

void main() {
  vec2 corner = gl_VertexID == 0 ? first_corners.xy : gl_VertexID == 1 ? first_corners.zw : last_corner;
  element_color = color_of_number(threshold_rank);
  gl_Position = is_drawn() ? at_pixel(to_pixels(corner)) : nowhere;
}
