// SPDX-License-Identifier: GPL-3.0-or-later
// A quadrilateral given by its corners: the cutting plane, where it is inside a solid.
uniform vec3 corners[4];
uniform mat4 projection;
uniform float layer_lift;
uniform vec4 color;

flat out vec4 element_color;
flat out int element;
out vec3 eye_place;

void main() {
  eye_place = corners[gl_VertexID];
  element_color = color;
  element = -1;
  vec4 place = projection * vec4(eye_place, 1);
  gl_Position = place - vec4(0, 0, layer_lift * place.w, 0);
}
