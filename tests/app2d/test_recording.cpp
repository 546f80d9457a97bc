// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QtTest>
#include <limits>

#include "core/graph.h"
#include "geometries/modules_2.h"
#include "layers/number_field.h"
#include "layers/picture_formats.h"
#include "shell/picture_cache.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

/// Keeps the frames.
class Collecting_film : public Film {
 public:
  explicit Collecting_film(std::vector<Film_frame>& frames) : frames_(frames) {}
  void add(const Film_frame& frame, const std::stop_token&) override { frames_.push_back(frame); }
  std::string finish(const std::stop_token&) override { return {}; }

 private:
  std::vector<Film_frame>& frames_;
};

class Colours_of_films : public testing::Test {
 protected:
  Colours_of_films() {
    auto formats = std::make_shared<Formats>();
    formats->make_film = [this](const Film_request&) { return std::make_unique<Collecting_film>(frames_); };
    recorder_ = std::make_unique<Film_recorder>(formats);
    Film_request request;
    request.file = "film.mp4";
    recorder_->start(request);
  }
  static Film_frame frame(std::vector<double> values, const char* coloured_by = "value") {
    auto set = std::make_shared<Primitive_set>();
    for (std::size_t i = 0; i < values.size(); ++i) {
      set->vertices.push_back({static_cast<double>(i), 0, 0});
      set->points.push_back(static_cast<int>(i));
    }
    set->values.push_back({"value", "", std::move(values)});
    Film_frame result;
    result.scene.layers.push_back({"layer", "Layer", std::move(set), {}, {}});
    result.scene.layers[0].style.visible = true;
    result.scene.layers[0].style.value = coloured_by;
    return result;
  }
  using Range = std::pair<std::optional<double>, std::optional<double>>;
  /// Of each frame that the film has got.
  std::vector<Range> ranges() {
    EXPECT_TRUE(QTest::qWaitFor([&] { return recorder_->queued() == 0; }));
    std::vector<Range> result;
    for (const Film_frame& each : frames_) {
      const Style& style = each.scene.layers[0].style;
      result.emplace_back(style.range_minimum, style.range_maximum);
    }
    return result;
  }
  void finish() {
    recorder_->finish();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !recorder_->is_active(); }));
  }

  std::vector<Film_frame> frames_;
  std::unique_ptr<Film_recorder> recorder_;
};

TEST_F(Colours_of_films, HaveOneRangeInAllFrames) {
  constexpr double never = std::numeric_limits<double>::infinity();
  for (const auto& values : {std::vector<double>{1, 2}, {0, 5, never}, {3, 4}}) recorder_->add(frame(values));
  EXPECT_TRUE(ranges().empty()) << "handed over before the range was known";
  EXPECT_EQ(recorder_->frames(), 3);
  EXPECT_EQ(recorder_->waiting(), 3);
  finish();
  EXPECT_EQ(ranges(), (std::vector<Range>{{0, 5}, {0, 5}, {0, 5}}));
}

TEST_F(Colours_of_films, KeepTheEndThatTheStyleSays) {
  for (const auto& values : {std::vector<double>{1, 2}, {0, 5}}) {
    Film_frame each = frame(values);
    each.scene.layers[0].style.range_minimum = -1;
    recorder_->add(std::move(each));
  }
  finish();
  EXPECT_EQ(ranges(), (std::vector<Range>{{-1, 5}, {-1, 5}}));
}

TEST_F(Colours_of_films, FramesWithoutThemDoNotWait) {
  recorder_->add(frame({1, 2}, ""));
  EXPECT_EQ(ranges(), (std::vector<Range>{{}}));
  Film_frame fixed = frame({1, 2});
  fixed.scene.layers[0].style.range_minimum = 0;
  fixed.scene.layers[0].style.range_maximum = 9;
  recorder_->add(std::move(fixed));
  EXPECT_EQ(ranges(), (std::vector<Range>{{}, {0, 9}}));
  // From the first that has some on, all wait: frames keep their order.
  recorder_->add(frame({1, 2}));
  recorder_->add(frame({7}, ""));
  EXPECT_EQ(ranges().size(), 2u);
  finish();
  EXPECT_EQ(ranges(), (std::vector<Range>{{}, {0, 9}, {1, 2}, {}}));
}

