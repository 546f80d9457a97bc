// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_renderer_3.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "layers/gl_look.h"
#include "layers/gl_primitives_3.h"
#include "layers/gl_programs_3.h"
#include "layers/gl_shader_sources.h"

namespace mesecina {

namespace {

/// Of depth (from -1 to 1) between layers in one place. A float tells about 10^-7 there.
constexpr double lift_per_layer = 8e-7;
constexpr double lift_of_overlay = 4e-5;
constexpr float shade_of_edges = 0.45F;

using Planes = std::vector<std::array<float, 4>>;

bool is_drawn(const Scene_layer& layer) {
  return layer.style.visible && layer.style.opacity > 0 && layer.primitives && !layer.primitives->is_empty();
}

bool is_translucent(const Scene_layer& layer) { return layer.style.opacity < 1; }
bool is_solid(const Scene_layer& layer) { return !is_translucent(layer); }

/// What lies behind is meant by who points at it.
bool is_seen_through(const Scene_layer& layer) {
  constexpr double most_opacity = 0.5;
  return layer.style.opacity <= most_opacity;
}
bool is_meant(const Scene_layer& layer) { return !is_seen_through(layer); }

/// Which layers a pass paints.
using Choice = bool (*)(const Scene_layer&);

/// In eye coordinates; not negative where things are left.
Planes planes_of(const View_3& view, const Projection_3& projection) {
  Planes planes;
  if (!view.cutting_plane) return planes;
  const Cutting_plane_3& cut = *view.cutting_plane;
  const Point_3 normal = (1 / std::sqrt(dot(cut.normal, cut.normal))) * projection.direction_to_eye(cut.normal);
  const double offset = dot(normal, projection.to_eye(cut.point));
  const double half = cut.thickness.value_or(0) / 2;
  const auto add = [&](double sign) {
    planes.push_back({static_cast<float>(-sign * normal.x), static_cast<float>(-sign * normal.y),
                      static_cast<float>(-sign * normal.z), static_cast<float>(sign * offset + half)});
  };
  add(1);
  if (cut.thickness) add(-1);
  return planes;
}

Point_3 normal_of(const std::array<float, 4>& plane) { return {plane[0], plane[1], plane[2]}; }

std::array<float, 3> to_floats(const Point_3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

void bind_texture(int unit, unsigned texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
  glActiveTexture(GL_TEXTURE0);
}

/// The smaller frame whose pixels are enlarged to those of this one; the frame itself where none are.
Frame_3 coarse(const Frame_3& frame) {
  if (frame.coarseness <= 1 || frame.samples > 1 || frame.tile) return frame;
  Frame_3 result = frame;
  result.width = (frame.width + frame.coarseness - 1) / frame.coarseness;
  result.height = (frame.height + frame.coarseness - 1) / frame.coarseness;
  result.pixel_ratio = frame.pixel_ratio / frame.coarseness;
  return result;
}

/// Makes the target anew where there is none of this size.
void fit(std::optional<Gl_deep_target>& target, int width, int height, Gl_deep_target::Format format) {
  if (!target || target->width() != width || target->height() != height) target.emplace(width, height, format);
}

}  // namespace

struct Gl_renderer_3::State {
  /// Made when first used; of each two by whether there are planes.
  std::map<std::pair<Gl_programs_3::Paint, bool>, Gl_programs_3> programs;
  Gl_program compose{{shaders::whole_vert}, {shaders::compose_3_frag}};
  Gl_program under{{shaders::whole_vert}, {shaders::under_frag}};
  unsigned vertex_array = 0;
  unsigned query = 0;

  std::optional<Gl_deep_target> solid;
  std::array<std::optional<Gl_deep_target>, 2> peels;
  std::optional<Gl_deep_target> translucent;
  std::optional<Gl_deep_target> ids;

  std::map<const Primitive_set*, Gl_primitives_3> primitives;
  Color_map_textures color_maps;
  std::size_t other_bytes = 0;
  std::size_t draw_calls = 0;

