#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A rectangle in normalized device coordinates: x0 y0 x1 y1.

uniform vec4 rectangle;
uniform vec4 color;
uniform vec4 texture_rectangle;

flat out vec4 element_color;
out vec2 texture_place;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  element_color = color;
  texture_place = mix(texture_rectangle.xy, texture_rectangle.zw, corner);
  gl_Position = vec4(mix(rectangle.xy, rectangle.zw, corner), 0, 1);
}
