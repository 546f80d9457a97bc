// SPDX-License-Identifier: GPL-3.0-or-later
uniform samplerBuffer normals;  // of the pieces, or of the vertices
uniform bool has_vertex_normals;

out vec3 eye_place;
out vec3 normal;

void main() {
  int number_of_piece = gl_VertexID / 3;
  ivec4 piece = texelFetch(pieces, number_of_piece);
  int corner = piece[gl_VertexID % 3];
  element = piece.w;
  element_color = color_of(element);
  eye_place = eye_of(corner);
  normal = mat3(to_eye) * texelFetch(normals, has_vertex_normals ? corner : number_of_piece).xyz;
  gl_Position = is_drawn(element) ? shown(eye_place) : nowhere;
}
