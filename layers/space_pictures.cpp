// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/space_pictures.h"

#include <epoxy/gl.h>

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <ostream>
#include <stdexcept>
#include <vector>

#include "layers/egl_context.h"
#include "layers/gl_objects.h"
#include "layers/painter_canvas.h"
#include "layers/picture_formats.h"
#include "layers/space_vectors.h"
#include "layers/video_writer.h"

namespace mesecina {

namespace {

constexpr int samples = 2;
constexpr int usual_tile = 2048;
/// Of each tile around what is kept: outlines are found from neighbouring pixels.
constexpr int margin = 4;

/// Copies rows of OpenGL, from below, into the picture.
void paste(QImage& picture, const std::vector<std::uint8_t>& pixels, const Tile& tile, const Tile& kept) {
  for (int row = 0; row < kept.height; ++row) {
    const int from_below = kept.bottom + row;
    const std::size_t source =
        4 * (static_cast<std::size_t>(from_below - tile.bottom) * static_cast<std::size_t>(tile.width) +
             static_cast<std::size_t>(kept.left - tile.left));
    std::memcpy(picture.scanLine(picture.height() - 1 - from_below) + std::ptrdiff_t{4} * kept.left,
                pixels.data() + source, static_cast<std::size_t>(kept.width) * 4);
  }
}

/// The context and its renderer, made when first asked for.
class Windowless_renderer {
 public:
  ~Windowless_renderer() {
    if (!renderer_) return;
    try {
      context_->make_current();
    } catch (const std::exception&) {
      return;
    }
    renderer_.reset();
    context_->release();
  }

  /// Throws std::runtime_error when there can be none.
  QImage paint(const Scene& scene, const View_3& view, int width, int height) {
    const std::lock_guard lock(mutex_);
    start_application();
    if (!context_) context_ = std::make_unique<Egl_context>();
    context_->make_current();
    try {
      if (!renderer_) renderer_ = std::make_unique<Gl_renderer_3>();
      QImage picture = paint_space_picture(*renderer_, scene, view, width, height);
      context_->release();
      return picture;
    } catch (...) {
      context_->release();
      throw;
    }
  }

  /// So that there can be text.
  void start_application() {
    const std::lock_guard lock(starting_);
    if (!application_) application_ = std::make_unique<Picture_application>();
  }

 private:
  std::mutex mutex_;     ///< of the context
  std::mutex starting_;  ///< of the application
  std::unique_ptr<Picture_application> application_;
  std::unique_ptr<Egl_context> context_;
  std::unique_ptr<Gl_renderer_3> renderer_;
};

void write_vectors(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
  try {
    write_file(file, write);
  } catch (const std::invalid_argument& error) {
    throw File_error(file, 0, error.what());
  }
}

}  // namespace

std::string reason_against_space_pictures() {
  try {
    Egl_context context;
    context.make_current();
    const int version = epoxy_gl_version();
    context.release();
    constexpr int needed = 33;
    return version < needed ? "OpenGL 3.3 is needed" : std::string();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

QImage paint_space_picture(Gl_renderer_3& renderer, const Scene& scene, const View_3& view, int width, int height) {
  QImage picture(width, height, QImage::Format_RGBA8888_Premultiplied);
  if (picture.isNull()) throw std::bad_alloc();
  const int side = std::min(usual_tile, renderer.largest_side() / samples);
  const Gl_target target(std::min(side, width + 2 * margin), std::min(side, height + 2 * margin));
  const int step_x = target.width() - 2 * margin;
  const int step_y = target.height() - 2 * margin;
  std::vector<std::uint8_t> pixels(std::size_t{4} * static_cast<std::size_t>(target.width()) *
                                   static_cast<std::size_t>(target.height()));
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  for (int bottom = 0; bottom < height; bottom += step_y) {
    for (int left = 0; left < width; left += step_x) {
      const Tile kept{left, bottom, std::min(step_x, width - left), std::min(step_y, height - bottom)};
      const Tile tile{left - margin, bottom - margin, target.width(), target.height()};
      Frame_3 frame{width, height};
      frame.samples = samples;
      frame.tile = tile;
      glViewport(0, 0, tile.width, tile.height);
      renderer.draw(scene, {}, view, frame);
      glPixelStorei(GL_PACK_ALIGNMENT, 4);
      glReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
      paste(picture, pixels, tile, kept);
    }
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  QPainter painter(&picture);
  paint_color_bars(painter, scene, width, height);
  painter.end();
  if (!scene.transparent_background) picture.convertTo(QImage::Format_RGB32);
  return picture;
}

void add_space_picture_formats(Formats& formats) {
  const auto renderer = std::make_shared<Windowless_renderer>();
  formats.picture_writers.push_back(
      {"png",
       "png",
       "PNG picture, with smooth edges, of any size",
       {},
       [renderer](const std::filesystem::path& file, const Scene& scene, const View_3& view, int width, int height) {
         check_picture_size(file, width, height);
         std::string bytes;
         try {
           bytes = png_bytes(renderer->paint(scene, view, width, height));
         } catch (const std::runtime_error& error) {
           throw File_error(file, 0, "no picture can be drawn: " + std::string(error.what()));
         }
         write_file(file, [&](std::ostream& out) { out << bytes; });
       }});
  formats.make_film = [renderer](const Film_request& request) {
    return make_video(request, [renderer](const Film_frame& frame, int width, int height) {
      return renderer->paint(frame.scene, frame.view_3, width, height);
    });
  };
  formats.picture_writers.push_back(
      {"svg",
       "svg",
       "SVG 1.1 of up to 20000 faces, lines, points and balls, with groups named by layers",
       {},
       [](const std::filesystem::path& file, const Scene& scene, const View_3& view, int width, int height) {
         check_picture_size(file, width, height);
         write_vectors(file, [&](std::ostream& out) { write_space_svg(out, scene, view, width, height); });
       }});
  formats.picture_writers.push_back(
      {"pdf",
       "pdf",
       "PDF of up to 20000 faces, lines, points and balls, 96 pixels to the inch",
       {},
       [renderer](const std::filesystem::path& file, const Scene& scene, const View_3& view, int width, int height) {
         check_picture_size(file, width, height);
         renderer->start_application();
         write_vectors(file, [&](std::ostream& out) { out << space_pdf_bytes(scene, view, width, height); });
       }});
}

}  // namespace mesecina
