// SPDX-License-Identifier: GPL-3.0-or-later
// A square around the outline of the ball; the ball itself is found for each pixel.
uniform int first_element;

flat out vec3 center;
flat out float radius;

void main() {
  int number_of_ball = gl_VertexID / 6;
  int corner = gl_VertexID % 6;
  vec4 ball = texelFetch(places, number_of_ball);
  element = first_element + number_of_ball;
  element_color = color_of(element);
  center = (to_eye * vec4(ball.xyz, 1)).xyz;
  radius = ball.w;
  vec3 eye_place;
  gl_Position = nowhere;
  if (!is_drawn(element)) return;
  vec2 side = vec2(corner == 1 || corner == 2 || corner == 4 ? 1 : -1, corner == 2 || corner == 4 || corner == 5 ? 1 : -1);
  const float slack = 1.01;
  if (!perspective) {
    eye_place = center + vec3(side * radius * slack, 0);
  } else {
    float away = length(center);
    if (away <= radius * slack) {
      // From within, the whole picture.
      gl_Position = vec4(side, 0, 1);
      return;
    }
    vec3 back = center / away;
    vec3 right = normalize(abs(back.y) < 0.9 ? cross(vec3(0, 1, 0), back) : cross(vec3(1, 0, 0), back));
    float reach = slack * radius * away / sqrt((away - radius) * (away + radius));
    eye_place = center + reach * (side.x * right + side.y * cross(back, right));
  }
  // Near and far do not cut the square: they would cut off other parts than of the ball.
  vec4 place = projection * vec4(eye_place, 1);
  gl_Position = vec4(place.xy, 0, place.w);
}
