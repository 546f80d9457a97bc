// SPDX-License-Identifier: GPL-3.0-or-later
uniform bool filled;
uniform float half_width;
uniform bool flat_ends;

flat in vec2 toward_center;
flat in float away;
flat in float curvature;
flat in vec2 start;
flat in vec2 end;
flat in vec4 directions;
flat in float is_whole;

void main() {
  vec2 p = pixel();
  // (|p - c|^2 - r^2) / (|p - c| + r), all over r, without the difference of large numbers.
  float outward = (curvature * dot(p, p) - 2.0 * dot(p, toward_center) + away * (length(toward_center) + 1.0)) /
                  (length(p * curvature - toward_center) + 1.0);
  if (filled) {
    paint(clamp(0.5 - outward, 0.0, 1.0));
    return;
  }
  bool on_arc = is_whole > 0.5;
  if (!on_arc) {
    bool after_start = dot(p - start, directions.xy) >= 0.0;
    bool before_end = dot(p - end, directions.zw) <= 0.0;
    // The end lies in the first half turn after the start iff it is to the left of the line from start to centre.
    bool within_half_turn = dot(directions.zw, vec2(-directions.y, directions.x)) >= 0.0;
    on_arc = within_half_turn ? after_start && before_end : after_start || before_end;
  }
  if (on_arc) paint(band(abs(outward), half_width));
  else if (flat_ends) discard;
  else paint(band(min(length(p - start), length(p - end)), half_width));
}
