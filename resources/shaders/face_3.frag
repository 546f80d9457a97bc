// SPDX-License-Identifier: GPL-3.0-or-later
in vec3 eye_place;
in vec3 normal;

void main() {
  if (is_sliced_off(eye_place)) discard;
  paint(vec4(lit(element_color.rgb, normal, eye_place), element_color.a), gl_FragCoord.z);
}
