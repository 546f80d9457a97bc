// SPDX-License-Identifier: GPL-3.0-or-later
// What all elements in space share: place, selection by cut and thresholds, colour. Follows color_map.vert, precedes the
// shader of each kind. Everything is read from tables by gl_VertexID. Eye coordinates: x to the right, y up, z towards
// the viewer.

uniform samplerBuffer places;
uniform isamplerBuffer pieces;          // places and, at last, the element
uniform samplerBuffer numbers;          // number and rank of each element, as are the two below
uniform samplerBuffer threshold_numbers;
uniform samplerBuffer cut_numbers;
uniform bool has_numbers;
uniform bool has_threshold;
uniform bool has_cut;
uniform vec2 threshold_ranks;
uniform float lowest_cut_rank;

uniform mat4 to_eye;
uniform mat4 projection;
uniform bool perspective;
uniform float pixel_size;  // of a device pixel in units of the scene: at distance 1, or everywhere without perspective
uniform vec2 picture_size; // device pixels
uniform float nearest;     // distance of the near plane
uniform float layer_lift;  // of depth, so that of layers in one place the upper one is seen

flat out vec4 element_color;
flat out int element;

const vec4 nowhere = vec4(2, 2, 2, 1);

bool is_drawn(int candidate) {
  if (has_threshold) {
    float rank = texelFetch(threshold_numbers, candidate).g;
    if (rank < threshold_ranks.x || rank > threshold_ranks.y) return false;
  }
  return !has_cut || texelFetch(cut_numbers, candidate).g >= lowest_cut_rank;
}

vec4 color_of(int candidate) {
  vec2 number = has_numbers ? texelFetch(numbers, candidate).rg : vec2(0);
  return color_by(number.r, number.g);
}

vec3 eye_of(int place) { return (to_eye * vec4(texelFetch(places, place).xyz, 1)).xyz; }

// Towards the viewer by so many pixels, to the same pixel.
vec3 lifted(vec3 eye, float pixels) {
  return perspective ? eye * (1.0 - min(pixels * pixel_size, 0.5)) : eye + vec3(0, 0, pixels * pixel_size);
}

vec4 shown(vec3 eye) {
  vec4 place = projection * vec4(eye, 1);
  place.z -= layer_lift * place.w;
  return place;
}
