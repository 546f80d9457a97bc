// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <memory>
#include <set>
#include <vector>

#include "core/film_ranges.h"
#include "core/formats/film.h"
#include "core/formats/format.h"
#include "shell/background_jobs.h"

namespace mesecina {

/// Makes one film at a time of the frames it is given, in their order, on a thread of its own.
///
/// A colour means the same throughout a film. So frames with a layer whose colour map has no range of its own are held
/// back until all are there, and get the range of all frames together. Where pictures that are held would take more
/// than the budget, they get the range so far, and frames that follow that of all before them.
class Film_recorder : public QObject {
  Q_OBJECT
 public:
  explicit Film_recorder(std::shared_ptr<const Formats> formats, QObject* parent = nullptr);
  /// Cancels.
  ~Film_recorder() override;

  /// Nothing happens while there is one already.
  void start(const Film_request& request);
  /// From start() until the file is there, or is not made after all.
  bool is_active() const { return session_ != nullptr; }
  /// No more frames are taken: the rest is encoded.
  bool is_finishing() const { return is_finishing_; }
  const Film_request& request() const { return request_; }
  /// Given so far.
  int frames() const { return frames_; }
  /// Given, but neither painted nor encoded yet.
  int waiting() const { return frames_ - encoded_; }
  /// Of them, those not held back: they are being painted and encoded, one after the other.
  int queued() const { return waiting() - static_cast<int>(held_.size()); }
  /// Bytes of pictures, counted once each however many frames show them.
  void set_held_bytes_budget(std::size_t bytes) { held_bytes_budget_ = bytes; }

  void add(Film_frame frame);
  /// After the frames that wait. A film without frames is cancelled.
  void finish();
  /// Of the film nothing stays.
  void cancel();

 Q_SIGNALS:
  /// Numbers and states.
  void changed();
  /// `note`: empty, or that there are numbered pictures in place of a film, and how it is made of them.
  void finished(const QString& file, const QString& note);
  void failed(const QString& reason);

 private:
  struct Session;
  void hold(Film_frame frame);
  void release();
  void hand_over(Film_frame frame);
  void run(std::function<std::function<void()>(Session&)> work);
  void end();

  std::shared_ptr<const Formats> formats_;
  std::shared_ptr<Session> session_;
  Film_request request_;
  int frames_ = 0;
  int encoded_ = 0;
  bool is_finishing_ = false;
  Film_ranges ranges_;
  std::vector<Film_frame> held_;
  std::set<const Primitive_set*> held_pictures_;
  std::size_t held_bytes_ = 0;
  std::size_t held_bytes_budget_ = std::size_t{512} << 20;
  bool is_over_budget_ = false;
  Background_jobs jobs_;
};

}  // namespace mesecina
