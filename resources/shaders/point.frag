// SPDX-License-Identifier: GPL-3.0-or-later
flat in vec2 center;
flat in float radius;

void main() { paint(band(length(pixel() - center), radius)); }