  State() {
    glGenVertexArrays(1, &vertex_array);
    glGenQueries(1, &query);
  }
  ~State() {
    glDeleteVertexArrays(1, &vertex_array);
    glDeleteQueries(1, &query);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// What is the same for all layers of one picture.
  struct Picture {
    Projection_3 projection;
    Planes planes;
    int width = 0;  ///< of what is painted, in samples
    int height = 0;
    double ratio = 1;  ///< samples per logical pixel
    std::span<const Scene_layer> layers;
    std::span<const Scene_layer> overlay;
  };
  /// How the layers are painted this time.
  struct Pass {
    Gl_programs_3* programs = nullptr;
    bool has_nearer = false;
  };
  /// A layer on its way.
  struct Item {
    const Scene_layer* layer = nullptr;
    Gl_primitives_3* buffers = nullptr;
    Gl_look look;
    int number = 0;  ///< of the layer + 1
    double lift = 0;
  };

  Gl_primitives_3& primitives_of(const std::shared_ptr<const Primitive_set>& set);
  Gl_programs_3& programs_for(Gl_programs_3::Paint paint, const Planes& planes);
  void forget_expired();
  void begin();
  static void end();
  Picture picture_of(const Scene& scene, std::span<const Scene_layer> overlay, const View_3& view,
                     const Frame_3& frame);
  void draw_layers(const Picture& picture, const Pass& pass, Choice is_wanted);
  void draw_layer(const Picture& picture, const Pass& pass, const Item& item);
  void draw_pieces(const Picture& picture, const Pass& pass, const Item& item, Part_3 part);
  void draw_balls(const Picture& picture, const Pass& pass, const Item& item);
  void draw_caps(const Picture& picture, const Pass& pass, const Item& item);
  void set_surface(Gl_program& program, const Picture& picture, const Pass& pass, const Item& item,
                   const Planes& planes) const;
  void set_element(Gl_program& program, const Picture& picture, const Item& item);
  void draw_faces(const Picture& picture, const Pass& pass, const Item& item, const Planes& planes);
  void draw(unsigned mode, int vertices);
  bool peel(const Picture& picture, int most);
  void read_ids(const Picture& picture, Choice is_wanted, std::vector<std::uint32_t>& ids_there,
                std::vector<float>& depths);
};

Gl_primitives_3& Gl_renderer_3::State::primitives_of(const std::shared_ptr<const Primitive_set>& set) {
  const auto known = primitives.find(set.get());
  if (known != primitives.end()) {
    if (known->second.is_of(set)) return known->second;
    other_bytes += known->second.uploaded_bytes();
    primitives.erase(known);
  }
  return primitives.emplace(set.get(), Gl_primitives_3(set)).first->second;
}

Gl_programs_3& Gl_renderer_3::State::programs_for(Gl_programs_3::Paint paint, const Planes& planes) {
  const std::pair kind(paint, !planes.empty());
  const auto known = programs.find(kind);
  return known != programs.end() ? known->second
                                 : programs.emplace(kind, Gl_programs_3(kind.first, kind.second)).first->second;
}

void Gl_renderer_3::State::forget_expired() {
  std::erase_if(primitives, [&](const auto& entry) {
    if (!entry.second.is_expired()) return false;
    other_bytes += entry.second.uploaded_bytes();
    return true;
  });
}

void Gl_renderer_3::State::begin() {
  glBindVertexArray(vertex_array);
  glActiveTexture(GL_TEXTURE0);
  for (const unsigned feature : {GL_BLEND, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_CULL_FACE, GL_MULTISAMPLE})
    glDisable(feature);
  glEnable(GL_DEPTH_TEST);
  // Rays go far beyond the box of what is drawn.
  glEnable(GL_DEPTH_CLAMP);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilMask(~0U);
  glClearDepth(1);
  glClearStencil(0);
}

void Gl_renderer_3::State::end() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_DEPTH_CLAMP);
  glDisable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ZERO);
  glDepthFunc(GL_LESS);
  glEnable(GL_MULTISAMPLE);
  for (int unit = units_3::nearer_depth; unit >= 0; --unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindTexture(GL_TEXTURE_1D, 0);
    glBindTexture(GL_TEXTURE_BUFFER, 0);
  }
  glStencilFunc(GL_ALWAYS, 0, ~0U);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glBindVertexArray(0);
  glUseProgram(0);
}

