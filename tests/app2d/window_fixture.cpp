// SPDX-License-Identifier: GPL-3.0-or-later
#include "window_fixture.h"

#include <QApplication>
#include <QFile>
#include <QMouseEvent>
#include <QSettings>
#include <QtTest>

#include "core/session_formats.h"
#include "geometries/modules_2.h"
#include "layers/picture_formats.h"

namespace mesecina {

void Window_fixture::SetUp() {
  QSettings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("mesecina"), QStringLiteral("mesecina2d"))
      .clear();
  open_window();
}

void Window_fixture::open_window(Startup startup) {
  Formats formats = planar_formats();
  add_picture_formats(formats);
  const auto registry = make_registry_2();
  add_session_formats(formats, registry);
  window_.reset();
  window_ = std::make_unique<Main_window_2>(registry, std::move(formats), std::move(startup));
  window_->resize(1100, 700);
  window_->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  window_->activateWindow();
  canvas().setFocus();
}

std::vector<Point_2> Window_fixture::points() const {
  const auto points = window_->document().inputs().get(points_input);
  return points ? *points : std::vector<Point_2>();
}

QPoint Window_fixture::pixel(const Point_2& position) const {
  const Canvas_2& canvas = window_->canvas();
  const Point_2 p = canvas.view().to_pixel(position, canvas.width(), canvas.height());
  return {qRound(p.x), qRound(p.y)};
}

void Window_fixture::drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
  QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, from);
  constexpr int steps = 5;
  for (int i = 1; i <= steps; ++i) {
    // QTest::mouseMove tells neither buttons nor modifiers.
    const QPointF at = QPointF(from) + (QPointF(to) - QPointF(from)) * i / steps;
    QMouseEvent move(QEvent::MouseMove, at, canvas().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
    QApplication::sendEvent(&canvas(), &move);
  }
  QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, to);
}

void Window_fixture::click(const QPoint& at, Qt::KeyboardModifiers modifiers) {
  // So that two clicks are never a double click.
  QTest::qWait(QApplication::doubleClickInterval() + 20);
  QTest::mouseClick(&canvas(), Qt::LeftButton, modifiers, at);
}

void Window_fixture::press(int key, Qt::KeyboardModifiers modifiers) {
  QTest::keyClick(&canvas(), static_cast<Qt::Key>(key), modifiers);
}

bool Window_fixture::wait_until(const std::function<bool()>& condition) {
  constexpr int patience = 10000;
  return QTest::qWaitFor(condition, patience);
}

bool Window_fixture::wait_until_current(const char* layer) {
  return wait_until([&] {
    return window_->computation().status(layer).state == Layer_status::State::current &&
           !window_->computation().is_busy();
  });
}

QString Window_fixture::write(const char* name, const QByteArray& text) const {
  const QString path = folder_.filePath(QString::fromUtf8(name));
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
  return path;
}

}  // namespace mesecina
