// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <cstddef>
#include <memory>

#include "layers/gl_renderer_2.h"

namespace mesecina {

/// Whether OpenGL without a graphics card paints the scene sooner than QPainter does. It does with many filled
/// triangles, polygons and loops of arcs, and with translucent disks; everything else QPainter paints in a fraction of
/// the time. O(number of layers).
bool is_sooner_by_opengl(const Scene& scene);

/// Pictures of scenes by an OpenGL that has no graphics card, outside of windows: as the content of a window its
/// pixels would be copied more often, those of the rest of the window too.
class Software_pictures {
 public:
  Software_pictures();
  ~Software_pictures();

  /// Without overlay and transparency. Null where there turns out to be no OpenGL 3.3. The first one makes the context,
  /// which takes some 50 ms. Buffers of Primitive_sets are kept as Gl_renderer_2 keeps them.
  QImage paint(const Scene& scene, const View_2& view, const Gl_renderer_2::Frame& frame);
  /// As Gl_renderer_2 counts.
  std::size_t uploaded_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mesecina
