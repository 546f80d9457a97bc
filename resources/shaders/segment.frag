// SPDX-License-Identifier: GPL-3.0-or-later
uniform float half_width;
uniform bool flat_ends;

flat in vec2 from;
flat in vec2 to;

void main() {
  vec2 along = to - from;
  vec2 away = pixel() - from;
  float size = length(along);
  along = size > 0.0 ? along / size : vec2(1, 0);
  float t = dot(away, along);
  if (flat_ends) {
    float end = clamp(t + 0.5, 0.0, 1.0) - clamp(t - size + 0.5, 0.0, 1.0);
    paint(band(abs(along.x * away.y - along.y * away.x), half_width) * end);
  } else {
    paint(band(length(away - clamp(t, 0.0, size) * along), half_width));
  }
}
