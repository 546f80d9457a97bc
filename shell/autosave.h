// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <thread>

#include "core/scene_store.h"

namespace mesecina {

/// Writes the scene of a window into its store soon after every change, on a thread of its own. Inputs that stay the
/// same are not written again. At most one scene is being written and one waits, the newest.
class Autosave : public QObject {
  Q_OBJECT
 public:
  /// From a change to the beginning of writing.
  static constexpr std::chrono::milliseconds delay{400};

  /// `scene` gives what there is now; it is called on the window's thread and should cost next to nothing. Throws
  /// File_error where the store cannot be written.
  Autosave(const Scene_store& store, std::function<Session()> scene, QObject* parent = nullptr);
  /// Leaves what was written as after a crash, unless close() was called. Waits for what is being written, unless
  /// abandon() was called.
  ~Autosave() override;

  /// Something has changed.
  void touch();
  /// Begins to write what is not written yet, without the delay.
  void flush();
  /// Something is not on the disk yet.
  bool is_busy() const;
  /// Moves the scene to the kept ones, with what was not written yet; or removes it. Waits for the disk.
  void close(bool is_kept);
  /// What is being written is left to itself, for a disk that does not answer.
  void abandon();
  const std::filesystem::path& folder() const;

 Q_SIGNALS:
  /// The scene could not be written; said once per reason.
  void failed(const QString& reason);
  /// What there was when this was begun is on the disk.
  void written();

 private:
  struct Work;
  void hand_over();
  static void serve(const std::shared_ptr<Work>& work, const std::stop_token& stop);
  static void write(Work& work, const Session& session);
  void take_result(const QString& reason);

  std::function<Session()> scene_;
  QTimer timer_;
  QString last_reason_;
  std::shared_ptr<Work> work_;  ///< outlives this object where it was abandoned
  std::jthread thread_;
};

}  // namespace mesecina
