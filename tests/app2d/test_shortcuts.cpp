// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QtTest>

#include "window_fixture.h"

namespace mesecina {
namespace {

class Shortcuts : public Window_fixture {
 protected:
  void TearDown() override {
    window().actions().reset_all_keys();
    Window_fixture::TearDown();
  }
  Shortcut_editor& editor() {
    if (!window().shortcut_editor()) trigger("shortcuts");
    return *window().shortcut_editor();
  }
  QList<QKeySequence> keys(const char* id) { return window().actions()[QLatin1String(id)]->shortcuts(); }
};

TEST_F(Shortcuts, OwnKeysActAtOnceAndInTheNextWindow) {
  editor().choose("tool-disk");
  editor().assign(QKeySequence("F23"));
  EXPECT_EQ(editor().question(), "");
  EXPECT_EQ(keys("tool-disk"), QList<QKeySequence>{QKeySequence("F23")});
  EXPECT_TRUE(window().actions()["tool-disk"]->toolTip().contains("(F23)"));
  canvas().setFocus();
  window().activateWindow();
  press(Qt::Key_F23);
  EXPECT_TRUE(window().actions()["tool-disk"]->isChecked());
  open_window();
  EXPECT_EQ(keys("tool-disk"), QList<QKeySequence>{QKeySequence("F23")});
  EXPECT_TRUE(window().actions().faults().isEmpty());
  window().actions().reset_keys("tool-disk");
  EXPECT_EQ(keys("tool-disk"), QList<QKeySequence>{QKeySequence("D")});
  open_window();
  EXPECT_EQ(keys("tool-disk"), QList<QKeySequence>{QKeySequence("D")});
}

TEST_F(Shortcuts, KeysOfAnotherActionAreTakenOverOnlyWhenTheUserSaysSo) {
  editor().choose("tool-disk");
  editor().assign(QKeySequence("F"));
  EXPECT_TRUE(editor().question().contains("Fit")) << editor().question().toStdString();
  EXPECT_EQ(keys("tool-disk"), QList<QKeySequence>{QKeySequence("D")});
  editor().dismiss_question();
  EXPECT_EQ(editor().question(), "");
  EXPECT_EQ(keys("fit").size(), 2);
  editor().assign(QKeySequence("F"));
  editor().take_over();
  EXPECT_EQ(keys("tool-disk"), QList<QKeySequence>{QKeySequence("F")});
  EXPECT_EQ(keys("fit"), QList<QKeySequence>{QKeySequence("0")});
  EXPECT_TRUE(window().actions().faults().isEmpty()) << window().actions().faults().join('\n').toStdString();
  // A sequence that begins with the keys of another would never be reached.
  editor().choose("undo");
  editor().assign(QKeySequence("F, U"));
  EXPECT_NE(editor().question(), "");
}

TEST_F(Shortcuts, SearchByNameAndByKey) {
  editor().filter("zoom");
  EXPECT_TRUE(editor().listed().contains("zoom-in"));
  EXPECT_FALSE(editor().listed().contains("tool-disk"));
  editor().filter({}, QKeySequence("Ctrl+Z"));
  EXPECT_EQ(editor().listed(), QStringList{"undo"});
  editor().filter({});
  EXPECT_EQ(editor().listed().size(), static_cast<qsizetype>(window().actions().entries().size()));
}

TEST_F(Shortcuts, TheSheetOfKeysShowsTheActualOnes) {
  window().actions().set_keys("tool-disk", {QKeySequence("Ctrl+Alt+9")});
  trigger("keys");
  const auto sheets = window().findChildren<QDialog*>();
  QString text;
  for (const QDialog* sheet : sheets)
    for (const QLabel* label : sheet->findChildren<QLabel*>()) text += label->text();
  EXPECT_TRUE(text.contains("Ctrl+Alt+9"));
}

TEST_F(Shortcuts, TheSheetOfKeysIsNoWiderThanTheWindow) {
  window().resize(1000, 700);
  trigger("keys");
  int seen = 0;
  for (const QDialog* sheet : window().findChildren<QDialog*>())
    for (const QScrollArea* area : sheet->findChildren<QScrollArea*>()) {
      ++seen;
      EXPECT_LE(area->widget()->sizeHint().width(), window().width());
    }
  EXPECT_EQ(seen, 1);
}

TEST_F(Shortcuts, WithoutKeysAndBack) {
  editor().choose("save");
  for (QPushButton* button : editor().findChildren<QPushButton*>())
    if (button->text() == "No &keys") button->click();
  EXPECT_TRUE(keys("save").isEmpty());
  EXPECT_TRUE(window().actions().has_own_keys("save"));
  window().actions().reset_all_keys();
  EXPECT_EQ(keys("save"), QList<QKeySequence>{QKeySequence("Ctrl+S")});
  EXPECT_FALSE(window().actions().has_own_keys("save"));
}

}  // namespace
}  // namespace mesecina
