// SPDX-License-Identifier: GPL-3.0-or-later
uniform bool filled;
uniform float half_width;
uniform bool flat_ends;

flat in vec2 center;
flat in float radius;
flat in vec2 start;
flat in vec2 end;
flat in float covered;

float cross_product(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

void main() {
  vec2 away = pixel() - center;
  float size = length(away);
  if (filled) {
    paint(band(size, radius));
    return;
  }
  bool on_arc = covered > 6.2831854;
  if (!on_arc) {
    on_arc = covered <= 3.14159265 ? cross_product(start, away) >= 0.0 && cross_product(away, end) >= 0.0
                                   : !(cross_product(end, away) > 0.0 && cross_product(away, start) > 0.0);
  }
  if (on_arc) paint(band(abs(size - radius), half_width));
  else if (flat_ends) discard;
  else paint(band(min(length(away - start * radius), length(away - end * radius)), half_width));
}
