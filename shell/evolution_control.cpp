// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/evolution_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/help_text.h"

namespace mesecina {

namespace {
constexpr auto as_far_as_there_are = static_cast<std::size_t>(-1);
}  // namespace

Evolution_control::Evolution_control(std::shared_ptr<const Registry> registry, Document& document,
                                     Computation& computation, QObject* parent)
    : QObject(parent),
      registry_(std::move(registry)),
      document_(document),
      computation_(computation),
      evolver_(registry_, document) {
  choose_first_fit();
  connect(&document_, &Document::changed, this, &Evolution_control::react);
  connect(&evolver_, &Evolver::busy_changed, this, [this](bool is_busy) {
    if (!is_busy) run_next();
    Q_EMIT changed();
  });
  connect(&evolver_, &Evolver::ended, this, [this](const QString& evolution, const QString& reason) {
    Q_EMIT told(tr("%1 ended at step %2: %3").arg(evolution).arg(evolver_.position()).arg(reason));
  });
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Evolution_control::tick);
}

QString Evolution_control::why_unfit(const std::string& evolution) const {
  const Evolution_spec* spec = registry_->find_evolution(evolution);
  if (!spec) return {};
  const std::string reason = mesecina::why_unfit(*spec, {document_.inputs(), document_.settings()});
  return QString::fromStdString(with_labels(reason, *registry_));
}

void Evolution_control::choose_first_fit() {
  const auto& all = registry_->evolutions();
  const auto fit = std::ranges::find_if(all, [this](const auto& spec) { return why_unfit(spec.id).isEmpty(); });
  if (!all.empty()) chosen_ = fit == all.end() ? all.front().id : fit->id;
}

void Evolution_control::choose(const std::string& evolution) {
  if (!registry_->find_evolution(evolution)) return;
  is_choice_free_ = false;
  if (evolution == chosen_) return;
  chosen_ = evolution;
  is_choice_new_ = true;
  Q_EMIT changed();
}

void Evolution_control::choose_next(int direction) {
  const auto& all = registry_->evolutions();
  const auto it = std::ranges::find(all, chosen_, &Evolution_spec::id);
  if (it == all.end()) return;
  const auto wanted = (it - all.begin()) + direction;
  if (wanted >= 0 && wanted < static_cast<std::ptrdiff_t>(all.size())) choose(all[static_cast<std::size_t>(wanted)].id);
}

void Evolution_control::set_steps_ahead(int steps) {
  if (steps < 1 || steps == steps_ahead_) return;
  steps_ahead_ = steps;
  Q_EMIT changed();
}

bool Evolution_control::is_newly_chosen() const {
  return is_choice_new_ && document_.track() && document_.track()->places.back().evolution != chosen_;
}

void Evolution_control::begin_steps(std::uint64_t count, bool follows) {
  evolver_.make_steps(chosen_, count, is_newly_chosen() ? document_.position() : document_.step_count(), follows);
}

void Evolution_control::make_steps() { begin_steps(static_cast<std::uint64_t>(steps_ahead_), true); }

void Evolution_control::run(std::vector<Evolution_order> orders) {
  orders_.assign(orders.begin(), orders.end());
  if (!evolver_.is_busy()) run_next();
}

void Evolution_control::run_next() {
  while (!orders_.empty() && !evolver_.is_busy()) {
    const Evolution_order order = std::move(orders_.front());
    orders_.pop_front();
    if (!registry_->find_evolution(order.id)) {
      Q_EMIT told(tr("There is no evolution '%1'.").arg(QString::fromStdString(order.id)));
      continue;
    }
    choose(order.id);
    begin_steps(order.steps, true);
  }
}

void Evolution_control::react(const Document_change& change) {
  // What is edited while it plays would be left at once.
  if (change.inputs && !is_moving_ && !evolver_.is_busy()) pause();
  if (!change.track) {
    if (!change.inputs && !change.settings) return;
    if (is_choice_free_) choose_first_fit();
    Q_EMIT changed();
    return;
  }
  const Track_pointer& track = document_.track();
  if (track && track->places.back().evolution == chosen_) is_choice_new_ = false;
  if (track && !is_choice_new_) chosen_ = track->places.back().evolution;
  if (track) is_choice_free_ = false;
  if (is_choice_free_) choose_first_fit();
  Q_EMIT changed();
}

