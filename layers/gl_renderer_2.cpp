// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_renderer_2.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "layers/gl_look.h"
#include "layers/gl_primitives_2.h"
#include "layers/gl_shader_sources.h"

namespace mesecina {

namespace {

/// Attributes from this location on, of so many floats each.
constexpr unsigned first_geometry_location = 3;
constexpr unsigned end_of_locations = 7;
constexpr std::array point_sizes{2};
constexpr std::array segment_sizes{4};
constexpr std::array circle_sizes{3, 2};
constexpr std::array triangle_sizes{4, 2};
constexpr std::array far_circle_sizes{4, 4, 4, 1};
constexpr std::array circular_segment_sizes{4, 3, 2};
using Sizes = std::span<const int>;

/// Into how many quadrilaterals the strip along a circle is divided. Its corners stand out from the circle by about
/// r (pi / n)^2 / 2 pixels, two here. For small circles a square has fewer pixels to look at than many small pieces.
int pieces_of_circle(double radius, bool filled) {
  if (radius < (filled ? 40 : 16)) return 1;
  return std::clamp(static_cast<int>(std::ceil(1.6 * std::sqrt(radius))), 6, 64);
}

void bind_attribute(unsigned location, unsigned buffer, int size, int stride, std::size_t offset) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableVertexAttribArray(location);
  // OpenGL takes an offset in the guise of a pointer.
  glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, stride * static_cast<int>(sizeof(float)),
                        reinterpret_cast<const void*>(offset * sizeof(float)));
  glVertexAttribDivisor(location, 1);
}

void bind_geometry(unsigned buffer, Sizes sizes, std::size_t first) {
  int stride = 0;
  for (int size : sizes) stride += size;
  std::size_t offset = first * static_cast<std::size_t>(stride);
  unsigned location = first_geometry_location;
  for (int size : sizes) {
    bind_attribute(location++, buffer, size, stride, offset);
    offset += static_cast<std::size_t>(size);
  }
  for (; location < end_of_locations; ++location) glDisableVertexAttribArray(location);
}

void bind_no_attributes() {
  for (unsigned location = 0; location < end_of_locations; ++location) {
    glDisableVertexAttribArray(location);
    glVertexAttrib1f(location, 0);
  }
}

/// Turns the mark of every sample over that a shape covers; paints nothing.
void begin_parity() {
  glEnable(GL_STENCIL_TEST);
  glStencilMask(1);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glStencilFunc(GL_ALWAYS, 0, 1);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
}

/// Paints marked samples, and wipes the mark of those painted, so that none is painted twice.
void paint_parity() {
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilFunc(GL_EQUAL, 1, 1);
  glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
}

}  // namespace

struct Gl_renderer_2::State {
  Gl_program points{{shaders::color_map_vert, shaders::element_vert, shaders::point_vert},
                    {shaders::coverage_frag, shaders::point_frag}};
  Gl_program segments{{shaders::color_map_vert, shaders::element_vert, shaders::segment_vert},
                      {shaders::coverage_frag, shaders::segment_frag}};
  Gl_program circles{{shaders::color_map_vert, shaders::element_vert, shaders::circle_vert},
                     {shaders::coverage_frag, shaders::circle_frag}};
  Gl_program far_circles{{shaders::color_map_vert, shaders::element_vert, shaders::far_circle_vert},
                         {shaders::coverage_frag, shaders::far_circle_frag}};
  Gl_program triangles{{shaders::color_map_vert, shaders::element_vert, shaders::triangle_vert},
                       {shaders::coverage_frag, shaders::flat_frag}};
  Gl_program circular_segments{{shaders::color_map_vert, shaders::element_vert, shaders::circular_segment_vert},
                               {shaders::coverage_frag, shaders::flat_frag}};
  Gl_program covers{{shaders::cover_vert}, {shaders::coverage_frag, shaders::flat_frag}};
  Gl_program images{{shaders::cover_vert}, {shaders::image_frag}};
  unsigned vertex_array = 0;
  std::optional<Gl_target> disks;  ///< translucent ones of one layer, drawn opaque before they are painted together

  std::map<const Primitive_set*, Gl_primitives> primitives;
  Color_map_textures color_maps;
  std::size_t other_bytes = 0;

  View_2 view;
  Frame frame;
  double scale = 1;  ///< device pixels per unit