TEST_F(Colours_of_films, GrowWhereThePicturesThatWaitTakeTooMuchMemory) {
  const Film_frame first = frame({1, 2});
  const Film_frame second = frame({0, 2});
  recorder_->set_held_bytes_budget(bytes_of(*first.scene.layers[0].primitives) * 3 / 2);
  recorder_->add(first);
  recorder_->add(first);
  EXPECT_TRUE(ranges().empty()) << "one picture in two frames counts once";
  recorder_->add(second);
  EXPECT_EQ(ranges(), (std::vector<Range>{{0, 2}, {0, 2}, {0, 2}}));
  recorder_->add(frame({1, 8}));
  recorder_->add(frame({1}));
  EXPECT_EQ(ranges(), (std::vector<Range>{{0, 2}, {0, 2}, {0, 2}, {0, 8}, {0, 8}}));
  finish();
  EXPECT_EQ(frames_.size(), 5u);
}

TEST_F(Colours_of_films, OfTheNextFilmBeginAnew) {
  recorder_->add(frame({0, 100}));
  recorder_->cancel();
  EXPECT_EQ(recorder_->waiting(), 0);
  Film_request request;
  request.file = "next.mp4";
  recorder_->start(request);
  recorder_->add(frame({1, 2}));
  finish();
  EXPECT_EQ(ranges(), (std::vector<Range>{{1, 2}}));
}

class Recording : public Window_fixture {
 protected:
  void SetUp() override {
    open_window({{}, {"points", "angle-medial-axis"}, {}});
    ASSERT_TRUE(wait_until([&] { return !window().computation().is_busy(); }));
    panel().set_size({120, 90});
  }
  Window_recording& recording() { return window().recording(); }
  Record_panel& panel() { return recording().panel(); }
  double angle() { return std::get<double>(make_registry()->value(document().settings(), "angle-limit")); }
  static const Registry* make_registry();
  std::vector<Sweep> sweep(int steps) const { return {{"angle-limit", 10, 20, steps, Sweep::Easing::linear, false}}; }
  std::vector<Sweep> two_sweeps() const {
    return {{"angle-limit", 10, 20, 3, Sweep::Easing::linear, false},
            {"lambda-limit", 0, 4, 5, Sweep::Easing::linear, false}};
  }
  double lambda() { return std::get<double>(make_registry()->value(document().settings(), "lambda-limit")); }

