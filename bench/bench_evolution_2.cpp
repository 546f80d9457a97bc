// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of scrubbing: 100 computed steps of 2000 points with four layers on, in the window of mesecina2d, with and
// without the drawing. Rows name the canvas they were measured with; without a display it is QPainter's.
#include <QApplication>
#include <QElapsedTimer>
#include <QLocale>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <iostream>
#include <set>
#include <stdexcept>

#include "app2d/main_window_2.h"
#include "bench/curves.h"
#include "bench/table.h"
#include "geometries/modules_2.h"
#include "layers/picture_formats.h"

namespace {

using namespace mesecina;

constexpr std::size_t step_count = 100;
constexpr double megabyte = 1 << 20;

void wait_until(const std::function<bool()>& condition) {
  constexpr int patience = 120000;
  constexpr int slice = 5;
  QElapsedTimer timer;
  timer.start();
  while (!condition()) {
    if (timer.elapsed() > patience) throw std::runtime_error("the window does not come to rest");
    QCoreApplication::processEvents(QEventLoop::AllEvents, slice);
  }
}

std::unique_ptr<Main_window_2> make_window(const QSize& size) {
  Formats formats = planar_formats();
  add_picture_formats(formats);
  auto window = std::make_unique<Main_window_2>(make_registry_2(), std::move(formats), Startup{});
  window->resize(size);
  window->show();
  const std::set<std::string> shown{"points", "voronoi", "one-step-crust", "medial-axis"};
  constexpr std::size_t points = 2000;
  Document_state state = window->document().state();
  state.inputs = Inputs().with(points_input, rippled_curve(points));
  for (Layer_entry& entry : state.layers) entry.style.visible = shown.contains(entry.id);
  window->document().edit(std::move(state), QStringLiteral("Curve"));
  return window;
}

/// Counts what is painted on a canvas.
class Paint_counter : public QObject {
 public:
  explicit Paint_counter(QWidget& canvas) {
    for (QWidget* surface : canvas.findChildren<QWidget*>()) surface->installEventFilter(this);
  }
  std::size_t count() const { return count_; }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++count_;
    return false;
  }

 private:
  std::size_t count_ = 0;
};

/// From the last step, which is shown, back and forth over all.
double steps_per_second(Main_window_2& window, const std::function<void()>& draw) {
  constexpr int passes = 4;
  std::size_t steps = 0;
  const double time = seconds([&] {
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t i = 1; i <= step_count; ++i, ++steps) {
        window.evolution().go_to(pass % 2 == 0 ? step_count - i : i);
        draw();
      }
    }
  });
  return static_cast<double>(steps) / time;
}

void bench_scrubbing(Table& table, const QSize& size) {
  const auto window = make_window(size);
  wait_until([&] { return !window->computation().is_busy(); });
  window->evolution().set_steps_ahead(step_count);
  const double making = seconds([&] {
    window->evolution().make_steps();
    wait_until([&] { return window->document().step_count() == step_count && !window->computation().is_busy(); });
  });
  const double seeing = seconds([&] {
    for (std::size_t i = 0; i <= step_count; ++i) {
      window->evolution().go_to(i);
      wait_until([&] { return !window->computation().is_busy(); });
    }
  });
  const auto requests = window->computation().requests();
  const std::string what = "100 steps of 2000 points, four layers, " + std::to_string(size.width()) + "x" +
                           std::to_string(size.height()) + ": ";
  const Paint_counter paints(window->canvas());
  const std::string canvas = " [" + window->canvas().backend_name().toStdString() + "]";
  table.row(what + "making a step", making / step_count, "s");
  table.row(what + "its pictures for the first time", seeing / step_count, "s");
  table.row(what + "scrubbing, steps without drawing", steps_per_second(*window, [] {}), "per s", 60, false);
  table.row(what + "scrubbing, steps drawn" + canvas,
            steps_per_second(*window,
                             [&] {
                               const std::size_t before = paints.count();
                               wait_until([&] { return paints.count() > before; });
                             }),
            "per s", 60, false);
  table.row(what + "memory of pictures", static_cast<double>(window->computation().kept_bytes()) / megabyte, "MB",
            static_cast<double>(window->computation().kept_bytes_budget()) / megabyte);
  table.row(what + "computations by scrubbing", static_cast<double>(window->computation().requests() - requests), "",
            0.5);
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("MESECINA_CANVAS", "painter");
  }
  qputenv("MESECINA_NO_PROMPT", "1");
  QLocale::setDefault(QLocale::c());
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
  const QTemporaryDir preferences;
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, preferences.path());
  QApplication application(argc, argv);
  try {
    Table table;
    for (const QSize size : {QSize(1366, 768), QSize(1920, 1080)}) bench_scrubbing(table, size);
    return table.all_met() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
