// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "core/animation.h"
#include "shell/computation.h"
#include "shell/document.h"

namespace mesecina {

/// Changes of a document, one per frame.
struct Played_frames {
  int count = 0;
  std::function<void(int frame)> show;
  /// Whether the document still has what `show` has put there.
  std::function<bool(int frame)> is_there;
};

/// Settings that move: all of it is one step of undo, "Animate Scale". The sweeps must have passed check_sweep.
Played_frames frames_of_sweeps(std::shared_ptr<const Registry> registry, Document& document, std::vector<Sweep> sweeps);
/// The places of the document's evolution track, from the first to the last there is now; no step of undo.
Played_frames frames_of_track(Document& document);

/// Shows frames one after the other, each when everything visible of the last one is there. No frame is left out,
/// however long it takes. It stops when somebody else takes back what it has shown.
class Frame_player : public QObject {
  Q_OBJECT
 public:
  explicit Frame_player(Computation& computation, QObject* parent = nullptr);

  /// From the first frame, not faster than so many per second. `may_go_on` (optional) is asked before each further
  /// frame; when it refuses, it is asked again at go_on().
  void play(Played_frames frames, double frames_per_second, std::function<bool()> may_go_on = {});
  bool is_playing() const { return is_playing_; }
  int frame() const { return frame_; }
  int count() const { return frames_.count; }

 public Q_SLOTS:
  /// The document stays as it is.
  void stop();
  void go_on();

 Q_SIGNALS:
  /// Everything visible of this frame is there.
  void shown(int frame);
  /// Whether it plays, and which frame.
  void changed();
  /// `is_complete`: every frame was shown.
  void ended(bool is_complete);

 private:
  void show_frame();
  void check();
  void end(bool is_complete);

  Computation& computation_;
  Played_frames frames_;
  std::function<bool()> may_go_on_;
  int frame_ = 0;
  bool is_playing_ = false;
  bool is_shown_ = false;
  double interval_ = 0;  ///< milliseconds
  QElapsedTimer since_shown_;
  QTimer timer_;
};

}  // namespace mesecina
