#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
uniform sampler2D layer;

out vec4 result;

void main() { result = texelFetch(layer, ivec2(gl_FragCoord.xy), 0); }
