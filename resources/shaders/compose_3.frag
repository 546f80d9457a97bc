#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The finished picture: what is translucent over what is solid, with dark lines where the depth of solid things jumps,
// and several samples made one pixel.

uniform sampler2D solid;
uniform sampler2D solid_depth;
uniform sampler2D translucent;
uniform bool has_translucent;
uniform int samples;     // along each side of a pixel
uniform int coarseness;  // pixels along each side that show one sample
uniform vec2 corner;  // of the picture on the target
uniform float outlines;  // 0: none, 1: black
uniform bool perspective;
uniform vec2 depths;  // of the near and the far plane

out vec4 result;

float away(ivec2 sample_place) {
  ivec2 last = textureSize(solid_depth, 0) - 1;
  float depth = texelFetch(solid_depth, clamp(sample_place, ivec2(0), last), 0).r;
  if (!perspective) return mix(depths.x, depths.y, depth);
  return depths.x * depths.y / mix(depths.y, depths.x, depth);
}

// 1 where the surface ends before one that is much farther: its last samples, not those beside it, are marked.
float edge(ivec2 sample_place) {
  float here = away(sample_place);
  float span = depths.y - depths.x;
  float jump = 0.0;
  for (int i = 0; i < 2; ++i) {
    ivec2 step = i == 0 ? ivec2(samples, 0) : ivec2(0, samples);
    float before = away(sample_place - step) - here;
    float behind = away(sample_place + step) - here;
    // On a slanted surface the two differ in sign only.
    jump = max(jump, max(before, behind) - 3.0 * max(0.0, -min(before, behind)));
  }
  return smoothstep(0.012, 0.05, jump / span);
}

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy - corner) / coarseness * samples;
  vec4 sum = vec4(0);
  for (int y = 0; y < samples; ++y) {
    for (int x = 0; x < samples; ++x) {
      ivec2 place = first + ivec2(x, y);
      vec4 below = texelFetch(solid, place, 0);
      if (outlines > 0.0) below.rgb *= 1.0 - outlines * edge(place);
      vec4 above = has_translucent ? texelFetch(translucent, place, 0) : vec4(0);
      sum += above + (1.0 - above.a) * below;
    }
  }
  result = sum / float(samples * samples);
}
