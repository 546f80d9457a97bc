// SPDX-License-Identifier: GPL-3.0-or-later
// What all elements in space share: the cutting plane, light, and how a pixel is painted. Precedes the shader of each
// kind. With IDS defined, numbers are painted in place of colours; with PEELING, only what lies before the solid things and
// behind the nearer picture; without PLANES nothing is cut. These are definitions since where there is no graphics card
// both branches of every condition are executed.

uniform bool perspective;
#ifdef PLANES
uniform int plane_count;
#else
const int plane_count = 0;
#endif
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

#ifdef PEELING
uniform bool has_nearer;
uniform sampler2D solid_depth;
uniform sampler2D nearer_depth;
#endif

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
  float mirrored = max(dot(facing, normalize(main_light + to_viewer)), 0.0);
  float power_3 = mirrored * mirrored * mirrored;
  float power_6 = power_3 * power_3;
  float power_12 = power_6 * power_6;
  float power_24 = power_12 * power_12;
  return base * bright + 0.10 * power_24 * power_24;
}

void paint(vec4 paint_color, float depth) {
#ifdef PEELING
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (depth >= texelFetch(solid_depth, pixel, 0).r) discard;
  if (has_nearer && depth <= texelFetch(nearer_depth, pixel, 0).r) discard;
#endif
  painted = vec4(paint_color.rgb * paint_color.a, paint_color.a);
}

#endif
