// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <QtTest>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>

#include "app3d/main_window_3.h"
#include "geometries/modules_3.h"
#include "layers/space_pictures.h"

namespace mesecina {

/// A window with a real canvas. Flights are off: views are there at once.
class Window_3 : public testing::Test {
 protected:
  void SetUp() override { open({}); }

  void open(const Startup& startup) {
    Formats formats = spatial_formats();
    add_space_picture_formats(formats);
    window_.reset();
    window_ = std::make_unique<Main_window_3>(make_registry_3(), std::move(formats), startup);
    window_->resize(1000, 640);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    ASSERT_NE(window_->viewer(), nullptr);
    window_->actions()["smooth-flights"]->setChecked(false);
    viewer().set_flight_time(0);
  }

  Viewer_3& viewer() { return *window_->viewer(); }
  static bool wait_until(const std::function<bool()>& condition) {
    constexpr int patience = 60000;
    return QTest::qWaitFor(condition, patience);
  }
  bool wait_until_idle() {
    return wait_until([&] { return !window_->computation().is_busy() && !window_->files().jobs().is_busy(); });
  }
  std::filesystem::path write(const char* name, const char* text) const {
    const std::filesystem::path path = folder_.filePath(QLatin1String(name)).toStdString();
    std::ofstream(path) << text;
    return path;
  }
  void drag(Qt::MouseButton button, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(&viewer(), button, modifiers, from);
    constexpr int steps = 5;
    for (int i = 1; i <= steps; ++i) {
      const QPointF at = QPointF(from) + (QPointF(to) - QPointF(from)) * i / steps;
      QMouseEvent move(QEvent::MouseMove, at, viewer().mapToGlobal(at), Qt::NoButton, button, modifiers);
      QApplication::sendEvent(&viewer(), &move);
    }
    QTest::mouseRelease(&viewer(), button, modifiers, to);
  }
  void hover(const QPointF& at) {
    QMouseEvent move(QEvent::MouseMove, at, viewer().mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&viewer(), &move);
  }
  /// One ball of radius 1 around the origin.
  void open_ball() {
    open({{write("one.cin", "0 0 0 1\n")}, {"given-balls"}, {}});
    ASSERT_TRUE(wait_until_idle());
    ASSERT_TRUE(wait_until([&] { return window_->computation().primitives("given-balls") != nullptr; }));
    viewer().grab_picture();
  }

  std::unique_ptr<Main_window_3> window_;
  QTemporaryDir folder_;
};

}  // namespace mesecina
