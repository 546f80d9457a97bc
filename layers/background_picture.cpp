// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/background_picture.h"

#include <QPainter>
#include <utility>

#include "layers/painter_canvas.h"

namespace mesecina {

QImage painted_picture(const Picture_order& order, const std::stop_token& stop) {
  QImage picture((order.size * order.pixel_ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(order.pixel_ratio);
  QPainter painter(&picture);
  Scene part = order.scene;
  part.transparent_background = false;
  part.layers.clear();
  paint_scene(painter, part, order.view, order.size.width(), order.size.height());
  part.transparent_background = true;
  for (const Scene_layer& layer : order.scene.layers) {
    if (stop.stop_requested()) return {};
    part.layers.assign(1, layer);
    paint_scene(painter, part, order.view, order.size.width(), order.size.height());
  }
  return picture;
}

Background_picture::Background_picture(QObject& receiver, std::function<void(const QImage&, const Picture_order&)> done)
    : receiver_(receiver), done_(std::move(done)), thread_([this](const std::stop_token& stop) { serve(stop); }) {}

Background_picture::~Background_picture() = default;

void Background_picture::paint(Picture_order order) {
  {
    const std::scoped_lock lock(mutex_);
    waiting_ = std::move(order);
  }
  wake_.notify_one();
}

void Background_picture::serve(const std::stop_token& stop) {
  while (true) {
    Picture_order order;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
      order = *std::exchange(waiting_, std::nullopt);
    }
    QImage picture = painted_picture(order, stop);
    if (picture.isNull()) return;
    QMetaObject::invokeMethod(
        &receiver_, [this, picture = std::move(picture), order = std::move(order)] { done_(picture, order); },
        Qt::QueuedConnection);
  }
}

}  // namespace mesecina
