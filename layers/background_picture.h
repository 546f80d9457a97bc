// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QSizeF>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "core/style.h"

namespace mesecina {

/// What a picture is to show, and in which size.
struct Picture_order {
  Scene scene;
  View_2 view;
  QSizeF size;                 ///< in logical pixels
  double pixel_ratio = 1;      ///< pixels of the picture per logical one
  std::uint64_t revision = 0;  ///< of the scene, for who ordered it
};

/// The scene of an order on its background, by QPainter. Empty when told to stop, which is looked for between layers.
QImage painted_picture(const Picture_order& order, const std::stop_token& stop = {});

/// Paints scenes on a thread of its own, one at a time, so that a window need not wait for large ones.
class Background_picture {
 public:
  /// `done` is called by the event loop of the receiver's thread, as long as there is the receiver.
  Background_picture(QObject& receiver, std::function<void(const QImage&, const Picture_order&)> done);
  /// Waits until the layer at hand is painted.
  ~Background_picture();

  /// Takes the place of an order that has not begun.
  void paint(Picture_order order);

 private:
  void serve(const std::stop_token& stop);

  QObject& receiver_;
  std::function<void(const QImage&, const Picture_order&)> done_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Picture_order> waiting_;
  std::jthread thread_;
};

}  // namespace mesecina
