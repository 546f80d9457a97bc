// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QString>

#include "core/canvas_background.h"

namespace mesecina {

enum class Theme { system, light, dark };

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

}  // namespace mesecina
