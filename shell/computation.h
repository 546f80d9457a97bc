// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/worker.h"
#include "layers/layer_panel.h"
#include "shell/document.h"
#include "shell/picture_cache.h"

namespace mesecina {

/// Keeps the pictures of a document's visible layers up to date, on a thread of its own. The last good picture of a
/// layer stays until there is a new one. Pictures of the places of an evolution track are kept, so that going to one
/// that was seen before needs no computation.
class Computation : public QObject {
  Q_OBJECT
 public:
  Computation(std::shared_ptr<const Registry> registry, Document& document, QObject* parent = nullptr);
  /// Cancels and returns within about 100 ms.
  ~Computation() override;

  /// Every layer of the document with the newest picture there is of it, under the cuts of the present settings.
  /// Colours that would not be seen on the background are replaced (see visible_on).
  Scene scene(Color background) const;
  /// Null when it was never computed or there is nothing.
  std::shared_ptr<const Primitive_set> primitives(const std::string& layer) const;
  Layer_status status(const std::string& layer) const;
  bool is_busy() const { return is_busy_; }
  /// Requests sent so far, for tests.
  std::uint64_t requests() const { return last_ticket_; }

  /// Of the pictures that are kept.
  std::size_t kept_bytes() const { return cache_.bytes(); }
  std::size_t kept_bytes_budget() const { return cache_.budget(); }
  void set_kept_bytes_budget(std::size_t bytes);

  /// What an element of a layer is; not answered when the layer is not up to date, or changes before the answer.
  void describe(const std::string& layer, std::size_t element, std::function<void(Element_description)> answer);

 public Q_SLOTS:
  /// Stops; layers that are not ready stay as they were, marked stale.
  void cancel();

 Q_SIGNALS:
  void scene_changed();
  /// Status or picture of the layer.
  void layer_changed(const QString& layer);
  /// Also said at every new request while others are under way.
  void busy_changed(bool is_busy);
  /// Something was computed for the present data, and all that was asked for is there.
  void reported(const mesecina::Worker::Report& report);
  /// The pictures are all of one state of the document, though newer ones may be under way.
  void request_completed();
  /// fraction in [0,1] of the stage.
  void progressed(const QString& stage, double fraction);
  void kept_bytes_changed();

 private:
  struct Layer {
    Layer_picture picture;
    std::uint64_t generation = 0;  ///< of the data that it shows; 0: never computed
    bool is_computing = false;
  };

  /// What was shown at a time.
  struct Data {
    Inputs inputs;
    Settings settings;  ///< only those that structures may read
  };

  void react(const Document_change& change);
  Data present_data() const;
  void keep(const std::string& layer);
  void show_kept_pictures();
  std::vector<std::string> visible_layers() const;
  QString stage_text(const std::string& stage) const;
  void request_visible();
  void send(std::vector<std::string> layers);
  void take(const Worker::Layer_result& result);
  void finish(std::uint64_t ticket);
  void set_busy(bool is_busy);
  void touch(const std::string& layer);
  void flush();

  std::shared_ptr<const Registry> registry_;
  Document& document_;
  Data data_;  ///< of the present generation
  Picture_cache cache_;
  std::map<std::string, Layer> layers_;
  std::uint64_t generation_ = 1;  ///< of inputs and those settings that structures may read
  std::uint64_t last_ticket_ = 0;
  std::map<std::uint64_t, std::uint64_t> generations_;  ///< of the tickets that may still answer
  std::vector<std::string> requested_;                  ///< layers of the last request
  bool is_busy_ = false;
  bool is_worker_behind_ = false;  ///< it has other inputs or settings than the document
  std::set<std::string> touched_;
  QTimer flush_timer_;
  std::unique_ptr<Worker> worker_;
};

}  // namespace mesecina
