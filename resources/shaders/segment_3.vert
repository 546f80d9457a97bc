// SPDX-License-Identifier: GPL-3.0-or-later
uniform float half_width;
uniform float shade;  // of the colour; lines on a face of their colour are darker than it

flat out vec2 from;  // pixels
flat out vec2 to;
out vec3 eye_place;

void main() {
  ivec4 piece = texelFetch(pieces, gl_VertexID / 6);
  int corner = gl_VertexID % 6;
  bool is_end = corner == 1 || corner == 2 || corner == 4;
  float side = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
  element = piece.w;
  element_color = color_of(element);
  element_color.rgb *= shade;
  vec3 first = eye_of(piece.x);
  vec3 last = eye_of(piece.y);
  from = to = vec2(0);
  eye_place = first;
  gl_Position = nowhere;
  if (!is_drawn(element)) return;
  if (perspective) {
    // What is behind the viewer has no place in the picture.
    if (max(-first.z, -last.z) <= nearest) return;
    if (-first.z < nearest) first = mix(last, first, (-last.z - nearest) / (first.z - last.z));
    if (-last.z < nearest) last = mix(first, last, (-first.z - nearest) / (last.z - first.z));
  }
  vec4 start = shown(lifted(first, 1.5 * half_width));
  vec4 end = shown(lifted(last, 1.5 * half_width));
  from = (start.xy / start.w * 0.5 + 0.5) * picture_size;
  to = (end.xy / end.w * 0.5 + 0.5) * picture_size;
  vec2 along = to - from;
  float size = length(along);
  along = size > 0.0 ? along / size : vec2(1, 0);
  vec2 pixel = (is_end ? to : from) + (half_width + 1.0) * (side * vec2(-along.y, along.x) + (is_end ? along : -along));
  vec4 place = is_end ? end : start;
  eye_place = is_end ? last : first;
  gl_Position = vec4((pixel / picture_size * 2.0 - 1.0) * place.w, place.zw);
}