  /// What the angle was, one after the other.
  void note_angles() {
    QObject::connect(&document(), &Document::changed, &window(), [this](const Document_change& change) {
      if (change.settings) angles_.push_back(angle());
    });
  }
  void set_file(const char* name) { panel().set_file(folder_.filePath(name)); }
  QStringList files() const {
    return QDir(folder_.path()).entryList(QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
  }
  bool wait_until_done() {
    return wait_until([&] { return !recording().recorder().is_active(); });
  }
  QPushButton* button(const char* name) { return panel().findChild<QPushButton*>(name); }

  std::vector<double> angles_;
};

const Registry* Recording::make_registry() {
  static const std::shared_ptr<const Registry> registry = make_registry_2();
  return registry.get();
}

TEST_F(Recording, AnAnimationShowsEveryStepAndIsOneStepOfUndo) {
  note_angles();
  const int steps_before = document().history().count();
  std::vector<int> shown;
  QObject::connect(&recording().player(), &Frame_player::shown, &window(), [&](int frame) {
    shown.push_back(frame);
    EXPECT_FALSE(window().computation().is_busy());
  });
  panel().set_frames_per_second(200);
  recording().play(sweep(5));
  EXPECT_TRUE(recording().player().is_playing());
  ASSERT_TRUE(wait_until([&] { return !recording().player().is_playing(); }));
  EXPECT_EQ(angles_, (std::vector<double>{10, 12.5, 15, 17.5, 20}));
  EXPECT_EQ(shown, (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(document().history().count(), steps_before + 1);
  EXPECT_TRUE(document().history().undoText().startsWith("Animate"));
  document().history().undo();
  EXPECT_EQ(document().settings().find("angle-limit"), nullptr);
}

TEST_F(Recording, WaitsForWhatIsComputed) {
  // The sampling of an outline is computed anew for each step.
  const QString path = write("square.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  window().files().open({path}, false);
  ASSERT_TRUE(wait_until([&] { return document().inputs().get(outline_input) != nullptr; }));
  window().layer_panel();
  const std::uint64_t requests = window().computation().requests();
  panel().set_frames_per_second(1000);
  int shown = 0;
  QObject::connect(&recording().player(), &Frame_player::shown, &window(), [&] {
    ++shown;
    EXPECT_FALSE(window().computation().is_busy());
  });
  recording().play({{"sampling-step", 0.02, 0.05, 7, Sweep::Easing::linear, false}});
  ASSERT_TRUE(wait_until([&] { return !recording().player().is_playing(); }));
  EXPECT_EQ(shown, 7);
  EXPECT_GE(window().computation().requests(), requests + 7);
}

TEST_F(Recording, UndoingOrEditingEndsAnAnimation) {
  panel().set_frames_per_second(100);
  recording().play(sweep(10000));
  ASSERT_TRUE(wait_until([&] { return recording().player().frame() > 3; }));
  trigger("undo");
  ASSERT_TRUE(wait_until([&] { return !recording().player().is_playing(); }));
  EXPECT_EQ(document().settings().find("angle-limit"), nullptr);
  trigger("play-animation");
  EXPECT_TRUE(recording().player().is_playing());
  trigger("play-animation");
  EXPECT_FALSE(recording().player().is_playing());
}

TEST_F(Recording, EveryNumberHasAButtonThatAsksHowItMoves) {
  auto* animate = window().settings_panel().findChild<QToolButton*>("animate-angle-limit");
  ASSERT_NE(animate, nullptr);
  EXPECT_EQ(window().settings_panel().findChild<QToolButton*>("animate-topology-preserving"), nullptr);
  QTest::mouseClick(animate, Qt::LeftButton);
  Popover* popover = window().popover();
  ASSERT_NE(popover, nullptr);
  const auto ends = popover->findChildren<Number_field*>();
  ASSERT_EQ(ends.size(), 2);
  EXPECT_EQ(ends[0]->value(), 0);
  EXPECT_EQ(ends[1]->value(), 180);
  ends[0]->selectAll();
  QTest::keyClicks(ends[0], "30");
  popover->findChild<QSpinBox*>()->setValue(3);
  EXPECT_TRUE(popover->findChild<QLabel*>("animation-length")->text().startsWith("3 frames"));
  note_angles();
  auto* play = popover->findChild<QPushButton*>("animation-play");
  QTest::mouseClick(play, Qt::LeftButton);
  EXPECT_TRUE(play->text().startsWith("Stop"));
  ASSERT_TRUE(wait_until([&] { return !recording().player().is_playing(); }));
  EXPECT_EQ(angles_, (std::vector<double>{30, 105, 180}));
  EXPECT_EQ(play->text(), "Play");
  QTest::mouseClick(popover->findChild<QPushButton*>("animation-record"), Qt::LeftButton);
  EXPECT_EQ(panel().source(), Record_panel::Source::animation);
  EXPECT_TRUE(panel().isVisible());
  // It knows the numbers when it is opened again.
  popover->dismiss();
  QTest::mouseClick(animate, Qt::LeftButton);
  EXPECT_EQ(window().popover()->findChildren<Number_field*>()[0]->value(), 30);
}

TEST_F(Recording, SeveralNumbersMoveTogether) {
  std::vector<std::pair<double, double>> both;
  QObject::connect(&document(), &Document::changed, &window(), [&](const Document_change& change) {
    if (change.settings) both.emplace_back(angle(), lambda());
  });
  const int steps_before = document().history().count();
  panel().set_frames_per_second(200);
  recording().play(two_sweeps());
  ASSERT_TRUE(wait_until([&] { return !recording().player().is_playing(); }));
  EXPECT_EQ(both, (std::vector<std::pair<double, double>>{{10, 0}, {15, 1}, {20, 2}, {20, 3}, {20, 4}}))
      << "the shorter one waits at its end";
  EXPECT_EQ(document().history().count(), steps_before + 1);
  EXPECT_EQ(document().history().undoText(), "Animate Angle limit, Lambda limit");
  EXPECT_EQ(recording().wish().sweeps, two_sweeps());
  // A session brings them back.
  const Film_wish wish = recording().wish();
  recording().remember(sweep(2));
  EXPECT_EQ(recording().wish().sweeps.size(), 1u);
  recording().show(wish);
  EXPECT_EQ(recording().animation(), two_sweeps());
  set_file("two-%d.png");
  recording().prepare(recording().animation());
  trigger("record-film");
  ASSERT_TRUE(wait_until_done());
  EXPECT_EQ(files().size(), 5);
}

TEST_F(Recording, ANumberMovesAlongWithWhatMovedLast) {
  recording().remember(sweep(3));
  auto* animate = window().settings_panel().findChild<QToolButton*>("animate-lambda-limit");
  ASSERT_NE(animate, nullptr);
  QTest::mouseClick(animate, Qt::LeftButton);
  auto* along = window().popover()->findChild<QCheckBox*>("animation-along");
  ASSERT_NE(along, nullptr);
  EXPECT_EQ(along->text(), "Along with Angle limit");
  EXPECT_FALSE(along->isChecked());
  auto* length = window().popover()->findChild<QLabel*>("animation-length");
  window().popover()->findChild<QSpinBox*>()->setValue(2);
  EXPECT_TRUE(length->text().startsWith("2 frames")) << length->text().toStdString();
  EXPECT_EQ(recording().animation().size(), 1u);
  along->setChecked(true);
  EXPECT_TRUE(length->text().startsWith("3 frames")) << length->text().toStdString();
  ASSERT_EQ(recording().animation().size(), 2u);
  EXPECT_EQ(recording().animation()[0], sweep(3)[0]);
  EXPECT_EQ(recording().animation()[1].setting, "lambda-limit");
  window().popover()->dismiss();
  QTest::mouseClick(animate, Qt::LeftButton);
  along = window().popover()->findChild<QCheckBox*>("animation-along");
  ASSERT_NE(along, nullptr);
  EXPECT_TRUE(along->isChecked()) << "it moved along last time";
  along->setChecked(false);
  EXPECT_EQ(recording().animation().size(), 1u);
  EXPECT_EQ(recording().animation()[0].setting, "lambda-limit");
}

TEST_F(Recording, AnAnimationHasAPictureForEveryStepAsFilesHaveThem) {
  set_file("f-%02d.png");
  recording().prepare(sweep(4));
  View_2 view = canvas().view();
  view.scale *= std::min(120.0 / canvas().width(), 90.0 / canvas().height());
  QTest::mouseClick(button("record-start"), Qt::LeftButton);
  EXPECT_TRUE(recording().recorder().is_active());
  EXPECT_TRUE(recording().indicator()->isVisible());
  ASSERT_TRUE(wait_until_done());
  EXPECT_FALSE(recording().indicator()->isVisible());
  EXPECT_EQ(files(), (QStringList{"f-01.png", "f-02.png", "f-03.png", "f-04.png"}));
  EXPECT_EQ(angle(), 20);
  // What is left in the window is the last of them.
  const QImage expected = paint_picture(window().computation().scene(canvas().scene().background), view, 120, 90);
  EXPECT_EQ(QImage(folder_.filePath("f-04.png")).convertToFormat(QImage::Format_RGB32), expected);
  EXPECT_NE(QImage(folder_.filePath("f-01.png")), QImage(folder_.filePath("f-04.png")));
}

TEST_F(Recording, AnAnimationGoesOnWhileFramesWaitForTheRangeOfColours) {
  Layer_list layers = document().layers();
  for (Layer_entry& entry : layers)
    if (entry.id == "angle-medial-axis") entry.style.value = "angle";
  document().edit_layers(layers, "Colours");
  ASSERT_TRUE(wait_until([&] { return !window().computation().is_busy(); }));
  set_file("w-%02d.png");
  recording().prepare(sweep(12));
  trigger("record-film");
  ASSERT_TRUE(wait_until_done());
  EXPECT_EQ(files().size(), 12);
}

TEST_F(Recording, EveryChangeIsAFrame) {
  set_file("c-%d.png");
  panel().set_source(Record_panel::Source::changes);
  trigger("record-film");
  const auto has_frames = [&](int count) {
    return wait_until([&] { return recording().recorder().frames() == count; });
  };
  ASSERT_TRUE(has_frames(1));
  std::vector<Point_2> moved = points();
  moved[0].x += 5;
  document().edit_inputs(document().inputs().with(points_input, moved), "Move");
  ASSERT_TRUE(has_frames(2));
  canvas().zoom(2);
  ASSERT_TRUE(has_frames(3));
  document().edit_settings(Settings().with("angle-limit", 100.0), "Angle");
  ASSERT_TRUE(has_frames(4));
  trigger("undo");
  ASSERT_TRUE(has_frames(5));
  // What changes no picture is no frame.
  document().edit_settings(Settings().with("lambda-limit", 0.5), "Lambda");
  ASSERT_TRUE(wait_until([&] { return !window().computation().is_busy(); }));
  QTest::qWait(50);
  EXPECT_EQ(recording().recorder().frames(), 5);
  trigger("record-film");
  ASSERT_TRUE(wait_until_done());
  EXPECT_EQ(files(), (QStringList{"c-1.png", "c-2.png", "c-3.png", "c-4.png", "c-5.png"}));
  EXPECT_EQ(QImage(folder_.filePath("c-3.png")), QImage(folder_.filePath("c-5.png")));
  EXPECT_NE(QImage(folder_.filePath("c-1.png")), QImage(folder_.filePath("c-2.png")));
  EXPECT_NE(QImage(folder_.filePath("c-2.png")), QImage(folder_.filePath("c-3.png")));
}

TEST_F(Recording, ADragIsRecordedWhileItGoesOn) {
  set_file("d-%d.png");
  panel().set_source(Record_panel::Source::changes);
  trigger("record-film");
  ASSERT_TRUE(wait_until([&] { return recording().recorder().frames() == 1; }));
  std::vector<Point_2> moved = points();
  for (int i = 1; i <= 5; ++i) {
    moved[0].x += 5;
    document().edit_inputs(document().inputs().with(points_input, moved), "Move", "drag");
    ASSERT_TRUE(wait_until([&] { return recording().recorder().frames() == 1 + i; }));
  }
  recording().stop();
  ASSERT_TRUE(wait_until_done());
  EXPECT_EQ(files().size(), 6);
}

TEST_F(Recording, StepsOfAnEvolutionAreFrames) {
  const Evolution_spec* smoothing = make_registry()->find_evolution("laplacian-smoothing");
  ASSERT_NE(smoothing, nullptr);
  Graph graph(make_registry_2());
  Progress progress;
  for (std::uint64_t step = 1; step <= 3; ++step) {
    const Evolution_state before{document().inputs(), document().settings()};
    graph.set_inputs(before.inputs);
    graph.set_settings(before.settings);
    const auto after = graph.evolve("laplacian-smoothing", step, progress);
    ASSERT_TRUE(after.value) << after.reason;
    document().add_step(*smoothing, document().position(), before, *after.value, true);
  }
  ASSERT_EQ(document().step_count(), 3);
  set_file("e-%d.png");
  panel().set_source(Record_panel::Source::evolution);
  ASSERT_TRUE(button("record-start")->isEnabled());
  trigger("record-film");
  ASSERT_TRUE(wait_until_done());
  EXPECT_EQ(files(), (QStringList{"e-1.png", "e-2.png", "e-3.png", "e-4.png"}));
  EXPECT_NE(QImage(folder_.filePath("e-1.png")), QImage(folder_.filePath("e-4.png")));
  EXPECT_EQ(document().position(), 3);
}

TEST_F(Recording, CancellingLeavesNothing) {
  for (const char* name : {"film.mp4", "film.gif", "f-%d.png"}) {
    set_file(name);
    recording().prepare(sweep(100000));
    trigger("record-film");
    ASSERT_TRUE(wait_until([&] { return recording().recorder().frames() > 3; }));
    EXPECT_EQ(files().size(), 1) << "expected the hidden folder of a film";
    QTest::mouseClick(button("record-cancel"), Qt::LeftButton);
    EXPECT_FALSE(recording().recorder().is_active());
    EXPECT_FALSE(recording().player().is_playing());
    EXPECT_TRUE(wait_until([&] { return files().isEmpty(); })) << name;
  }
}

TEST_F(Recording, StoppingKeepsWhatThereIs) {
  set_file("s-%d.png");
  recording().prepare(sweep(100000));
  trigger("record-film");
  ASSERT_TRUE(wait_until([&] { return recording().recorder().frames() > 3; }));
  trigger("record-film");
  ASSERT_TRUE(wait_until_done());
  EXPECT_GE(files().size(), 3);
  EXPECT_LT(files().size(), 1000);
}

TEST_F(Recording, WhatCannotBeMadeIsTold) {
  set_file("film.avi");
  recording().prepare(sweep(3));
  trigger("record-film");
  EXPECT_FALSE(recording().recorder().is_active());
  EXPECT_TRUE(window().messages().lines().last().contains(".mp4, .webm or .gif"));
  panel().set_file(folder_.filePath("nowhere/film.mp4"));
  trigger("record-film");
  ASSERT_TRUE(wait_until_done());
  EXPECT_TRUE(window().messages().lines().last().contains("film.mp4"));
  EXPECT_FALSE(recording().player().is_playing());
  EXPECT_TRUE(files().isEmpty());
}

TEST_F(Recording, AWindowThatGoesTakesItsFilmAlong) {
  set_file("film.mp4");
  recording().prepare(sweep(100000));
  trigger("record-film");
  ASSERT_TRUE(wait_until([&] { return recording().recorder().frames() > 3; }));
  window_.reset();
  EXPECT_TRUE(files().isEmpty());
}

TEST_F(Recording, PicturesGoToTheClipboard) {
  const QSize seen = (QSizeF(canvas().size()) * canvas().devicePixelRatioF()).toSize();
  QApplication::clipboard()->clear();
  trigger("copy-picture");
  ASSERT_TRUE(wait_until([] { return !QApplication::clipboard()->image().isNull(); }));
  EXPECT_EQ(QApplication::clipboard()->image().size(), seen);
  // In the size of the export, from then on.
  QApplication::clipboard()->clear();
  trigger("export-picture");
  const auto sizes = window().popover()->findChildren<QSpinBox*>();
  sizes[0]->setValue(321);
  sizes[1]->setValue(123);
  for (QPushButton* button : window().popover()->findChildren<QPushButton*>())
    if (button->text() == "Copy") button->click();
  ASSERT_TRUE(wait_until([] { return QApplication::clipboard()->image().size() == QSize(321, 123); }));
  QApplication::clipboard()->clear();
  trigger("copy-picture");
  ASSERT_TRUE(wait_until([] { return QApplication::clipboard()->image().size() == QSize(321, 123); }));
}

}  // namespace
}  // namespace mesecina
