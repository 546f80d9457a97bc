// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSize>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shell/computation.h"
#include "shell/document.h"
#include "shell/film_recorder.h"
#include "shell/frame_player.h"
#include "shell/preferences.h"
#include "shell/record_panel.h"

class QToolButton;

namespace mesecina {

/// Films of what a window shows: gives the recorder its frames, which are scenes painted as in files, never pictures of
/// the screen; and plays animated settings.
class Window_recording : public QObject {
  Q_OBJECT
 public:
  /// What it needs of the window.
  struct Window {
    QString program;  ///< that remembers choices
    /// What is in view of a canvas of the size `seen`, as a picture of another size.
    std::function<Film_frame(const QSize& size, const QSize& seen)> frame;
    std::function<QSize()> seen;
    std::function<QSize()> size;  ///< of the picture in the window, in pixels
    std::function<QString(const QString& suggestion, const QString& filters)> choose_file;
    std::function<QString()> stem;  ///< of the document
    std::function<void(bool is_error, const QString& line)> tell;
    std::function<void()> show_panel;
  };
  Window_recording(std::shared_ptr<const Registry> registry, std::shared_ptr<const Formats> formats, Document& document,
                   Computation& computation, Window window, QWidget* parent);

  Record_panel& panel() { return *panel_; }
  /// There is a film, or is about to be one, that comes to its end without anybody doing something.
  bool ends_by_itself() const;
  /// Records what is wished into exactly this file, also over one that is there. What is wrong is told.
  void record_wish(const Film_wish& wish);
  Film_recorder& recorder() { return recorder_; }
  Frame_player& player() { return player_; }
  /// A red dot with the number of frames, while it records; for the status bar.
  QWidget* indicator() const;

  /// What the panel says, and what is animated.
  Film_wish wish() const;
  /// Shows it in the panel. A file that is there already is not proposed again, but the next free name.
  void show(const Film_wish& wish);

  /// How the setting moved last; else over what its slider shows.
  Sweep sweep(const std::string& setting, double from, double to) const;
  /// What moves together in the last animation; empty before the first.
  const std::vector<Sweep>& animation() const { return animation_; }
  /// Of the following, `sweeps` are of different settings, at least one.
  void remember(const std::vector<Sweep>& sweeps);
  void play(const std::vector<Sweep>& sweeps);
  /// Makes them what is recorded next, and shows the panel.
  void prepare(const std::vector<Sweep>& sweeps);
  /// Plays the last animation, or stops.
  void play_or_stop();

 public Q_SLOTS:
  void record();
  /// Ends the film and keeps it.
  void stop();
  /// Nothing of it stays.
  void cancel();
  /// The view was changed.
  void note_change();

 Q_SIGNALS:
  /// Something of wish().
  void wish_changed();
  /// Whether it records, or has a film to complete.
  void active_changed(bool is_active);

 private:
  void begin_source();
  void take_frame();
  Film_frame frame_now() const;
  void take_change();
  void choose_file();
  void suggest_file();
  void show_state();
  void restore();
  void store();
  bool may_go_on() const;
  Played_frames played_frames();

  std::shared_ptr<const Registry> registry_;
  Document& document_;
  Computation& computation_;
  Window window_;
  Film_recorder recorder_;
  Frame_player player_;
  Record_panel* panel_;
  QToolButton* indicator_;
  std::map<std::string, Sweep> sweeps_;  ///< by setting: how each moved last
  std::vector<Sweep> animation_;
  Record_panel::Source source_ = Record_panel::Source::changes;  ///< of the film that is recorded
  bool is_player_recorded_ = false;
  bool is_waiting_ = false;  ///< for the computation, before the first frame
  bool was_active_ = false;
  int expected_ = 0;
  QSize seen_;  ///< when the film began: what opens or closes beside the canvas does not change what is in view
  std::optional<Film_frame> last_frame_;
  QTimer change_timer_;
};

}  // namespace mesecina
