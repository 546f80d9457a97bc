// SPDX-License-Identifier: GPL-3.0-or-later
// A circle so large that its centre says nothing in floats: it is known by its distance and direction.
layout(location = 3) in vec4 circle;  // from the origin to the centre, over the radius; distance; 1 / radius
layout(location = 4) in vec4 ends;    // start and end
layout(location = 5) in vec4 travel;  // directions along the circle at start and end
layout(location = 6) in float whole;

uniform bool filled;
uniform float half_width;
uniform int pieces;

flat out vec2 toward_center;  // from the middle of the picture to the centre, over the radius
flat out float away;          // distance of the middle of the picture to the circle
flat out float curvature;
flat out vec2 start;
flat out vec2 end;
flat out vec4 directions;
flat out float is_whole;

void main() {
  curvature = circle.w / scale;
  // The middle of the picture seen from the origin is -offset.
  float squared = curvature * dot(offset, offset) + 2.0 * dot(offset, circle.xy);
  toward_center = circle.xy + offset * curvature;
  away = (squared + circle.z * scale * (length(circle.xy) + 1.0)) / (length(toward_center) + 1.0);
  start = to_pixels(ends.xy);
  end = to_pixels(ends.zw);
  directions = travel;
  is_whole = whole;
  element_color = color_of_number(threshold_rank);

  float view = length(half_size) + 4.0;
  float reach = (filled ? 0.0 : half_width) + 1.0;
  bool outside = filled ? away > view + reach : abs(away) > view + reach;
  if (!is_drawn() || outside) {
    gl_Position = nowhere;
    return;
  }
  vec2 inward = normalize(toward_center);
  vec2 along = vec2(-inward.y, inward.x);
  float piece = 2.0 * view / float(pieces);
  float s = -view + piece * float(gl_VertexID >> 1);
  float bent = min(abs(curvature * s), 1.0);
  float sagitta = curvature * s * s / (1.0 + sqrt(1.0 - bent * bent));
  float slack = reach + 1.0 + 0.5 * curvature * piece * piece;
  float depth = away + sagitta;
  if ((gl_VertexID & 1) == 0) depth -= slack;
  else depth = filled ? view : depth + slack;
  gl_Position = at_pixel(inward * max(depth, -2.0 * view) + along * s);
}