  State() { glGenVertexArrays(1, &vertex_array); }
  ~State() { glDeleteVertexArrays(1, &vertex_array); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void begin(const View_2& seen, const Frame& page);
  static void end();
  Gl_primitives& primitives_of(const std::shared_ptr<const Primitive_set>& set);
  void draw_layer(const Scene_layer& layer);
  void draw_image(const Image& image, unsigned texture, double opacity);
  void draw_part(const Scene_layer& layer, const Gl_look& look, Gl_primitives& buffers, Part part);
  void draw_polygons(const Scene_layer& layer, const Gl_look& look, Gl_primitives& buffers, Gl_batch& batch);
  void draw_disks_evenly(const Scene_layer& layer, const Gl_look& look, Gl_primitives& buffers);
  void draw_arc_fill(const Scene_layer& layer, Gl_primitives& buffers);
  void place_by(Gl_program& program, const Point_2& origin);
  void begin_program(Gl_program& program, const Scene_layer& layer, const Gl_look& look, const Point_2& origin);
  void bind_batch(const Primitive_set& set, const Gl_look& look, Gl_primitives& buffers, Gl_batch& batch, Sizes sizes,
                  std::size_t first);
};

Gl_primitives& Gl_renderer_2::State::primitives_of(const std::shared_ptr<const Primitive_set>& set) {
  const auto known = primitives.find(set.get());
  if (known != primitives.end()) {
    if (known->second.is_of(set)) return known->second;
    other_bytes += known->second.uploaded_bytes();
    primitives.erase(known);
  }
  return primitives.emplace(set.get(), Gl_primitives(set)).first->second;
}

void Gl_renderer_2::State::place_by(Gl_program& program, const Point_2& origin) {
  program.set("half_size", std::array{frame.width / 2.0F, frame.height / 2.0F});
  program.set("scale", static_cast<float>(scale));
  program.set("offset", std::array{static_cast<float>((origin.x - view.center.x) * scale),
                                   static_cast<float>((origin.y - view.center.y) * scale)});
}

void Gl_renderer_2::State::begin_program(Gl_program& program, const Scene_layer& layer, const Gl_look& look,
                                         const Point_2& origin) {
  const Style& style = layer.style;
  program.use();
  place_by(program, origin);
  set_look(program, layer, look);
  program.set("filled", style.filled);
  program.set("half_width", static_cast<float>(style.line_width * frame.pixel_ratio / 2));
  program.set("point_radius", static_cast<float>(style.point_size * frame.pixel_ratio / 2));
  program.set("flat_ends", style.opacity < 1);
}

void Gl_renderer_2::State::bind_batch(const Primitive_set& set, const Gl_look& look, Gl_primitives& buffers,
                                      Gl_batch& batch, Sizes sizes, std::size_t first) {
  const auto scalar = [&](unsigned location, bool used, const std::string& name, std::size_t place) {
    if (used) {
      bind_attribute(location, buffers.number_buffer(set, batch, name), 1, 2, 2 * first + place);
    } else {
      glDisableVertexAttribArray(location);
      glVertexAttrib1f(location, 0);
    }
  };
  scalar(0, look.rule != Color_rule::one_color, look.number, 0);
  scalar(1, !look.threshold.empty(), look.threshold, 1);
  scalar(2, !look.cut.empty(), look.cut, 1);
  bind_geometry(batch.geometry.id(), sizes, first);
}

void Gl_renderer_2::State::draw_polygons(const Scene_layer& layer, const Gl_look& look, Gl_primitives& buffers,
                                         Gl_batch& batch) {
  const Primitive_set& set = *layer.primitives;
  begin_program(triangles, layer, look, batch.instances.origin);
  for (const Polygon_run& run : buffers.runs(layer, batch)) {
    bind_batch(set, look, buffers, batch, triangle_sizes, run.first);
    const auto draw = [&] { glDrawArraysInstanced(GL_TRIANGLES, 0, 3, static_cast<int>(run.count)); };
    if (run.is_plain) {
      draw();
      continue;
    }
    begin_parity();
    draw();
    paint_parity();
    draw();
    glDisable(GL_STENCIL_TEST);
  }
}

void Gl_renderer_2::State::draw_arc_fill(const Scene_layer& layer, Gl_primitives& buffers) {
  const Gl_arc_fill& fill = buffers.arc_fill(layer, view.center, scale, std::hypot(frame.width, frame.height) / 2);
  if (fill.triangle_count == 0 && fill.runs.empty()) return;
  bind_no_attributes();
  begin_parity();
  if (fill.triangle_count > 0) {
    begin_program(triangles, layer, {}, fill.origin);
    bind_geometry(fill.triangles.id(), triangle_sizes, 0);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 3, static_cast<int>(fill.triangle_count));
  }
  circular_segments.use();
  place_by(circular_segments, fill.origin);
  for (const Segment_run& run : fill.runs) {
    const int corners = corners_of_segment(run, scale);
    if (corners < 3) continue;
    circular_segments.set("corners", corners);
    bind_geometry(fill.segments.id(), circular_segment_sizes, run.first);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 3 * (corners - 2), static_cast<int>(run.count));
  }
  paint_parity();
  covers.use();
  covers.set("rectangle", std::array{-1.0F, -1.0F, 1.0F, 1.0F});
  covers.set("color", to_floats(layer.style.color, layer.style.opacity));
  bind_no_attributes();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisable(GL_STENCIL_TEST);
}

