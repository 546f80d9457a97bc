// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/software_pictures.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <stdexcept>

#include "layers/canvas_surface.h"
#include "layers/color_map.h"

namespace mesecina {

namespace {

/// Filled shapes from which on QPainter is slower.
constexpr std::size_t many_shapes = 200;

std::size_t shapes_slow_to_fill(const Scene_layer& layer) {
  if (!layer.style.visible || !layer.style.filled || !layer.primitives) return 0;
  const Primitive_set& set = *layer.primitives;
  const std::size_t disks = layer.style.opacity < 1 ? set.balls.size() : 0;
  return set.triangles.size() + set.polygon_count() + set.arcs.size() + disks;
}

}  // namespace

bool is_sooner_by_opengl(const Scene& scene) {
  std::size_t shapes = 0;
  for (const Scene_layer& layer : scene.layers) shapes += shapes_slow_to_fill(layer);
  return shapes >= many_shapes;
}

struct Software_pictures::State {
  QOffscreenSurface surface;
  QOpenGLContext context;
  std::unique_ptr<Gl_renderer_2> renderer;
  std::unique_ptr<QOpenGLFramebufferObject> samples;
  std::unique_ptr<QOpenGLFramebufferObject> picture;
  bool has_failed = false;

  bool make_current() {
    if (has_failed) return false;
    if (renderer) return context.makeCurrent(&surface);
    context.setFormat(canvas_format(0));
    has_failed = !context.create();
    if (has_failed) return false;
    surface.setFormat(context.format());
    surface.create();
    has_failed = !surface.isValid() || !context.makeCurrent(&surface);
    if (has_failed) return false;
    try {
      renderer = std::make_unique<Gl_renderer_2>();
    } catch (const std::exception&) {
      has_failed = true;
      context.doneCurrent();
    }
    return !has_failed;
  }

  void fit(const QSize& size) {
    if (picture && picture->size() == size) return;
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    picture = std::make_unique<QOpenGLFramebufferObject>(size, format);
    format.setSamples(samples_for_fills);
    samples = std::make_unique<QOpenGLFramebufferObject>(size, format);
  }
};

Software_pictures::Software_pictures() : state_(std::make_unique<State>()) {}

Software_pictures::~Software_pictures() {
  if (!state_->renderer || !state_->context.makeCurrent(&state_->surface)) return;
  state_->renderer.reset();
  state_->samples.reset();
  state_->picture.reset();
  state_->context.doneCurrent();
}

QImage Software_pictures::paint(const Scene& scene, const View_2& view, const Gl_renderer_2::Frame& frame) {
  State& s = *state_;
  if (frame.width <= 0 || frame.height <= 0 || !s.make_current()) return {};
  s.fit({frame.width, frame.height});
  Scene opaque = scene;
  opaque.transparent_background = false;
  s.samples->bind();
  s.renderer->draw(opaque, {}, view, frame);
  QOpenGLFramebufferObject::blitFramebuffer(s.picture.get(), s.samples.get());
  QImage image = s.picture->toImage();
  s.picture->release();
  s.context.doneCurrent();
  return image.convertToFormat(QImage::Format_RGB32);
}

std::size_t Software_pictures::uploaded_bytes() const {
  return state_->renderer ? state_->renderer->uploaded_bytes() : 0;
}

}  // namespace mesecina
