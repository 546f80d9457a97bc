#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later

uniform sampler2D image;  // premultiplied

flat in vec4 element_color;
in vec2 texture_place;
out vec4 result;

void main() { result = texture(image, texture_place) * element_color.a; }