void Evolution_control::forward() {
  pause();
  if (!is_newly_chosen() && document_.position() < document_.step_count()) {
    move_to(document_.position() + 1);
  } else if (!evolver_.is_busy()) {
    begin_steps(1, true);
  }
}

void Evolution_control::back() { go_by(-1); }

void Evolution_control::go_by(int steps) {
  const auto here = static_cast<std::ptrdiff_t>(document_.position());
  go_to(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, here + steps)));
}

void Evolution_control::first() { go_to(0); }

void Evolution_control::last() { go_to(document_.step_count()); }

void Evolution_control::go_to(std::size_t position) {
  pause();
  move_to(position);
}

void Evolution_control::move_to(std::size_t position) {
  is_moving_ = true;
  document_.go_to(position);
  is_moving_ = false;
}

std::size_t Evolution_control::range_begin() const { return std::min(range_begin_, document_.step_count()); }

std::size_t Evolution_control::range_end() const { return std::min(range_end_, document_.step_count()); }

void Evolution_control::set_range(std::size_t begin, std::size_t end) {
  if (begin > end) std::swap(begin, end);
  range_begin_ = begin;
  range_end_ = end >= document_.step_count() ? as_far_as_there_are : end;
  Q_EMIT changed();
}

void Evolution_control::set_whole_range() { set_range(0, as_far_as_there_are); }

void Evolution_control::set_repeat(Repeat repeat) {
  repeat_ = repeat;
  Q_EMIT changed();
}

void Evolution_control::set_steps_per_second(double speed) {
  if (!(speed > 0)) return;
  speed_ = speed;
  constexpr double milliseconds = 1000;
  timer_.setInterval(std::max(1, static_cast<int>(std::lround(milliseconds / speed_))));
  Q_EMIT changed();
}

void Evolution_control::play(Motion motion) {
  const std::size_t count = document_.step_count();
  const bool is_at_end = document_.position() == count && (repeat_ == Repeat::once || count == 0);
  if (motion == Motion::forward && (is_at_end || is_newly_chosen()) && !evolver_.is_busy())
    begin_steps(static_cast<std::uint64_t>(steps_ahead_), false);
  if (motion == Motion::backward && document_.position() == 0) move_to(count);
  const bool is_something = document_.step_count() > 0 || evolver_.is_busy();
  motion_ = is_something ? motion : Motion::none;
  set_steps_per_second(speed_);
  if (is_playing()) {
    timer_.start();
  } else {
    timer_.stop();
  }
}

void Evolution_control::pause() {
  if (!is_playing()) return;
  motion_ = Motion::none;
  timer_.stop();
  Q_EMIT changed();
}

void Evolution_control::tick() {
  // Every step is seen: the pictures of this one come before the next.
  if (computation_.is_busy()) return;
  if (!can_go_on()) pause();
}

bool Evolution_control::can_go_on() {
  const std::size_t last = evolver_.is_busy() ? evolver_.position() : document_.step_count();
  const bool is_repeated = repeat_ != Repeat::once;
  const std::size_t begin = is_repeated ? std::min(range_begin_, last) : 0;
  const std::size_t end = is_repeated ? std::min(range_end_, last) : last;
  const std::size_t here = document_.position();
  if (motion_ == Motion::forward) {
    if (here < end) {
      move_to(std::max(here + 1, begin));
    } else if (evolver_.is_busy() && end == last) {
      return true;
    } else if (!is_repeated || begin == end) {
      return false;
    } else if (repeat_ == Repeat::wrap) {
      move_to(begin);
    } else {
      motion_ = Motion::backward;
      move_to(end - 1);
    }
    return true;
  }
  if (here > begin) {
    move_to(std::min(here - 1, end));
  } else if (!is_repeated || begin == end) {
    return false;
  } else if (repeat_ == Repeat::wrap) {
    move_to(end);
  } else {
    motion_ = Motion::forward;
    move_to(begin + 1);
  }
  return true;
}

bool Evolution_control::stop() {
  orders_.clear();
  if (is_playing()) {
    pause();
    return true;
  }
  if (!evolver_.is_busy()) return false;
  evolver_.cancel();
  return true;
}

}  // namespace mesecina
