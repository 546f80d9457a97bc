// SPDX-License-Identifier: GPL-3.0-or-later
uniform float point_radius;

out vec2 from_center;  // pixels
out vec3 eye_place;

void main() {
  ivec4 piece = texelFetch(pieces, gl_VertexID / 6);
  int corner = gl_VertexID % 6;
  element = piece.w;
  element_color = color_of(element);
  eye_place = eye_of(piece.x);
  from_center = vec2(0);
  gl_Position = nowhere;
  if (!is_drawn(element) || (perspective && eye_place.z > -nearest)) return;
  vec4 place = shown(lifted(eye_place, 1.5 * point_radius));
  from_center = (point_radius + 1.0) * vec2(corner == 1 || corner == 2 || corner == 4 ? 1 : -1,
                                            corner == 2 || corner == 4 || corner == 5 ? 1 : -1);
  gl_Position = place + vec4(2.0 * from_center / picture_size * place.w, 0, 0);
}
