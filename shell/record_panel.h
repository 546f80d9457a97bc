// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "core/film_wish.h"
#include "core/formats/film.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace mesecina {

class Number_field;

/// What is recorded, into which file and in which size; the buttons to begin and end. It records nothing itself.
class Record_panel : public QWidget {
  Q_OBJECT
 public:
  using Source = Film_wish::Source;
  /// What is going on, for the buttons and the line below them.
  struct State {
    bool is_recording = false;
    bool is_finishing = false;
    int frames = 0;
    int waiting = 0;
    int expected = 0;  ///< frames; 0: until it is stopped
  };

  /// `dimension` of the space.
  explicit Record_panel(int dimension, QWidget* parent = nullptr);

  Source source() const;
  void set_source(Source source);
  /// Frames of one turn.
  int turntable_frames() const;
  void set_turntable_frames(int frames);
  /// File, size, rate, background; not the colour of the background.
  Film_request request() const;
  void set_file(const QString& file);
  void set_size(const QSize& size);
  void set_frames_per_second(double frames);
  void set_transparent(bool is_transparent);
  /// "Scale, 100 frames"; empty: nothing is animated yet.
  void set_animation_text(const QString& text);
  /// Steps that the document's evolution has made.
  void set_evolution_steps(int steps);
  void show_state(const State& state);
  /// The result of the last film, below the buttons.
  void show_note(const QString& note);

 Q_SIGNALS:
  void record_requested();
  void stop_requested();
  void cancel_requested();
  void file_requested();
  /// As large as the picture in the window.
  void window_size_requested();
  /// Something of source(), turntable_frames() and request().
  void edited();

 private:
  void show_source();
  QWidget* make_size_row();
  QWidget* make_file_row();

  QComboBox* source_;
  QLabel* about_;
  QSpinBox* turn_frames_;
  QSpinBox* width_;
  QSpinBox* height_;
  Number_field* rate_;
  QCheckBox* is_transparent_;
  QLineEdit* file_;
  QPushButton* record_;
  QPushButton* cancel_;
  QLabel* status_;
  QString animation_;
  int evolution_steps_ = 0;
  State state_;
};

}  // namespace mesecina
