// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <algorithm>
#include <vector>

#include "app3d/viewer_3.h"

namespace mesecina {

/// A way of the camera through key frames, and playing it in a viewer. Stops when somebody takes the camera.
class Camera_player_3 : public QObject {
  Q_OBJECT
 public:
  explicit Camera_player_3(Viewer_3& viewer, QObject* parent = nullptr);

  const std::vector<Camera_3>& key_frames() const { return key_frames_; }
  /// Stops playing.
  void set_key_frames(std::vector<Camera_3> key_frames);
  /// What the viewer sees now becomes the last key frame.
  void add();
  /// Takes the key frame away that is most like what the viewer sees; nothing when there is none.
  void remove();

  bool is_playing() const { return timer_.isActive(); }
  /// From the first key frame; previous_view() of the viewer leads back. Nothing happens with less than two.
  void play();
  void stop();
  void set_loop(bool is_loop) { is_loop_ = is_loop; }
  /// Between key frames; from a twentieth to a minute.
  void set_seconds(double seconds) { seconds_ = std::clamp(seconds, 0.05, 60.0); }
  double seconds() const { return seconds_; }

 Q_SIGNALS:
  /// Key frames, or whether it plays.
  void changed();

 private:
  void go_on();

  Viewer_3& viewer_;
  std::vector<Camera_3> key_frames_;
  QTimer timer_;
  QElapsedTimer time_;
  bool is_loop_ = false;
  double seconds_ = 2;
};

}  // namespace mesecina
