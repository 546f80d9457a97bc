// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/film_recorder.h"

#include <stop_token>
#include <utility>

#include "core/outcome.h"
#include "shell/picture_cache.h"

namespace mesecina {

/// Of one film; but for `stop`, only the other thread touches it.
struct Film_recorder::Session {
  std::stop_source stop;
  std::unique_ptr<Film> film;
};

Film_recorder::Film_recorder(std::shared_ptr<const Formats> formats, QObject* parent)
    : QObject(parent), formats_(std::move(formats)) {}

Film_recorder::~Film_recorder() {
  if (session_) session_->stop.request_stop();
}

/// On the other thread. What goes wrong there ends the film.
void Film_recorder::run(std::function<std::function<void()>(Session&)> work) {
  jobs_.run(tr("Recording"), [this, session = session_, work = std::move(work)]() -> std::function<void()> {
    std::string reason;
    try {
      return work(*session);
    } catch (const Cancelled&) {
      session->film.reset();
      return [] {};
    } catch (const std::bad_alloc&) {
      reason = "no memory for the film";
    } catch (const std::exception& error) {
      reason = error.what();
    }
    session->film.reset();
    session->stop.request_stop();
    return [this, session, reason = QString::fromStdString(reason)] {
      if (session != session_) return;
      end();
      Q_EMIT failed(reason);
    };
  });
}

void Film_recorder::start(const Film_request& request) {
  if (session_) return;
  session_ = std::make_shared<Session>();
  request_ = request;
  run([formats = formats_, request](Session& session) -> std::function<void()> {
    if (!formats->make_film) throw File_error(request.file, 0, "this program makes no films");
    session.film = formats->make_film(request);
    return [] {};
  });
  Q_EMIT changed();
}

void Film_recorder::add(Film_frame frame) {
  if (!session_ || is_finishing_) return;
  ++frames_;
  ranges_.widen(frame.scene);
  const bool must_wait = !held_.empty() || Film_ranges::are_wanted_by(frame.scene);
  if (must_wait && !is_over_budget_) {
    hold(std::move(frame));
  } else {
    hand_over(std::move(frame));
  }
  Q_EMIT changed();
}

void Film_recorder::hold(Film_frame frame) {
  for (const Scene_layer& layer : frame.scene.layers)
    if (layer.primitives && held_pictures_.insert(layer.primitives.get()).second)
      held_bytes_ += bytes_of(*layer.primitives);
  held_.push_back(std::move(frame));
  is_over_budget_ = held_bytes_ > held_bytes_budget_;
  if (is_over_budget_) release();
}

void Film_recorder::release() {
  for (Film_frame& frame : std::exchange(held_, {})) hand_over(std::move(frame));
  held_pictures_.clear();
}

void Film_recorder::hand_over(Film_frame frame) {
  ranges_.apply_to(frame.scene);
  run([this, frame = std::move(frame), owner = std::weak_ptr(session_)](Session& session) -> std::function<void()> {
    if (!session.film) throw Cancelled();
    session.film->add(frame, session.stop.get_token());
    return [this, owner] {
      if (owner.lock() != session_) return;
      ++encoded_;
      Q_EMIT changed();
    };
  });
}

void Film_recorder::finish() {
  if (!session_ || is_finishing_) return;
  if (frames_ == 0) {
    cancel();
    return;
  }
  is_finishing_ = true;
  release();
  run([this, owner = std::weak_ptr(session_)](Session& session) -> std::function<void()> {
    if (!session.film) throw Cancelled();
    const std::string note = session.film->finish(session.stop.get_token());
    session.film.reset();
    return [this, owner, note = QString::fromStdString(note)] {
      if (owner.lock() != session_) return;
      const QString file = QString::fromStdString(request_.file.string());
      end();
      Q_EMIT finished(file, note);
    };
  });
  Q_EMIT changed();
}

void Film_recorder::cancel() {
  if (!session_) return;
  session_->stop.request_stop();
  jobs_.cancel();
  run([](Session& session) -> std::function<void()> {
    session.film.reset();
    return [] {};
  });
  end();
}

void Film_recorder::end() {
  session_.reset();
  frames_ = 0;
  encoded_ = 0;
  is_finishing_ = false;
  ranges_ = {};
  held_.clear();
  held_pictures_.clear();
  held_bytes_ = 0;
  is_over_budget_ = false;
  Q_EMIT changed();
}

}  // namespace mesecina
