// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/registry.h"
#include "layers/canvas_2.h"
#include "shell/computation.h"

namespace mesecina {

/// What is known of the element under the mouse.
struct Hovered_2 {
  std::string layer;
  std::string label;
  std::size_t element = 0;
  std::shared_ptr<const Primitive_set> source;     ///< the picture of the layer in which it was found
  std::shared_ptr<const Primitive_set> highlight;  ///< the element alone
  std::shared_ptr<const Primitive_set> dual;       ///< null until known, or when there is none
  std::vector<Fact> facts;
};

/// Finds out what the mouse rests on. All searching happens on another thread, so that moving the mouse over large
/// scenes costs nothing.
class Hover_2 : public QObject {
  Q_OBJECT
 public:
  Hover_2(Computation& computation, Canvas_2& canvas, QObject* parent = nullptr);
  ~Hover_2() override;

  /// Asks soon what is at this pixel.
  void look_at(const QPointF& pixel);
  void forget();
  /// Drops what was found when its layer has changed since.
  void check();
  const std::optional<Hovered_2>& hovered() const { return hovered_; }
  /// "name: text" lines; empty when nothing is hovered.
  QString facts_text() const;
  /// The same with numbers of at most six digits, for reading.
  QString short_facts_text() const;

 Q_SIGNALS:
  void changed();

 private:
  struct Question {
    Scene scene;
    View_2 view;
    QSize size;
    Point_2 pixel;
    std::uint64_t number = 0;
  };
  void ask();
  void serve(const std::stop_token& stop);
  void take(std::optional<Hovered_2> found, std::uint64_t number);

  Computation& computation_;
  Canvas_2& canvas_;
  QTimer timer_;
  QPointF pixel_;
  std::uint64_t number_ = 0;
  std::optional<Hovered_2> hovered_;

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Question> question_;
  std::jthread thread_;
};

}  // namespace mesecina
