// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/hover_3.h"

#include <chrono>
#include <utility>

#include "shell/element_facts.h"

namespace mesecina {

namespace {

constexpr std::chrono::milliseconds interval(25);
constexpr double tolerance = 4;

Scene_layer outlined(const char* id, std::shared_ptr<const Primitive_set> primitives, Color color) {
  Style style;
  style.visible = true;
  style.color = color;
  style.vertices = true;
  style.sliced = false;
  constexpr double wide = 3;
  constexpr double large = 10;
  style.line_width = wide;
  style.point_size = large;
  return {id, {}, std::move(primitives), {}, style};
}

}  // namespace

Hover_3::Hover_3(Computation& computation, Viewer_3& viewer, QObject* parent)
    : QObject(parent), computation_(computation), viewer_(viewer) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Hover_3::ask);
}

void Hover_3::look_at(const QPointF& pixel) {
  pixel_ = pixel;
  if (!timer_.isActive()) timer_.start(interval);
}

void Hover_3::forget() {
  timer_.stop();
  if (!std::exchange(hovered_, std::nullopt)) return;
  Q_EMIT changed();
}

void Hover_3::check() {
  if (hovered_ && computation_.primitives(hovered_->layer) != hovered_->source) forget();
}

void Hover_3::ask() {
  const auto hit = viewer_.pick(pixel_, tolerance);
  if (!hit || !hit->element) {
    forget();
    return;
  }
  const Scene_layer& layer = viewer_.scene().layers[hit->layer];
  const std::size_t element = *hit->element;
  if (hovered_ && hovered_->source == layer.primitives && hovered_->element == element) {
    hovered_->place = hit->place;
    Q_EMIT changed();
    return;
  }
  std::vector<bool> keep(layer.primitives->element_count(), false);
  keep[element] = true;
  auto highlight = std::make_shared<Primitive_set>(select(*layer.primitives, keep));
  hovered_ = Hovered_3{layer.id,         layer.label,          element, hit->place,
                       layer.primitives, std::move(highlight), nullptr, own_facts(*layer.primitives, element)};
  Q_EMIT changed();
  computation_.describe(layer.id, element, [this, source = layer.primitives, element](Element_description known) {
    if (!hovered_ || hovered_->source != source || hovered_->element != element) return;
    add_facts(hovered_->facts, std::move(known.facts));
    if (!known.dual.is_empty()) hovered_->dual = std::make_shared<const Primitive_set>(std::move(known.dual));
    Q_EMIT changed();
  });
}

QString Hover_3::text() const { return hovered_ ? facts_text(hovered_->label, hovered_->facts) : QString(); }

std::vector<Scene_layer> Hover_3::overlay() const {
  std::vector<Scene_layer> layers;
  if (!hovered_) return layers;
  constexpr Color element_color{235, 120, 10};
  constexpr Color dual_color{20, 120, 235};
  if (hovered_->dual) layers.push_back(outlined("dual-of-hovered", hovered_->dual, dual_color));
  Scene_layer element = outlined("hovered", hovered_->highlight, element_color);
  // What is seen of it; the outline of a ball among others is mostly hidden.
  element.style.filled = true;
  layers.push_back(std::move(element));
  return layers;
}

}  // namespace mesecina
