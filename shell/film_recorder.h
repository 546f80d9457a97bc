// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "core/formats/film.h"
#include "core/formats/format.h"
#include "shell/background_jobs.h"

namespace mesecina {

/// Makes one film at a time of the frames it is given, in their order, on a thread of its own.
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
  /// Given, but neither painted nor encoded yet. They cost next to nothing.
  int waiting() const { return frames_ - encoded_; }

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
  void run(std::function<std::function<void()>(Session&)> work);
  void end();

  std::shared_ptr<const Formats> formats_;
  std::shared_ptr<Session> session_;
  Film_request request_;
  int frames_ = 0;
  int encoded_ = 0;
  bool is_finishing_ = false;
  Background_jobs jobs_;
};

}  // namespace mesecina
