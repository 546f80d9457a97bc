// SPDX-License-Identifier: GPL-3.0-or-later
// A fan of triangles between an arc and its chord. The ends are those of its neighbours, to the last bit.
layout(location = 3) in vec4 ends;    // start and end
layout(location = 4) in vec3 circle;  // centre and radius
layout(location = 5) in vec2 turn;    // angle of the start, sweep

uniform int corners;

vec2 along(int i) {
  if (i == 0) return ends.xy;
  if (i == corners - 1) return ends.zw;
  float angle = turn.x + turn.y * float(i) / float(corners - 1);
  return circle.xy + circle.z * vec2(cos(angle), sin(angle));
}

void main() {
  int corner = gl_VertexID % 3;
  element_color = color;
  gl_Position = at_pixel(to_pixels(along(corner == 0 ? 0 : gl_VertexID / 3 + corner)));
}
