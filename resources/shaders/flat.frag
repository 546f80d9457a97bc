// SPDX-License-Identifier: GPL-3.0-or-later
void main() { paint(1.0); }
