// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/style.h"

namespace mesecina {

/// What layers are painted on, whatever the theme of the window is.
enum class Canvas_background {
  paper,   ///< white
  dark,    ///< nearly black; dark colours of layers are lightened
  window,  ///< the colour of the window; in pictures made without one, that of the light theme
  none     ///< pictures have no background; in a window it looks like paper
};

/// "paper", "dark", "window", "none".
std::string_view name_of(Canvas_background background);
std::optional<Canvas_background> background_named(std::string_view name);

/// `window`: the colour of the window.
Color canvas_color(Canvas_background background, Color window);
/// The window's colour in the light theme.
inline constexpr Color light_window_color{0xf4, 0xf5, 0xf7};

/// A colour that is seen on the background: the colour itself, or, where that is nearly as dark as a dark background,
/// its mirror image in lightness, of the same hue.
Color visible_on(Color background, Color color);

/// The layers' colours as they are seen on the scene's background.
void make_visible_on_background(Scene& scene);

}  // namespace mesecina
