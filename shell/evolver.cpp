// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/evolver.h"

#include <algorithm>
#include <functional>
#include <thread>
#include <utility>

#include "core/help_text.h"

namespace mesecina {

Evolver::Evolver(std::shared_ptr<const Registry> registry, Document& document, QObject* parent)
    : QObject(parent), registry_(std::move(registry)), document_(document) {
  connect(&document_, &Document::changed, this, &Evolver::react);
}

Evolver::~Evolver() { worker_.reset(); }

void Evolver::make_steps(const std::string& evolution, std::uint64_t count, std::size_t position, bool follows) {
  const Evolution_spec* spec = registry_->find_evolution(evolution);
  if (!spec || count == 0 || position > document_.step_count()) return;
  if (!worker_) {
    Worker::Listener listener;
    listener.progressed = [this](std::uint64_t ticket, const std::string&, double fraction) {
      if (!is_busy_ || ticket != ticket_) return;
      Q_EMIT progressed(progress_text(), (static_cast<double>(made_) + fraction) / static_cast<double>(wanted_));
    };
    listener.finished_step = [this](const Worker::Step_result& result) { take(result); };
    listener.finished = [this](std::uint64_t ticket, bool) { finish(ticket); };
    // Closures that come after this object is gone are dropped by Qt with it.
    const auto deliver = [this](std::function<void()> closure) {
      QMetaObject::invokeMethod(this, std::move(closure), Qt::QueuedConnection);
    };
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    worker_ = std::make_unique<Worker>(registry_, threads, std::move(listener), deliver);
  }
  evolution_ = spec;
  made_ = 0;
  wanted_ = count;
  position_ = position;
  follows_ = follows;
  track_ = document_.track();
  state_ = {document_.inputs(), document_.settings()};
  std::uint64_t steps_done = 0;
  if (track_) {
    const Evolution_track::Place& place = track_->places[position];
    state_ = {place.inputs, settings_at(*track_, position, document_.settings())};
    if (place.evolution == evolution) steps_done = place.number;
  }
  ++ticket_;
  worker_->cancel();
  worker_->evolve({ticket_, state_, evolution, steps_done, count});
  set_busy(true);
  Q_EMIT progressed(progress_text(), 0);
}

void Evolver::cancel() {
  if (!is_busy_) return;
  // Steps that were delivered but not yet taken are not wanted any more.
  ++ticket_;
  worker_->cancel();
  set_busy(false);
}

void Evolver::react(const Document_change& change) {
  if (!is_busy_ || is_adding_) return;
  const bool is_other_track = document_.track() != track_;
  const bool is_other_start = !document_.track() && change.inputs;
  if (is_other_track || is_other_start) cancel();
}

void Evolver::take(const Worker::Step_result& result) {
  if (!is_busy_ || result.ticket != ticket_) return;
  if (!result.outcome) {
    Q_EMIT ended(QString::fromStdString(evolution_->label),
                 QString::fromStdString(with_labels(result.outcome.reason, *registry_)));
    return;
  }
  const Evolution_state before = std::exchange(state_, *result.outcome.value);
  is_adding_ = true;
  ++made_;
  document_.add_step(*evolution_, position_, before, state_, follows_ && document_.position() == position_);
  ++position_;
  track_ = document_.track();
  is_adding_ = false;
  Q_EMIT progressed(progress_text(), static_cast<double>(made_) / static_cast<double>(wanted_));
}

void Evolver::finish(std::uint64_t ticket) {
  if (ticket == ticket_) set_busy(false);
}

void Evolver::set_busy(bool is_busy) {
  if (is_busy == is_busy_) return;
  is_busy_ = is_busy;
  Q_EMIT busy_changed(is_busy);
}

QString Evolver::progress_text() const {
  return tr("%1, step %2 of %3")
      .arg(QString::fromStdString(evolution_->label))
      .arg(std::min(made_ + 1, wanted_))
      .arg(wanted_);
}

}  // namespace mesecina