Gl_renderer_3::State::Picture Gl_renderer_3::State::picture_of(const Scene& scene, std::span<const Scene_layer> overlay,
                                                               const View_3& view, const Frame_3& frame) {
  Box box;
  for (const std::span<const Scene_layer> layers : {std::span<const Scene_layer>(scene.layers), overlay})
    for (const Scene_layer& layer : layers)
      if (is_drawn(layer)) box.add(primitives_of(layer.primitives).box());
  const Tile tile = frame.whole_tile();
  Picture picture{Projection_3(view.camera, box, frame),
                  {},
                  tile.width * frame.samples,
                  tile.height * frame.samples,
                  frame.pixel_ratio * frame.samples,
                  scene.layers,
                  overlay};
  picture.planes = planes_of(view, picture.projection);
  return picture;
}

void Gl_renderer_3::State::draw(unsigned mode, int vertices) {
  glDrawArrays(mode, 0, vertices);
  ++draw_calls;
}

void Gl_renderer_3::State::set_surface(Gl_program& program, const Picture& picture, const Pass& pass, const Item& item,
                                       const Planes& planes) const {
  const Projection_3& projection = picture.projection;
  program.use();
  program.set_matrix("projection", projection.clip_matrix().data());
  program.set("perspective", projection.is_perspective());
  program.set("nearest", static_cast<float>(projection.near()));
  program.set("pixel_size", static_cast<float>(projection.pixel_size()));
  program.set("picture_size", std::array{static_cast<float>(picture.width), static_cast<float>(picture.height)});
  program.set("layer_lift", static_cast<float>(item.lift));
  program.set("number_of_layer", item.number);
  program.set("has_nearer", pass.has_nearer);
  const bool is_sliced = item.layer->style.sliced;
  program.set("plane_count", is_sliced ? static_cast<int>(planes.size()) : 0);
  constexpr std::array names{"planes[0]", "planes[1]"};
  for (std::size_t i = 0; i < planes.size(); ++i) program.set(names[i], planes[i]);
}

void Gl_renderer_3::State::set_element(Gl_program& program, const Picture& picture, const Item& item) {
  const Primitive_set& set = *item.layer->primitives;
  const Gl_look& look = item.look;
  set_look(program, *item.layer, look);
  program.set_matrix("to_eye", picture.projection.eye_matrix(item.buffers->origin()).data());
  const auto bind = [&](const char* flag, bool is_used, const std::string& name, int unit) {
    program.set(flag, is_used);
    if (is_used) item.buffers->number_table(set, name).bind(unit);
  };
  bind("has_numbers", look.rule != Color_rule::one_color, look.number, units_3::numbers);
  bind("has_threshold", !look.threshold.empty(), look.threshold, units_3::threshold_numbers);
  bind("has_cut", !look.cut.empty(), look.cut, units_3::cut_numbers);
}

void Gl_renderer_3::State::draw_pieces(const Picture& picture, const Pass& pass, const Item& item, Part_3 part) {
  const Primitive_set& set = *item.layer->primitives;
  const Style& style = item.layer->style;
  const Gl_table& pieces = item.buffers->pieces(set, part);
  if (pieces.count() == 0) return;
  const bool are_points = part == Part_3::points || part == Part_3::bounding_points;
  Gl_program& program = are_points ? pass.programs->points : pass.programs->segments;
  set_surface(program, picture, pass, item, picture.planes);
  set_element(program, picture, item);
  item.buffers->places(set).bind(units_3::places);
  pieces.bind(units_3::pieces);
  const bool are_on_faces = part == Part_3::face_edges && style.filled;
  program.set("shade", are_on_faces ? shade_of_edges : 1.0F);
  program.set("half_width", static_cast<float>(style.line_width * picture.ratio / 2) * (are_on_faces ? 0.6F : 1.0F));
  program.set("point_radius", static_cast<float>(style.point_size * picture.ratio / 2));
  constexpr int vertices_of_square = 6;
  draw(GL_TRIANGLES, vertices_of_square * pieces.count());
}

