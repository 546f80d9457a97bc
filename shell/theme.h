// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QString>

#include "core/style.h"

namespace mesecina {

enum class Theme { system, light, dark };

/// Of the canvas, whatever the theme of the window is.
enum class Canvas_background { paper, dark, window };

/// Dresses the whole application. There is one, made before the first window.
class Theme_switch {
 public:
  /// Remembers what the system looks like.
  Theme_switch();

  /// light and dark are Fusion in our palettes; system is what the desktop chose.
  void apply(Theme theme);
  Theme theme() const { return theme_; }

 private:
  QString system_style_;
  QPalette system_palette_;
  Theme theme_ = Theme::system;
};

Color canvas_color(Canvas_background background, const QPalette& palette);

/// A colour that is seen on the background: the colour itself, or, where that is nearly as dark as a dark background,
/// its mirror image in lightness, of the same hue.
Color visible_on(Color background, Color color);

}  // namespace mesecina
