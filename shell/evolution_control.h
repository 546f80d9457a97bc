// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/batch/command_line.h"
#include "shell/computation.h"
#include "shell/document.h"
#include "shell/evolver.h"

namespace mesecina {

/// What one can do with evolutions in a window: choose one, make steps, go from step to step, play.
class Evolution_control : public QObject {
  Q_OBJECT
 public:
  /// What comes after the end of the steps that are played.
  enum class Repeat { once, wrap, ping_pong };
  enum class Motion { none, forward, backward };

  Evolution_control(std::shared_ptr<const Registry> registry, Document& document, Computation& computation,
                    QObject* parent = nullptr);

  const Registry& registry() const { return *registry_; }
  Document& document() { return document_; }
  const Document& document() const { return document_; }
  Evolver& evolver() { return evolver_; }
  const Evolver& evolver() const { return evolver_; }

  /// Id of the evolution that steps are made by; empty where there is none. Until one is chosen or there are steps, the
  /// first that suits the data.
  const std::string& chosen() const { return chosen_; }
  /// Why the evolution does not suit the data that is shown; empty where it does, and for unknown ids.
  QString why_unfit(const std::string& evolution) const;
  /// What is made next starts at the place that is shown, if its track ends with another evolution. Unknown ids are
  /// left alone.
  void choose(const std::string& evolution);
  void choose_next(int direction);

  /// Steps that are made at once.
  int steps_ahead() const { return steps_ahead_; }
  void set_steps_ahead(int steps);
  /// At the end of the track, or where another evolution was chosen at the place that is shown; the document goes
  /// along.
  void make_steps();
  /// One after the other, from the place that is shown. A failed one is told, and the others begin where it ended.
  void run(std::vector<Evolution_order> orders);
  /// Steps are being made, or will be when others are.
  bool is_making_steps() const { return evolver_.is_busy() || !orders_.empty(); }

  /// The next place; at the end of the track it is made.
  void forward();
  void back();
  void first();
  void last();
  void go_to(std::size_t position);
  /// So many steps on, or back where negative, as far as there are.
  void go_by(int steps);

  void play(Motion motion);
  void pause();
  Motion motion() const { return motion_; }
  bool is_playing() const { return motion_ != Motion::none; }
  double steps_per_second() const { return speed_; }
  /// More than 0.
  void set_steps_per_second(double speed);
  Repeat repeat() const { return repeat_; }
  void set_repeat(Repeat repeat);
  /// The places that are repeated; they are bounded by the steps that there are.
  std::size_t range_begin() const;
  std::size_t range_end() const;
  void set_range(std::size_t begin, std::size_t end);
  void set_whole_range();

  /// Pauses, or else stops making steps; false when there was neither.
  bool stop();

 Q_SIGNALS:
  /// Anything of this, or the track of the document, or the place on it, or which evolutions suit the data.
  void changed();
  void told(const QString& note);

 private:
  void react(const Document_change& change);
  bool is_newly_chosen() const;
  void choose_first_fit();
  void begin_steps(std::uint64_t count, bool follows);
  void move_to(std::size_t position);
  void tick();
  bool can_go_on();
  void run_next();

  std::shared_ptr<const Registry> registry_;
  Document& document_;
  Computation& computation_;
  Evolver evolver_;
  std::string chosen_;
  bool is_choice_new_ = false;  ///< made by the user since the last step
  bool is_choice_free_ = true;  ///< nobody has chosen, and no step was made
  int steps_ahead_ = 20;
  std::deque<Evolution_order> orders_;
  Motion motion_ = Motion::none;
  double speed_ = 10;
  Repeat repeat_ = Repeat::once;
  std::size_t range_begin_ = 0;
  std::size_t range_end_ = std::size_t(-1);  ///< as far as there are steps
  bool is_moving_ = false;
  QTimer timer_;
};

}  // namespace mesecina