void Gl_renderer_3::State::draw_balls(const Picture& picture, const Pass& pass, const Item& item) {
  const Primitive_set& set = *item.layer->primitives;
  if (set.balls.empty()) return;
  Gl_program& program = pass.programs->balls;
  set_surface(program, picture, pass, item, picture.planes);
  set_element(program, picture, item);
  const Gl_table& balls = item.buffers->balls(set);
  balls.bind(units_3::places);
  program.set("depth_span", static_cast<float>(picture.projection.far() - picture.projection.near()));
  program.set("first_element", static_cast<int>(first_ball_3(set)));
  program.set("filled", item.layer->style.filled);
  program.set("line_width", static_cast<float>(item.layer->style.line_width * picture.ratio));
  constexpr int vertices_of_square = 6;
  draw(GL_TRIANGLES, vertices_of_square * balls.count());
}

void Gl_renderer_3::State::draw_faces(const Picture& picture, const Pass& pass, const Item& item,
                                      const Planes& planes) {
  const Primitive_set& set = *item.layer->primitives;
  const Gl_table& pieces = item.buffers->pieces(set, Part_3::faces);
  if (pieces.count() == 0) return;
  Gl_program& program = pass.programs->faces;
  const bool is_smooth = item.layer->style.smooth;
  set_surface(program, picture, pass, item, planes);
  set_element(program, picture, item);
  item.buffers->places(set).bind(units_3::places);
  pieces.bind(units_3::pieces);
  (is_smooth ? item.buffers->vertex_normals(set) : item.buffers->face_normals(set)).bind(units_3::normals);
  program.set("has_vertex_normals", is_smooth);
  draw(GL_TRIANGLES, 3 * pieces.count());
}

/// Where a cutting plane is inside the solid that faces bound. Along a line of sight every face that the plane leaves
/// is counted, those seen from behind up and those seen from the front down: what is not 0 was cut open.
void Gl_renderer_3::State::draw_caps(const Picture& picture, const Pass& pass, const Item& item) {
  const bool is_whole = item.look.cut.empty() && item.look.threshold_ranks == Gl_look{}.threshold_ranks;
  const Primitive_set& set = *item.layer->primitives;
  if (picture.planes.empty() || !item.layer->style.sliced || !is_whole || !item.buffers->is_closed(set)) return;
  const Box& box = item.buffers->box();
  const double reach = box.diagonal();
  const Point_3 center = picture.projection.to_eye(midpoint(box.lower, box.upper));
  for (const auto& plane : picture.planes) {
    glClear(GL_STENCIL_BUFFER_BIT);
    glEnable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glStencilFunc(GL_ALWAYS, 0, ~0U);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    draw_faces(picture, {pass.programs, false}, item, {plane});
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilFunc(GL_NOTEQUAL, 0, ~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);

    const Point_3 normal = normal_of(plane);
    const Point_3 middle = center - (dot(normal, center) + plane[3]) * normal;
    Point_3 side = cross(normal, std::abs(normal.x) < 0.7 ? Point_3{1, 0, 0} : Point_3{0, 1, 0});
    side = (reach / std::sqrt(dot(side, side))) * side;
    const Point_3 other = cross(normal, side);
    Gl_program& program = pass.programs->areas;
    set_surface(program, picture, pass, item, {});
    program.set("color", to_floats(item.layer->style.color, item.layer->style.opacity));
    program.set("area_normal", to_floats(normal));
    program.set("corners[0]", to_floats(middle - side - other));
    program.set("corners[1]", to_floats(middle + side - other));
    program.set("corners[2]", to_floats(middle - side + other));
    program.set("corners[3]", to_floats(middle + side + other));
    draw(GL_TRIANGLE_STRIP, 4);
    glDisable(GL_STENCIL_TEST);
  }
}

void Gl_renderer_3::State::draw_layer(const Picture& picture, const Pass& pass, const Item& item) {
  const Style& style = item.layer->style;
  const Primitive_set& set = *item.layer->primitives;
  draw_balls(picture, pass, item);
  const bool has_faces = !set.triangles.empty() || set.polygon_count() > 0;
  if (has_faces && style.filled) {
    draw_faces(picture, pass, item, picture.planes);
    draw_caps(picture, pass, item);
  }
  if (has_faces && (style.edges || !style.filled)) draw_pieces(picture, pass, item, Part_3::face_edges);
  if (!set.segments.empty() || !set.rays.empty()) draw_pieces(picture, pass, item, Part_3::segments);
  if (!set.points.empty()) draw_pieces(picture, pass, item, Part_3::points);
  if (!set.points.empty() && style.vertices) draw_pieces(picture, pass, item, Part_3::bounding_points);
}

