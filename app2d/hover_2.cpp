// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/hover_2.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "layers/picker_2.h"
#include "shell/element_facts.h"

namespace mesecina {

namespace {

constexpr std::chrono::milliseconds interval(25);
constexpr double tolerance = 6;

std::optional<Hovered_2> find(Picker_2& picker, const Scene& scene, const View_2& view, const QSize& size,
                              const Point_2& pixel) {
  const auto hit = picker.pick(scene, view, size.width(), size.height(), pixel, tolerance);
  if (!hit) return std::nullopt;
  const Scene_layer& layer = scene.layers[hit->layer];
  std::vector<bool> keep(layer.primitives->element_count(), false);
  keep[hit->element] = true;
  auto highlight = std::make_shared<Primitive_set>(select(*layer.primitives, keep));
  highlight->image.reset();
  return Hovered_2{layer.id,
                   layer.label,
                   hit->element,
                   layer.primitives,
                   std::move(highlight),
                   nullptr,
                   own_facts(*layer.primitives, hit->element)};
}

}  // namespace

Hover_2::Hover_2(Computation& computation, Canvas_2& canvas, QObject* parent)
    : QObject(parent),
      computation_(computation),
      canvas_(canvas),
      thread_([this](const std::stop_token& stop) { serve(stop); }) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Hover_2::ask);
}

Hover_2::~Hover_2() {
  thread_.request_stop();
  thread_.join();
}

void Hover_2::look_at(const QPointF& pixel) {
  pixel_ = pixel;
  if (!timer_.isActive()) timer_.start(interval);
}

void Hover_2::forget() {
  timer_.stop();
  ++number_;
  if (!hovered_) return;
  hovered_.reset();
  Q_EMIT changed();
}

void Hover_2::check() {
  if (hovered_ && computation_.primitives(hovered_->layer) != hovered_->source) forget();
}

void Hover_2::ask() {
  ++number_;
  {
    const std::lock_guard lock(mutex_);
    question_ = Question{canvas_.scene(), canvas_.view(), canvas_.size(), {pixel_.x(), pixel_.y()}, number_};
  }
  wake_.notify_all();
}

void Hover_2::serve(const std::stop_token& stop) {
  Picker_2 picker;
  while (true) {
    std::optional<Question> question;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return question_.has_value(); }) || stop.stop_requested()) return;
      question = std::exchange(question_, std::nullopt);
    }
    auto found = find(picker, question->scene, question->view, question->size, question->pixel);
    QMetaObject::invokeMethod(
        this, [this, found = std::move(found), number = question->number]() mutable { take(std::move(found), number); },
        Qt::QueuedConnection);
  }
}

void Hover_2::take(std::optional<Hovered_2> found, std::uint64_t number) {
  if (number != number_) return;
  if (found && computation_.primitives(found->layer) != found->source) found.reset();
  if (!found && !hovered_) return;
  if (found && hovered_ && found->source == hovered_->source && found->element == hovered_->element) return;
  hovered_ = std::move(found);
  Q_EMIT changed();
  if (!hovered_) return;
  computation_.describe(hovered_->layer, hovered_->element,
                        [this, source = hovered_->source, element = hovered_->element](Element_description known) {
                          if (!hovered_ || hovered_->source != source || hovered_->element != element) return;
                          add_facts(hovered_->facts, std::move(known.facts));
                          if (!known.dual.is_empty())
                            hovered_->dual = std::make_shared<const Primitive_set>(std::move(known.dual));
                          Q_EMIT changed();
                        });
}

QString Hover_2::facts_text() const {
  return hovered_ ? mesecina::facts_text(hovered_->label, hovered_->facts) : QString();
}

QString Hover_2::short_facts_text() const { return with_short_numbers(facts_text()); }

}  // namespace mesecina
