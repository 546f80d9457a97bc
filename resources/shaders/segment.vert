// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 3) in vec4 ends;  // of a ray: its start and direction

uniform bool is_ray;
uniform float half_width;

flat out vec2 from;
flat out vec2 to;

// Liang and Barsky: cuts at a rectangle a little larger than the picture, so that no length is too large for floats.
bool cut_at_border(inout vec2 p, inout vec2 q) {
  vec2 border = half_size + vec2(2.0 * half_width + 4.0);
  vec2 step = q - p;
  float first = 0.0;
  float last = 1.0;
  for (int i = 0; i < 2; ++i) {
    if (step[i] == 0.0) {
      if (abs(p[i]) > border[i]) return false;
    } else {
      float a = (-border[i] - p[i]) / step[i];
      float b = (border[i] - p[i]) / step[i];
      first = max(first, min(a, b));
      last = min(last, max(a, b));
    }
  }
  if (first > last) return false;
  q = p + last * step;
  p = p + first * step;
  return true;
}

void main() {
  from = to_pixels(ends.xy);
  to = is_ray ? from + ends.zw * (length(from) + 2.0 * length(half_size)) : to_pixels(ends.zw);
  element_color = color_of_number(threshold_rank);
  if (!is_drawn() || !cut_at_border(from, to)) {
    gl_Position = nowhere;
    return;
  }
  vec2 along = to - from;
  float size = length(along);
  along = size > 0.0 ? along / size : vec2(1, 0);
  vec2 across = vec2(-along.y, along.x);
  float reach = half_width + 1.0;
  vec2 corner = (gl_VertexID & 1) == 0 ? from - along * reach : to + along * reach;
  corner += (gl_VertexID & 2) == 0 ? across * reach : -across * reach;
  gl_Position = at_pixel(corner);
}