void Gl_renderer_3::State::draw_layers(const Picture& picture, const Pass& pass, Choice is_wanted) {
  int number = 0;
  const auto draw_one = [&](const Scene_layer& layer, double lift) {
    ++number;
    if (!is_drawn(layer) || !is_wanted(layer)) return;
    Gl_primitives_3& buffers = primitives_of(layer.primitives);
    draw_layer(picture, pass, {&layer, &buffers, look_of(layer, buffers.numbers(), color_maps), number, lift});
  };
  double lift = 0;
  for (const Scene_layer& layer : picture.layers) draw_one(layer, lift += lift_per_layer);
  for (const Scene_layer& layer : picture.overlay) draw_one(layer, (lift += lift_per_layer) + lift_of_overlay);
}

/// Translucent things, from the nearest surface to farther ones: each pass paints what lies right behind the last.
/// Unlike sums with weights, that gives the exact colours of what overlaps, as pictures for papers need them; it costs
/// one pass for each surface behind another, and ends when there is no more. Returns whether there was anything.
bool Gl_renderer_3::State::peel(const Picture& picture, int most) {
  const auto is_wanted = [](const Scene_layer& layer) { return is_drawn(layer) && is_translucent(layer); };
  if (std::ranges::none_of(picture.layers, is_wanted) && std::ranges::none_of(picture.overlay, is_wanted)) return false;
  fit(translucent, picture.width, picture.height, Gl_deep_target::Format::fine_color);
  translucent->bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  for (int i = 0; i < most; ++i) {
    std::optional<Gl_deep_target>& here = peels[static_cast<std::size_t>(i % 2)];
    const std::optional<Gl_deep_target>& nearer = peels[static_cast<std::size_t>((i + 1) % 2)];
    fit(here, picture.width, picture.height, Gl_deep_target::Format::color);
    here->bind();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    bind_texture(units_3::solid_depth, solid->depth());
    bind_texture(units_3::nearer_depth, i > 0 ? nearer->depth() : 0);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
    draw_layers(picture, {&programs_for(Gl_programs_3::Paint::peeled_colors, picture.planes), i > 0}, is_translucent);
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    unsigned is_any = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &is_any);
    if (!is_any) break;
    translucent->bind();
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    under.use();
    under.set("layer", 0);
    bind_texture(0, here->texture());
    draw(GL_TRIANGLES, 3);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
  }
  return true;
}

Box drawn_box(const Scene& scene) {
  Box box;
  for (const Scene_layer& layer : scene.layers)
    if (is_drawn(layer)) box.add(layer.primitives->bounding_box());
  return box;
}

Gl_renderer_3::Gl_renderer_3() {
  if (epoxy_gl_version() < 33) {
    const int version = epoxy_gl_version();
    throw std::runtime_error("OpenGL is " + std::to_string(version / 10) + "." + std::to_string(version % 10) +
                             ", 3.3 is needed");
  }
  state_ = std::make_unique<State>();
  state_->programs_for(Gl_programs_3::Paint::colors, {});
}

Gl_renderer_3::~Gl_renderer_3() = default;

/// Layer + 1 and element of each pixel, or two zeros; and what the depth is there.
void Gl_renderer_3::State::read_ids(const Picture& picture, Choice is_wanted, std::vector<std::uint32_t>& ids_there,
                                    std::vector<float>& depths) {
  fit(ids, picture.width, picture.height, Gl_deep_target::Format::ids);
  ids->bind();
  constexpr std::array<unsigned, 4> nothing{};
  glClearBufferuiv(GL_COLOR, 0, nothing.data());
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  draw_layers(picture, {&programs_for(Gl_programs_3::Paint::ids, picture.planes), false}, is_wanted);
  const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  ids_there.resize(2 * pixels);
  depths.resize(pixels);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, picture.width, picture.height, GL_RG_INTEGER, GL_UNSIGNED_INT, ids_there.data());
  glReadPixels(0, 0, picture.width, picture.height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
}

