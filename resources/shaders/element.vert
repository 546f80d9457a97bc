// SPDX-License-Identifier: GPL-3.0-or-later
// What all elements in the plane share: place, selection by cut and thresholds. Precedes the shader of each kind.
// Pixels are device pixels from the middle of the picture, y up.

layout(location = 0) in float number;          // chooses the colour
layout(location = 1) in float threshold_rank;  // place among the sorted values; -1 for nan
layout(location = 2) in float cut_rank;

uniform vec2 half_size;
uniform float scale;
uniform vec2 offset;
uniform vec2 threshold_ranks;
uniform float lowest_cut_rank;

flat out vec4 element_color;

const vec4 nowhere = vec4(2, 2, 2, 1);

bool is_drawn() {
  return threshold_rank >= threshold_ranks.x && threshold_rank <= threshold_ranks.y && cut_rank >= lowest_cut_rank;
}

vec2 to_pixels(vec2 place) { return place * scale + offset; }

vec4 at_pixel(vec2 pixel) { return vec4(pixel / half_size, 0, 1); }

vec4 color_of_number(float rank) { return color_by(number, rank); }
