// SPDX-License-Identifier: GPL-3.0-or-later
uniform mat4 projection;
uniform bool filled;
uniform float line_width;  // of outlines: device pixels
uniform float pixel_size;
uniform float nearest;
uniform float layer_lift;
uniform float depth_span;  // between the planes near and far
uniform vec2 picture_size;

flat in vec3 center;
flat in float radius;

void main() {
  // From the pixel alone, so that a ball has the same depth there in all passes, whatever rectangle it is found in.
  vec2 place_in_picture = 2.0 * gl_FragCoord.xy / picture_size - 1.0;
  vec2 scales = vec2(projection[0][0], projection[1][1]);
  vec3 from = perspective ? vec3(0) : vec3((place_in_picture - projection[3].xy) / scales, 0);
  vec3 along = perspective ? normalize(vec3((place_in_picture + projection[2].xy) / scales, -1)) : vec3(0, 0, -1);
  vec3 to_center = center - from;
  float middle = dot(to_center, along);
  vec3 off = to_center - middle * along;
  float square = radius * radius - dot(off, off);
  if (square < 0.0) discard;
  float half_chord = sqrt(square);
  float hit = middle - half_chord;
  float last = middle + half_chord;
  if (!filled) {
    float inner = radius - line_width * pixel_size * (perspective ? middle : 1.0);
    if (inner > 0.0 && dot(off, off) < inner * inner) discard;
  }
  // Where the cutting plane enters the ball, its inside is seen as an area.
  vec3 normal = vec3(0);
  for (int i = 0; i < plane_count; ++i) {
    float side = dot(planes[i], vec4(from, 1));
    float rate = dot(planes[i].xyz, along);
    if (rate == 0.0) {
      if (side < 0.0) discard;
      continue;
    }
    float way = -side / rate;
    if (rate < 0.0) {
      last = min(last, way);
    } else if (way > hit) {
      hit = way;
      normal = -planes[i].xyz;
    }
  }
  float first = perspective ? nearest / max(-along.z, 1e-6) : -1e30;
  if (hit < first) {
    // The viewer is within: the far side is seen.
    hit = last;
    normal = vec3(0);
  }
  if (hit > last || hit < first) discard;
  vec3 place = from + hit * along;
  float deeper = 0.0;
  bool is_area = normal != vec3(0);
  // Of the areas of balls in one plane, that of the ball is seen in whose power cell the place is.
  if (is_area) deeper = 1e-4 * sqrt(max(0.0, radius * radius - dot(place - center, place - center))) / depth_span;
  else normal = (place - center) / radius;
  vec4 at = projection * vec4(place, 1);
  float depth = clamp((at.z / at.w - layer_lift) * 0.5 + 0.5 - deeper, 0.0, 1.0);
  gl_FragDepth = depth;
  vec3 color = filled ? lit(is_area ? element_color.rgb * 0.8 : element_color.rgb, normal, place) : element_color.rgb;
  paint(vec4(color, element_color.a), depth);
}