void Gl_renderer_3::draw(const Scene& scene, std::span<const Scene_layer> overlay, const View_3& view,
                         const Frame_3& frame) {
  State& s = *state_;
  int shown = 0;
  std::array<int, 4> viewport{};
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &shown);
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  s.forget_expired();
  s.begin();
  const Frame_3 painted = coarse(frame);
  const State::Picture picture = s.picture_of(scene, overlay, view, painted);
  fit(s.solid, picture.width, picture.height, Gl_deep_target::Format::color);
  s.solid->bind();
  const float alpha = scene.transparent_background ? 0 : 1;
  const Color& ground = scene.background;
  glClearColor(alpha * ground.red / 255.0F, alpha * ground.green / 255.0F, alpha * ground.blue / 255.0F, alpha);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  s.draw_layers(picture, {&s.programs_for(Gl_programs_3::Paint::colors, picture.planes), false}, is_solid);
  const bool has_translucent = s.peel(picture, frame.most_translucent_layers);

  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(shown));
  const Tile tile = frame.whole_tile();
  glViewport(viewport[0], viewport[1], tile.width, tile.height);
  glDisable(GL_DEPTH_TEST);
  bind_texture(0, s.solid->texture());
  bind_texture(1, s.solid->depth());
  bind_texture(2, has_translucent ? s.translucent->texture() : 0);
  s.compose.use();
  s.compose.set("solid", 0);
  s.compose.set("solid_depth", 1);
  s.compose.set("translucent", 2);
  s.compose.set("has_translucent", has_translucent);
  s.compose.set("samples", frame.samples);
  s.compose.set("coarseness", painted.width == frame.width ? 1 : frame.coarseness);
  s.compose.set("corner", std::array{static_cast<float>(viewport[0]), static_cast<float>(viewport[1])});
  s.compose.set("outlines", static_cast<float>(frame.outlines));
  s.compose.set("perspective", picture.projection.is_perspective());
  s.compose.set("depths", std::array{static_cast<float>(picture.projection.near()),
                                     static_cast<float>(picture.projection.far())});
  s.draw(GL_TRIANGLES, 3);
  State::end();
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

Id_picture Gl_renderer_3::ids(const Scene& scene, const View_3& view, const Frame_3& frame) {
  State& s = *state_;
  int shown = 0;
  std::array<int, 4> viewport{};
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &shown);
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  s.forget_expired();
  s.begin();
  Frame_3 whole = frame;
  whole.samples = 1;
  whole.tile.reset();
  const State::Picture picture = s.picture_of(scene, {}, view, whole);
  std::vector<std::uint32_t> ids;
  std::vector<float> depths;
  s.read_ids(picture, is_meant, ids, depths);
  const auto is_one = [](const Scene_layer& layer) { return is_drawn(layer) && is_seen_through(layer); };
  if (std::ranges::any_of(picture.layers, is_one)) {
    std::vector<std::uint32_t> other_ids;
    std::vector<float> other_depths;
    s.read_ids(picture, is_seen_through, other_ids, other_depths);
    for (std::size_t pixel = 0; pixel < depths.size(); ++pixel) {
      if (ids[2 * pixel] != 0) continue;
      ids[2 * pixel] = other_ids[2 * pixel];
      ids[2 * pixel + 1] = other_ids[2 * pixel + 1];
      depths[pixel] = other_depths[pixel];
    }
  }
  State::end();
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(shown));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  return {whole, picture.projection, std::move(ids), std::move(depths)};
}

std::size_t Gl_renderer_3::uploaded_bytes() const {
  std::size_t sum = state_->other_bytes + state_->color_maps.uploaded_bytes();
  for (const auto& [set, buffers] : state_->primitives) sum += buffers.uploaded_bytes();
  return sum;
}

std::size_t Gl_renderer_3::draw_calls() const { return state_->draw_calls; }

int Gl_renderer_3::largest_side() const { return Gl_texture::largest_side(); }

std::string Gl_renderer_3::description() const {
  const int version = epoxy_gl_version();
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return "OpenGL " + std::to_string(version / 10) + "." + std::to_string(version % 10) + " (" +
         (renderer ? renderer : "unknown") + ")";
}

}  // namespace mesecina