void Gl_renderer_2::State::draw_disks_evenly(const Scene_layer& layer, const Gl_look& look, Gl_primitives& buffers) {
  int shown = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &shown);
  if (!disks || disks->width() != frame.width || disks->height() != frame.height)
    disks.emplace(frame.width, frame.height);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, disks->id());
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  Scene_layer opaque = layer;
  opaque.style.opacity = 1;
  draw_part(opaque, look, buffers, Part::balls);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<unsigned>(shown));
  images.use();
  images.set("rectangle", std::array{-1.0F, -1.0F, 1.0F, 1.0F});
  images.set("texture_rectangle", std::array{0.0F, 0.0F, 1.0F, 1.0F});
  images.set("color", to_floats({}, layer.style.opacity));
  images.set("image", 0);
  glBindTexture(GL_TEXTURE_2D, disks->texture());
  bind_no_attributes();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Gl_renderer_2::State::draw_part(const Scene_layer& layer, const Gl_look& look, Gl_primitives& buffers, Part part) {
  const Primitive_set& set = *layer.primitives;
  const double half_diagonal =
      std::hypot(frame.width, frame.height) / 2 + (layer.style.line_width + layer.style.point_size) * frame.pixel_ratio;
  const auto [near, far, is_whole] = buffers.batches(set, part, view.center, scale, half_diagonal);
  const auto draw = [&](Gl_program& program, Gl_batch& batch, Sizes sizes, unsigned mode, int vertices) {
    bind_batch(set, look, buffers, batch, sizes, 0);
    program.set("pieces", vertices / 2 - 1);
    glDrawArraysInstanced(mode, 0, vertices, batch.count());
  };
  if (near && near->count() > 0) {
    switch (part) {
      case Part::points:
        begin_program(points, layer, look, near->instances.origin);
        draw(points, *near, point_sizes, GL_TRIANGLE_STRIP, 4);
        break;
      case Part::segments:
      case Part::triangle_edges:
      case Part::polygon_edges:
      case Part::rays:
        begin_program(segments, layer, look, near->instances.origin);
        segments.set("is_ray", part == Part::rays && is_whole);
        draw(segments, *near, segment_sizes, GL_TRIANGLE_STRIP, 4);
        break;
      case Part::arcs:
      case Part::balls: {
        begin_program(circles, layer, look, near->instances.origin);
        if (part == Part::arcs) circles.set("filled", false);
        const int pieces = pieces_of_circle(near->typical_radius * scale, part == Part::balls && layer.style.filled);
        draw(circles, *near, circle_sizes, GL_TRIANGLE_STRIP, 2 * pieces + 2);
        break;
      }
      case Part::triangles:
        begin_program(triangles, layer, look, near->instances.origin);
        draw(triangles, *near, triangle_sizes, GL_TRIANGLES, 3);
        break;
      case Part::polygons:
        draw_polygons(layer, look, buffers, *near);
        break;
    }
  }
  if (far) {
    begin_program(far_circles, layer, look, far->instances.origin);
    if (part == Part::arcs) far_circles.set("filled", false);
    constexpr int pieces = 32;
    draw(far_circles, *far, far_circle_sizes, GL_TRIANGLE_STRIP, 2 * pieces + 2);
  }
}

