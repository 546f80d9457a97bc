// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QImage>
#include <QSpinBox>
#include <QtTest>

#include "window_fixture_3.h"

namespace mesecina {
namespace {

class Recording_3 : public Window_3 {
 protected:
  void SetUp() override {
    open({{write("two.cin", "0 0 0 1\n1 0.4 0.3 0.5\n")}, {"given-balls"}, {}});
    ASSERT_TRUE(wait_until_idle());
    ASSERT_TRUE(wait_until([&] { return window_->computation().primitives("given-balls") != nullptr; }));
    panel().set_size({120, 90});
  }
  Window_recording& recording() { return window_->recording(); }
  Record_panel& panel() { return recording().panel(); }
  QStringList films() const {
    return QDir(folder_.path())
        .entryList({"*.png", "*.mp4", ".*"}, QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot);
  }
  QImage picture(const char* name) const { return QImage(folder_.filePath(name)); }
};

TEST_F(Recording_3, ATurntableGoesRoundOnceAndLeavesTheViewAlone) {
  const View_3 before = viewer().view();
  panel().set_source(Record_panel::Source::turntable);
  ASSERT_EQ(panel().source(), Record_panel::Source::turntable);
  panel().findChildren<QSpinBox*>().front()->setValue(4);
  panel().set_file(folder_.filePath("t-%d.png"));
  ASSERT_EQ(panel().turntable_frames(), 4);
  window_->actions()["record-film"]->trigger();
  ASSERT_TRUE(wait_until([&] { return !recording().recorder().is_active(); }));
  EXPECT_EQ(films(), (QStringList{"t-1.png", "t-2.png", "t-3.png", "t-4.png"}));
  EXPECT_EQ(viewer().view(), before);
  EXPECT_EQ(picture("t-1.png").size(), QSize(120, 90));
  EXPECT_NE(picture("t-1.png"), picture("t-2.png"));
  EXPECT_NE(picture("t-1.png"), picture("t-3.png"));
  EXPECT_NE(picture("t-1.png"), picture("t-4.png"));
}

TEST_F(Recording_3, TheCameraIsRecorded) {
  panel().set_source(Record_panel::Source::changes);
  panel().set_file(folder_.filePath("c-%d.png"));
  window_->actions()["record-film"]->trigger();
  ASSERT_TRUE(wait_until([&] { return recording().recorder().frames() == 1; }));
  drag(Qt::LeftButton, {300, 300}, {360, 300});
  ASSERT_TRUE(wait_until([&] { return recording().recorder().frames() > 1; }));
  const int frames = recording().recorder().frames();
  QTest::qWait(50);
  window_->actions()["record-film"]->trigger();
  ASSERT_TRUE(wait_until([&] { return !recording().recorder().is_active(); }));
  EXPECT_GE(films().size(), frames);
  EXPECT_NE(picture("c-1.png"), picture("c-2.png"));
}

TEST_F(Recording_3, CancellingLeavesNothing) {
  panel().set_source(Record_panel::Source::turntable);
  panel().findChildren<QSpinBox*>().front()->setValue(5000);
  panel().set_file(folder_.filePath("t.mp4"));
  window_->actions()["record-film"]->trigger();
  ASSERT_TRUE(wait_until([&] { return films().size() == 1; }));
  window_->actions()["cancel-film"]->trigger();
  EXPECT_TRUE(wait_until([&] { return films().isEmpty(); }));
}

TEST_F(Recording_3, PicturesGoToTheClipboard) {
  QApplication::clipboard()->clear();
  window_->actions()["copy-picture"]->trigger();
  ASSERT_TRUE(wait_until([] { return !QApplication::clipboard()->image().isNull(); }));
  EXPECT_EQ(QApplication::clipboard()->image().size(),
            (QSizeF(viewer().size()) * viewer().devicePixelRatioF()).toSize());
}

}  // namespace
}  // namespace mesecina
