// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 area_normal;

in vec3 eye_place;

void main() { paint(vec4(lit(element_color.rgb * 0.8, area_normal, eye_place), element_color.a), gl_FragCoord.z); }
