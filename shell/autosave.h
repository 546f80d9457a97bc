// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/scene_store.h"

namespace mesecina {

/// Writes the scene of a window into its store soon after every change, on a thread of its own. Inputs that stay the
/// same are not written again.
class Autosave : public QObject {
  Q_OBJECT
 public:
  /// From a change to the beginning of writing.
  static constexpr std::chrono::milliseconds delay{400};

  /// `scene` gives what there is now; it is called on the window's thread and should cost next to nothing. Throws
  /// File_error where the store cannot be written.
  Autosave(const Scene_store& store, std::function<Session()> scene, QObject* parent = nullptr);
  /// Leaves what was written as after a crash, unless close() was called.
  ~Autosave() override;

  /// Something has changed.
  void touch();
  /// Writes what is not written yet, waits for it, and moves the scene to the kept ones; or removes it.
  void close(bool is_kept);
  const std::filesystem::path& folder() const { return running_.folder(); }

 Q_SIGNALS:
  /// The scene could not be written; said once per reason.
  void failed(const QString& reason);
  /// What there was when this was begun is on the disk.
  void written();

 private:
  void hand_over();
  void serve(const std::stop_token& stop);
  void write(const Session& session);

  std::function<Session()> scene_;
  QTimer timer_;
  QString last_reason_;  ///< this thread only
  Running_scene running_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Session> waiting_;
  std::jthread thread_;
};

}  // namespace mesecina
