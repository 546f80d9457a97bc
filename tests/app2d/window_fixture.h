// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QPoint>
#include <QTemporaryDir>
#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include "app2d/main_window_2.h"

namespace mesecina {

/// A shown window on the built-in example and the means to use it like a user.
class Window_fixture : public testing::Test {
 protected:
  /// Replaces the window.
  void open_window(Startup startup = {});
  /// A window of a new user.
  void SetUp() override;

  Main_window_2& window() { return *window_; }
  Document& document() { return window_->document(); }
  Canvas_2& canvas() { return window_->canvas(); }

  std::vector<Point_2> points() const;
  /// Where a point of the plane is on the canvas.
  QPoint pixel(const Point_2& position) const;
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {});
  void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {});
  void press(int key, Qt::KeyboardModifiers modifiers = {});
  void trigger(const char* action) { window_->actions()[QLatin1String(action)]->trigger(); }
  /// Runs the event loop until the condition holds; false after ten seconds.
  static bool wait_until(const std::function<bool()>& condition);
  bool wait_until_current(const char* layer);
  /// Runs the event loop until everything that is being saved is in its files.
  bool wait_until_saved() { return window_->files().finish_saving(std::chrono::seconds(10)); }
  QString write(const char* name, const QByteArray& text) const;

  std::unique_ptr<Main_window_2> window_;
  QTemporaryDir folder_;
};

}  // namespace mesecina
