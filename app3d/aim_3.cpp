// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/aim_3.h"

#include <QPoint>
#include <algorithm>
#include <cmath>
#include <utility>

namespace mesecina {

namespace {

/// How near the cursor has to be, in logical pixels.
constexpr double grab_radius = 5;

bool same_scene(const Scene& first, const Scene& second) {
  return std::ranges::equal(first.layers, second.layers, [](const Scene_layer& a, const Scene_layer& b) {
    return a.id == b.id && a.primitives == b.primitives && a.cut == b.cut && a.style == b.style;
  });
}

/// What is shown of the scene, without the layers that one sees through.
Scene solid_part(const Scene& scene) {
  Scene solid;
  std::ranges::copy_if(scene.layers, std::back_inserter(solid.layers), [](const Scene_layer& layer) {
    const bool is_editable = layer.id == balls_layer || layer.id == points_layer;
    return layer.style.visible && (is_editable || layer.style.opacity >= 1);
  });
  return solid;
}

std::shared_ptr<const Primitive_set> without_elements(const std::shared_ptr<const Primitive_set>& set,
                                                      const std::vector<std::size_t>& elements) {
  if (!set || elements.empty()) return set;
  std::vector<bool> keep(set->element_count(), true);
  for (const std::size_t element : elements)
    if (element < keep.size()) keep[element] = false;
  return std::make_shared<const Primitive_set>(mesecina::select(*set, keep));
}

}  // namespace

Sight_3 Aim_3::sight() const { return {viewer_.view().camera, double(viewer_.width()), double(viewer_.height())}; }

QPoint Aim_3::device(const QPointF& pixel) const {
  const QPointF device = pixel * viewer_.devicePixelRatioF();
  return {static_cast<int>(std::floor(device.x())), static_cast<int>(std::floor(device.y()))};
}

const Id_picture& Aim_3::drawn(Picture& picture, Scene scene) {
  const View_3 view = viewer_.view();
  const int width = static_cast<int>(std::lround(viewer_.width() * viewer_.devicePixelRatioF()));
  if (picture.view != view || picture.ids.width() != width || !same_scene(picture.scene, scene))
    picture = {viewer_.ids_of(scene), std::move(scene), view};
  return picture.ids;
}

std::optional<Aim_3::Target> Aim_3::element_at(const QPointF& pixel) {
  const Id_picture& ids = drawn(elements_, solid_part(viewer_.scene()));
  const QPoint middle = device(pixel);
  const Reach_3 reach = editor_.reach();
  const Inputs& inputs = editor_.document().inputs();
  const auto target_of = [&](const Id_picture::Hit& hit) -> std::optional<Target> {
    const std::string& layer = elements_.scene.layers[hit.layer].id;
    if (!hit.element) return std::nullopt;
    Target target{{}, hit.place};
    if (layer == balls_layer && reach.balls) target.element.balls = {*hit.element};
    if (layer == points_layer && reach.points) target.element.points = {*hit.element};
    target.element = restricted(target.element, inputs);
    return target.element.is_empty() ? std::nullopt : std::optional(target);
  };
  std::optional<Target> found;
  double best = grab_radius * viewer_.devicePixelRatioF();
  const int reach_of_hand = static_cast<int>(best);
  for (int y = -reach_of_hand; y <= reach_of_hand; ++y) {
    for (int x = -reach_of_hand; x <= reach_of_hand; ++x) {
      const double away = std::hypot(x, y);
      if (away > best || (found && away >= best)) continue;
      const auto hit = ids.find(middle.x() + x, middle.y() + y);
      auto target = hit ? target_of(*hit) : std::nullopt;
      if (!target) continue;
      best = away;
      found = std::move(target);
    }
  }
  return found;
}

Point_3 Aim_3::place_at(const QPointF& pixel) {
  if (const auto hit = viewer_.pick(pixel, 0)) return hit->place;
  const View_3 view = viewer_.view();
  const Point_2 here{pixel.x(), pixel.y()};
  const Sight_3 seen = sight();
  if (view.cutting_plane) {
    if (const auto place = seen.on_plane(here, view.cutting_plane->point, view.cutting_plane->normal)) return *place;
  }
  return seen.across(here, view.camera.target);
}

void Aim_3::begin_move() {
  surface_scene_ = {};
  for (const Scene_layer& layer : viewer_.scene().layers) {
    if (!layer.style.visible) continue;
    Scene_layer rest = layer;
    if (layer.id == balls_layer) {
      rest.primitives = without_elements(layer.primitives, editor_.selection().balls);
    } else if (layer.id == points_layer) {
      rest.primitives = without_elements(layer.primitives, editor_.selection().points);
    } else if (layer.id != mesh_layer) {
      continue;
    }
    surface_scene_.layers.push_back(std::move(rest));
  }
}

std::optional<Point_3> Aim_3::surface_at(const QPointF& pixel) {
  const QPoint at = device(pixel);
  const auto hit = drawn(surfaces_, surface_scene_).find(at.x(), at.y());
  return hit ? std::optional(hit->place) : std::nullopt;
}

Selection_3 Aim_3::inside(const QRectF& rectangle) const {
  const Sight_3 seen = sight();
  const Scene& scene = viewer_.scene();
  const std::optional<Cutting_plane_3> plane = viewer_.view().cutting_plane;
  const auto plane_of = [&](std::string_view layer) {
    const auto found = std::ranges::find(scene.layers, layer, &Scene_layer::id);
    return found != scene.layers.end() && found->style.sliced ? plane : std::nullopt;
  };
  const auto is_inside = [&](const std::optional<Cutting_plane_3>& cut, const Point_3& place) {
    const auto pixel = seen.pixel(place);
    return pixel && rectangle.contains(pixel->x, pixel->y) && is_left(cut, place);
  };
  Selection_3 found;
  const Inputs& inputs = editor_.document().inputs();
  const Reach_3 reach = editor_.reach();
  if (const auto points = inputs.get(cloud_input); points && reach.points) {
    const auto cut = plane_of(points_layer);
    for (std::size_t i = 0; i < points->size(); ++i)
      if (is_inside(cut, (*points)[i])) found.points.push_back(i);
  }
  if (const auto balls = inputs.get(balls_input); balls && reach.balls) {
    const auto cut = plane_of(balls_layer);
    for (std::size_t i = 0; i < balls->size(); ++i)
      if (is_inside(cut, (*balls)[i].center)) found.balls.push_back(i);
  }
  return found;
}

}  // namespace mesecina
