// SPDX-License-Identifier: GPL-3.0-or-later
// What all elements in space share: the cutting plane, light, and how a pixel is painted. Precedes the shader of each
// kind. With IDS defined, numbers are painted in place of colours.

uniform bool perspective;
uniform int plane_count;
uniform vec4 planes[2];  // in eye coordinates; what is left is where they are not negative

flat in vec4 element_color;
flat in int element;

bool is_sliced_off(vec3 place) {
  for (int i = 0; i < plane_count; ++i)
    if (dot(planes[i], vec4(place, 1)) < 0.0) return true;
  return false;
}

#ifdef IDS

uniform int number_of_layer;

layout(location = 0) out uvec2 painted;

vec3 lit(vec3 base, vec3 normal, vec3 place) { return base; }

void paint(vec4 paint_color, float depth) { painted = uvec2(number_of_layer, element); }

#else

uniform bool peeling;     // only what lies before the solid things and behind the nearer picture
uniform bool has_nearer;
uniform sampler2D solid_depth;
uniform sampler2D nearer_depth;

layout(location = 0) out vec4 painted;

// Both sides of a surface look the same. The light comes from beside the viewer, weaker from the other side.
vec3 lit(vec3 base, vec3 normal, vec3 place) {
  const vec3 main_light = normalize(vec3(-0.35, 0.45, 0.82));
  const vec3 second_light = normalize(vec3(0.7, -0.15, 0.55));
  vec3 to_viewer = perspective ? normalize(-place) : vec3(0, 0, 1);
  float size = length(normal);
  vec3 facing = size > 0.0 ? normal / size : to_viewer;
  if (dot(facing, to_viewer) < 0.0) facing = -facing;
  float sky = 0.5 + 0.5 * facing.y;
  float bright = 0.36 + 0.08 * sky + 0.60 * max(dot(facing, main_light), 0.0) + 0.16 * max(dot(facing, second_light), 0.0);
  float gloss = pow(max(dot(facing, normalize(main_light + to_viewer)), 0.0), 48.0);
  return base * bright + 0.10 * gloss;
}

void paint(vec4 paint_color, float depth) {
  if (peeling) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (depth >= texelFetch(solid_depth, pixel, 0).r) discard;
    if (has_nearer && depth <= texelFetch(nearer_depth, pixel, 0).r) discard;
  }
  painted = vec4(paint_color.rgb * paint_color.a, paint_color.a);
}

#endif
