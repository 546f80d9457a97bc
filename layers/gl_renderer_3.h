// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "core/style.h"
#include "core/view_3.h"
#include "layers/id_picture.h"
#include "layers/projection_3.h"

namespace mesecina {

/// Box of the visible layers of a scene; empty for nothing. O(vertices).
Box drawn_box(const Scene& scene);

/// Draws scenes in space by OpenGL 3.3: points and lines of constant width, lit faces, balls that are true spheres, all
/// with depth, translucent ones in the right order, cut open by a plane. Makes no context itself. All functions, the
/// destructor too, need the one current in which it was made.
class Gl_renderer_3 {
 public:
  /// Throws std::runtime_error if the context is older than 3.3 or does not take the shaders.
  Gl_renderer_3();
  ~Gl_renderer_3();

  /// Paints background and visible layers into the framebuffer that is bound, from the lower left corner of the
  /// viewport. In one place later layers are seen, and above all those of the overlay. The result is premultiplied by
  /// alpha; the state of the context is left as a new context has it, but for the viewport. Primitive_sets of earlier
  /// calls that still exist are not uploaded again; the others' memory is freed. Of the time, none goes by the number
  /// of elements but on the graphics card.
  void draw(const Scene& scene, std::span<const Scene_layer> overlay, const View_3& view, const Frame_3& frame);

  /// What is meant in every pixel of the picture that draw() paints: the nearest of the layers that are more than half
  /// opaque; where there is none, the nearest of the others. Reads it back, which costs some milliseconds.
  Id_picture ids(const Scene& scene, const View_3& view, const Frame_3& frame);

  /// Bytes of geometry, values and colour maps sent since it was made.
  std::size_t uploaded_bytes() const;
  /// Since it was made.
  std::size_t draw_calls() const;
  /// Longest side of a tile, in pixels times samples.
  int largest_side() const;
  /// "OpenGL 4.5 (llvmpipe ...)"
  std::string description() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mesecina
