// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_primitives_2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mesecina {

namespace {

constexpr double largest_whole_reach = 131072;  // pixels; 2^17, of which a float still tells 1/128
/// Pixels, of the area that arcs bound: of a larger one most arcs are far from the view, and need many corners.
constexpr double largest_whole_arc_size = 32768;
constexpr double window_screens = 8;
constexpr double window_zoom_in = 8;
constexpr double window_zoom_out = 2;

/// Image data premultiplied by alpha, and averaged over squares of pixels until no side exceeds `largest`.
std::vector<std::uint8_t> premultiplied(const Image& image, int largest, int& width, int& height) {
  const int step = std::max(1, (std::max(image.width, image.height) + largest - 1) / largest);
  width = (image.width + step - 1) / step;
  height = (image.height + step - 1) / step;
  std::vector<std::uint8_t> result;
  result.reserve(static_cast<std::size_t>(width) * height * 4);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::array<std::size_t, 4> sum{};
      std::size_t count = 0;
      for (int v = y * step; v < std::min((y + 1) * step, image.height); ++v) {
        for (int u = x * step; u < std::min((x + 1) * step, image.width); ++u) {
          const std::uint8_t* p = image.rgba.data() + 4 * (static_cast<std::size_t>(v) * image.width + u);
          for (int i = 0; i < 3; ++i) sum[i] += static_cast<std::size_t>(p[i]) * p[3];
          sum[3] += 255 * static_cast<std::size_t>(p[3]);
          ++count;
        }
      }
      for (std::size_t s : sum) result.push_back(static_cast<std::uint8_t>((s + 127 * count) / (255 * count)));
    }
  }
  return result;
}

double median_radius(const std::vector<float>& circles, int floats) {
  std::vector<float> radii;
  for (std::size_t i = 2; i < circles.size(); i += static_cast<std::size_t>(floats)) radii.push_back(circles[i]);
  if (radii.empty()) return 0;
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::ranges::nth_element(radii, middle);
  return *middle;
}

bool is_convex(const Primitive_set& set, std::size_t polygon) {
  const auto ring = set.polygon(polygon);
  const std::size_t n = ring.size();
  int turn = 0;
  int sign_changes = 0;  // of the direction in x; more than two: it winds around more than once
  double last_dx = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point_3& p = set.vertices[ring[i]];
    const Point_3& q = set.vertices[ring[(i + 1) % n]];
    const Point_3& r = set.vertices[ring[(i + 2) % n]];
    const double cross = (q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x);
    const int side = cross > 0 ? 1 : cross < 0 ? -1 : 0;
    if (side != 0 && turn != 0 && side != turn) return false;
    if (side != 0) turn = side;
    const double dx = q.x - p.x;
    if (dx * last_dx < 0) ++sign_changes;
    if (dx != 0) last_dx = dx;
  }
  return sign_changes <= 2;
}

/// `view_reach` is half the diagonal of the picture in units of the plane.
bool fits(const Window_2& window, const Point_2& center, double scale, double view_reach) {
  return scale <= window.largest_scale && scale >= window.largest_scale / (window_zoom_in * window_zoom_out) &&
         std::abs(center.x - window.center.x) + view_reach <= window.half_side &&
         std::abs(center.y - window.center.y) + view_reach <= window.half_side;
}

Window_2 window_around(const Point_2& center, double scale, double view_reach) {
  return {center, window_screens * view_reach, window_zoom_in * scale};
}

}  // namespace

Gl_primitives::Gl_primitives(const std::shared_ptr<const Primitive_set>& set) : set_(set) {
  const Box box = set->bounding_box();
  const Point_2 middle{(box.lower.x + box.upper.x) / 2, (box.lower.y + box.upper.y) / 2};
  if (std::isfinite(middle.x) && std::isfinite(middle.y)) origin_ = middle;
}

void Gl_primitives::upload(Gl_batch& batch) {
  batch.geometry = Gl_buffer(batch.instances.data);
  uploaded_bytes_ += batch.instances.data.size() * sizeof(float);
  batch.instances.data = {};
}

Gl_primitives::Batches Gl_primitives::batches(const Primitive_set& set, Part part, const Point_2& center, double scale,
                                              double half_diagonal) {
  if (!has_part(set, part)) return {};
  const auto [entry, is_new] = parts_.try_emplace(part);
  Part_buffers& buffers = entry->second;
  const bool are_circles = part == Part::arcs || part == Part::balls;
  const int floats = floats_per_instance(part);
  if (is_new) buffers.reach = farthest_reach(set, part, origin_);
  if (buffers.reach * scale <= largest_whole_reach) {
    if (!buffers.whole) {
      buffers.whole.emplace();
      buffers.whole->instances = whole_part(set, part, origin_);
      if (are_circles) buffers.whole->typical_radius = median_radius(buffers.whole->instances.data, floats);
      upload(*buffers.whole);
    }
    return {&*buffers.whole, nullptr, true};
  }
  const double view_reach = half_diagonal / scale;
  if (!buffers.window || !fits(*buffers.window, center, scale, view_reach)) {
    buffers.window = window_around(center, scale, view_reach);
    Cut_out cut_out = cut_out_part(set, part, *buffers.window);
    buffers.near = {};
    buffers.far = {};
    buffers.near.instances = std::move(cut_out.near);
    buffers.far.instances = std::move(cut_out.far);
    if (are_circles) buffers.near.typical_radius = median_radius(buffers.near.instances.data, floats);
    upload(buffers.near);
    upload(buffers.far);
  }
  return {&buffers.near, buffers.far.count() > 0 ? &buffers.far : nullptr, false};
}

