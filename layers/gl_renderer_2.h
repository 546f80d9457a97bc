// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/style.h"

namespace mesecina {

/// Draws scenes by OpenGL 3.3 into the framebuffer that is bound, which should have a stencil and several samples.
/// Makes no context itself. All functions, the destructor too, need the one current in which it was made.
class Gl_renderer_2 {
 public:
  struct Frame {
    int width = 0;  ///< device pixels
    int height = 0;
    double pixel_ratio = 1;  ///< device pixels per logical pixel
  };

  /// Throws std::runtime_error if the context is older than 3.3 or does not take the shaders.
  Gl_renderer_2();
  ~Gl_renderer_2();

  /// Paints the background and the visible layers, then the overlay's. The result is premultiplied by alpha; the state
  /// of the context is left as a new context has it, but for the viewport. Primitive_sets of earlier calls that still
  /// exist are not uploaded again; the others' memory is freed.
  void draw(const Scene& scene, std::span<const Scene_layer> overlay, const View_2& view, const Frame& frame);

  /// Bytes of geometry, values, colour maps and images sent since it was made.
  std::size_t uploaded_bytes() const;
  /// "OpenGL 4.5 (llvmpipe ...)"
  std::string description() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mesecina
