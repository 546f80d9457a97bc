#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a pixel a shape covers, from the distance of the pixel to it. Precedes the shader of each kind.

uniform vec2 half_size;

flat in vec4 element_color;
out vec4 result;

vec2 pixel() { return gl_FragCoord.xy - half_size; }

// A band on both sides of a curve.
float band(float distance_to_curve, float half_width) {
  return clamp(half_width + 0.5 - distance_to_curve, 0.0, 1.0) - clamp(0.5 - half_width - distance_to_curve, 0.0, 1.0);
}

void paint(float coverage) {
  if (coverage <= 0.0) discard;
  float alpha = element_color.a * coverage;
  result = vec4(element_color.rgb * alpha, alpha);
}