void Gl_primitives::upload(const Arc_fill& fill) {
  arc_fill_->fill = {fill.origin, Gl_buffer(fill.triangles), fill.triangles.size() / 6, Gl_buffer(fill.segments),
                     fill.runs};
  uploaded_bytes_ += (fill.triangles.size() + fill.segments.size()) * sizeof(float);
}

const Gl_arc_fill& Gl_primitives::arc_fill(const Scene_layer& layer, const Point_2& center, double scale,
                                           double half_diagonal) {
  const Primitive_set& set = *layer.primitives;
  std::vector<bool> drawn = drawn_elements(layer);
  const bool is_new = !arc_fill_ || arc_fill_->drawn != drawn;
  if (!arc_fill_) {
    Box box;
    for (const Arc& arc : set.arcs) box.add(bounding_box(set, arc));
    arc_fill_.emplace();
    arc_fill_->reach = farthest_reach(set, Part::arcs, origin_);
    arc_fill_->size = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
  }
  Arc_fill_buffers& buffers = *arc_fill_;
  if (is_new) buffers.drawn = std::move(drawn);
  if (buffers.reach * scale <= largest_whole_reach && buffers.size * scale <= largest_whole_arc_size) {
    if (is_new || buffers.window) upload(whole_arc_fill(set, buffers.drawn, origin_));
    buffers.window.reset();
    return buffers.fill;
  }
  const double view_reach = half_diagonal / scale;
  if (is_new || !buffers.window || !fits(*buffers.window, center, scale, view_reach)) {
    buffers.window = window_around(center, scale, view_reach);
    upload(cut_out_arc_fill(set, buffers.drawn, *buffers.window));
  }
  return buffers.fill;
}

unsigned Gl_primitives::number_buffer(const Primitive_set& set, Gl_batch& batch, const std::string& name) {
  const auto known = batch.numbers.find(name);
  if (known != batch.numbers.end()) return known->second.id();
  std::vector<float> data;
  data.reserve(2 * batch.instances.elements.size());
  const Element_numbers* own = name.empty() ? nullptr : numbers_.find(set, name);
  for (std::uint32_t element : batch.instances.elements) {
    if (own) {
      data.push_back(own->pairs()[2 * element]);
      data.push_back(own->pairs()[2 * element + 1]);
    } else {
      data.push_back(packed_color(element));
      data.push_back(0);
    }
  }
  uploaded_bytes_ += data.size() * sizeof(float);
  return batch.numbers.emplace(name, Gl_buffer(data)).first->second.id();
}

const std::vector<Polygon_run>& Gl_primitives::runs(const Scene_layer& layer, Gl_batch& batch) {
  if (batch.layer_of_runs && has_same_colors(*batch.layer_of_runs, layer)) return batch.runs;
  const Primitive_set& set = *layer.primitives;
  const auto& elements = batch.instances.elements;
  const std::size_t first_polygon =
      set.points.size() + set.segments.size() + set.rays.size() + set.arcs.size() + set.triangles.size();
  const Layer_colors colors(layer);
  const std::vector<bool> drawn = drawn_elements(layer);
  batch.runs.clear();
  for (std::size_t i = 0; i < elements.size();) {
    Polygon_run run{i, 0, true};
    std::optional<Color> color;
    std::optional<std::uint32_t> only;
    for (; i < elements.size(); ++i) {
      const std::uint32_t element = elements[i];
      if (element == only || (!drawn.empty() && !drawn[element])) continue;
      if (color && colors(element) != *color) break;
      run.is_plain = !only && is_convex(set, element - first_polygon);
      only = element;
      if (!color) color = colors(element);
    }
    run.count = i - run.first;
    if (run.is_plain && !batch.runs.empty() && batch.runs.back().is_plain)
      batch.runs.back().count += run.count;
    else
      batch.runs.push_back(run);
  }
  batch.layer_of_runs = layer;
  batch.layer_of_runs->primitives.reset();
  return batch.runs;
}

unsigned Gl_primitives::image(const Primitive_set& set) {
  if (!set.image || set.image->width <= 0 || set.image->height <= 0) return 0;
  if (!image_) {
    int width = 0;
    int height = 0;
    const auto data = premultiplied(*set.image, Gl_texture::largest_side(), width, height);
    image_ = Gl_texture::picture(width, height, data);
    uploaded_bytes_ += data.size();
  }
  return image_->id();
}

}  // namespace mesecina
