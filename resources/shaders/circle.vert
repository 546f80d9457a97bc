// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 3) in vec3 circle;  // centre and radius
layout(location = 4) in vec2 turn;    // angle of the start, angle covered counterclockwise

uniform bool filled;
uniform float half_width;
uniform int pieces;

flat out vec2 center;
flat out float radius;
flat out vec2 start;
flat out vec2 end;
flat out float covered;

const float full_turn = 6.28318530718;

// A strip of `pieces` quadrilaterals along the curve, as narrow as it can be around the band that is painted; of one
// piece: a square around the circle.
void main() {
  center = to_pixels(circle.xy);
  radius = circle.z * scale;
  covered = turn.y >= full_turn * 0.9999999 ? full_turn * 2.0 : turn.y;
  start = vec2(cos(turn.x), sin(turn.x));
  end = vec2(cos(turn.x + turn.y), sin(turn.x + turn.y));
  element_color = color_of_number(threshold_rank);

  float reach = (filled ? 0.0 : half_width) + 1.0;
  vec2 beyond = max(abs(center) - half_size, vec2(0.0));
  if (!is_drawn() || length(beyond) > radius + reach) {
    gl_Position = nowhere;
    return;
  }
  if (pieces == 1) {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    gl_Position = at_pixel(center + corner * (radius + reach));
    return;
  }
  float padding = reach >= radius ? full_turn : reach / radius * 1.6;
  bool whole = filled || covered + 2.0 * padding >= full_turn;
  float first = whole ? turn.x : turn.x - padding;
  float angle = whole ? full_turn : covered + 2.0 * padding;
  float step = angle / float(pieces);
  int i = gl_VertexID >> 1;
  float at = first + step * float(i == pieces && whole ? 0 : i);
  float inner = filled ? 0.0 : max(radius - reach, 0.0);
  float outer = (radius + reach) / cos(step / 2.0);
  gl_Position = at_pixel(center + vec2(cos(at), sin(at)) * ((gl_VertexID & 1) == 0 ? inner : outer));
}