void Gl_renderer_2::State::draw_image(const Image& image, unsigned texture, double opacity) {
  // Only the visible part, computed in double: at a deep zoom a corner may be 1e9 pixels away.
  const auto visible = [](double low, double size, double half) {
    const double first = std::clamp(-half, low, low + size);
    const double last = std::clamp(half, low, low + size);
    return std::array{first / half, last / half, (first - low) / size, (last - low) / size};
  };
  const double pixel = image.pixel_size * scale;
  const auto [left, right, u0, u1] =
      visible((image.lower_left.x - view.center.x) * scale, pixel * image.width, frame.width / 2.0);
  const auto [bottom, top, v0, v1] =
      visible((image.lower_left.y - view.center.y) * scale, pixel * image.height, frame.height / 2.0);
  if (!(left < right && bottom < top)) return;
  const auto four = [](double a, double b, double c, double d) {
    return std::array{static_cast<float>(a), static_cast<float>(b), static_cast<float>(c), static_cast<float>(d)};
  };
  images.use();
  images.set("rectangle", four(left, bottom, right, top));
  images.set("texture_rectangle", four(u0, 1 - v0, u1, 1 - v1));
  images.set("color", four(0, 0, 0, opacity));
  images.set("image", 0);
  glBindTexture(GL_TEXTURE_2D, texture);
  bind_no_attributes();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Gl_renderer_2::State::draw_layer(const Scene_layer& layer) {
  const Style& style = layer.style;
  if (!style.visible || style.opacity <= 0 || !layer.primitives || layer.primitives->is_empty()) return;
  const Primitive_set& set = *layer.primitives;
  Gl_primitives& buffers = primitives_of(layer.primitives);
  if (const unsigned texture = buffers.image(set)) draw_image(*set.image, texture, style.opacity);
  const Gl_look look = look_of(layer, buffers.numbers(), color_maps);
  const Part polygon_part = style.filled ? Part::polygons : Part::polygon_edges;
  const Part triangle_part = style.filled ? Part::triangles : Part::triangle_edges;
  const bool are_disks_united = style.filled && style.opacity < 1 && look.rule == Color_rule::one_color;
  if (are_disks_united && !set.balls.empty()) {
    draw_disks_evenly(layer, look, buffers);
  } else {
    draw_part(layer, look, buffers, Part::balls);
  }
  for (Part part : {polygon_part, triangle_part}) draw_part(layer, look, buffers, part);
  if (style.filled && !set.arcs.empty()) draw_arc_fill(layer, buffers);
  for (Part part : {Part::arcs, Part::rays, Part::segments, Part::points}) draw_part(layer, look, buffers, part);
}

Gl_renderer_2::Gl_renderer_2() {
  if (epoxy_gl_version() < 33) {
    const int version = epoxy_gl_version();
    throw std::runtime_error("OpenGL is " + std::to_string(version / 10) + "." + std::to_string(version % 10) +
                             ", 3.3 is needed");
  }
  state_ = std::make_unique<State>();
}

Gl_renderer_2::~Gl_renderer_2() = default;

void Gl_renderer_2::State::begin(const View_2& seen, const Frame& page) {
  view = seen;
  frame = page;
  scale = view.scale * frame.pixel_ratio;
  std::erase_if(primitives, [&](const auto& entry) {
    if (!entry.second.is_expired()) return false;
    other_bytes += entry.second.uploaded_bytes();
    return true;
  });
  glViewport(0, 0, frame.width, frame.height);
  glBindVertexArray(vertex_array);
  glActiveTexture(GL_TEXTURE0);
  glEnable(GL_MULTISAMPLE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (unsigned feature : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_CULL_FACE}) glDisable(feature);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilMask(~0U);
}

void Gl_renderer_2::State::end() {
  glDisable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ZERO);
  glStencilMask(~0U);
  glStencilFunc(GL_ALWAYS, 0, ~0U);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glBindTexture(GL_TEXTURE_1D, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glBindVertexArray(0);
  glUseProgram(0);
}

void Gl_renderer_2::draw(const Scene& scene, std::span<const Scene_layer> overlay, const View_2& view,
                         const Frame& frame) {
  State& s = *state_;
  s.begin(view, frame);
  glClearStencil(0);
  const float alpha = scene.transparent_background ? 0 : 1;
  const Color& ground = scene.background;
  glClearColor(alpha * ground.red / 255.0F, alpha * ground.green / 255.0F, alpha * ground.blue / 255.0F, alpha);
  glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);

  for (const Scene_layer& layer : scene.layers) s.draw_layer(layer);
  for (const Scene_layer& layer : overlay) s.draw_layer(layer);
  State::end();
}

std::size_t Gl_renderer_2::uploaded_bytes() const {
  std::size_t sum = state_->other_bytes + state_->color_maps.uploaded_bytes();
  for (const auto& [set, buffers] : state_->primitives) sum += buffers.uploaded_bytes();
  return sum;
}

std::string Gl_renderer_2::description() const {
  const int version = epoxy_gl_version();
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return "OpenGL " + std::to_string(version / 10) + "." + std::to_string(version % 10) + " (" +
         (renderer ? renderer : "unknown") + ")";
}

}  // namespace mesecina
