// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QLineEdit>
#include <QtTest>
#include <algorithm>

#include "shell/fuzzy.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

TEST(Fuzzy_score, FindsWordsInAnyOrderAndBeginnings) {
  EXPECT_GT(fuzzy_score("axis med", "Medial axis"), 0);
  EXPECT_GT(fuzzy_score("ma", "Medial axis"), 0);
  EXPECT_GT(fuzzy_score("MEDIAL", "medial axis"), 0);
  EXPECT_GT(fuzzy_score("poincare", "Poincaré"), 0);
  EXPECT_EQ(fuzzy_score("mxz", "Medial axis"), 0);
  EXPECT_EQ(fuzzy_score("axis disk", "Medial axis"), 0);
  EXPECT_GT(fuzzy_score("fit", "Fit"), fuzzy_score("fit", "Profit"));
  EXPECT_GT(fuzzy_score("", "anything"), 0);
  EXPECT_GT(fuzzy_score("fit", "Fit", "fit", ""), fuzzy_score("fit", "Zoom in", "zoom-in", "Make it fit"));
  EXPECT_GT(fuzzy_score("disks", "Disks", "a", ""), fuzzy_score("disks", "Disks of the scale axis", "b", ""));
}

class Palette : public Window_fixture {
 protected:
  Command_palette& palette() {
    if (!window().command_palette()) trigger("palette");
    return *window().command_palette();
  }
  void type(const QString& text) { QTest::keyClicks(line(), text); }
  QLineEdit* line() { return palette().findChild<QLineEdit*>(); }
  void key(Qt::Key key) { QTest::keyClick(line(), key); }
  QString first() { return palette().items().empty() ? QString() : palette().items().front().key; }
};

TEST_F(Palette, FindsActionsLayersAndSettingsByAFewLetters) {
  palette();
  EXPECT_EQ(QApplication::focusWidget(), line());
  const auto all = palette().items().size();
  EXPECT_GT(all, window().actions().entries().size());
  palette().set_query("zoom in");
  EXPECT_EQ(first(), "action/zoom-in");
  palette().set_query("voronoi");
  EXPECT_TRUE(first().startsWith("layer/")) << first().toStdString();
  palette().set_query("xyzzy");
  EXPECT_TRUE(palette().items().empty());
  key(Qt::Key_Return);
  EXPECT_NE(window().command_palette(), nullptr);
  key(Qt::Key_Escape);
  EXPECT_FALSE(window().findChild<QWidget*>("command-palette")->isVisible());
  EXPECT_EQ(document().history().count(), 0);
}

TEST_F(Palette, WhatARowDoesEndsWithDotsWhereItDoesNotFit) {
  palette();
  const auto shown = [this](const Palette_item& item) {
    for (const QLabel* label : palette().findChildren<QLabel*>())
      if (label->toolTip() == item.detail) return label->text();
    return QString();
  };
  int cut = 0;
  for (const auto& layer : document().layers()) {
    palette().set_query(QString::fromStdString(layer.id));
    if (palette().items().empty()) continue;
    const Palette_item& item = palette().items().front();
    const QString text = shown(item);
    if (text == item.detail) continue;
    ++cut;
    ASSERT_TRUE(text.endsWith(QChar(0x2026))) << text.toStdString();
    EXPECT_TRUE(item.detail.startsWith(text.chopped(1) + QLatin1Char(' '))) << text.toStdString();
    EXPECT_GT(text.size(), 100);
  }
  EXPECT_GT(cut, 0);
}

TEST_F(Palette, EnterShowsALayerAndTheNextTimeItComesFirst) {
  palette().set_query("delaunay triangulation");
  ASSERT_EQ(first(), "layer/delaunay");
  EXPECT_EQ(palette().items().front().is_on, false);
  key(Qt::Key_Return);
  EXPECT_TRUE(find_entry(document().layers(), "delaunay")->style.visible);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_EQ(window().command_palette(), nullptr);
  EXPECT_EQ(QApplication::focusWidget(), &canvas());
  palette();
  EXPECT_EQ(first(), "layer/delaunay");
  EXPECT_EQ(palette().items().front().is_on, true);
}

TEST_F(Palette, SetsSettingsByNameAndValue) {
  for (const char* query : {"scale 1.3", "scale=1.3"}) {
    document().edit_settings({}, "Reset");
    palette().set_query(query);
    EXPECT_EQ(first(), "setting/scale");
    key(Qt::Key_Return);
    ASSERT_NE(document().settings().find("scale"), nullptr) << query;
    EXPECT_EQ(std::get<double>(*document().settings().find("scale")), 1.3);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  palette().set_query("scale 0");
  EXPECT_EQ(first(), "setting/scale");
  EXPECT_FALSE(palette().items().front().is_possible);
  EXPECT_TRUE(palette().items().front().detail.contains("expected"));
  key(Qt::Key_Return);
  EXPECT_EQ(std::get<double>(*document().settings().find("scale")), 1.3);
}

TEST_F(Palette, ASettingWithoutValueIsFocusedInThePanel) {
  palette().set_query("scale");
  const auto& items = palette().items();
  const auto it = std::ranges::find(items, QStringLiteral("setting/scale"), &Palette_item::key);
  ASSERT_NE(it, items.end());
  for (auto i = items.begin(); i != it; ++i) key(Qt::Key_Down);
  EXPECT_EQ(palette().current(), it - items.begin());
  key(Qt::Key_Return);
  ASSERT_NE(QApplication::focusWidget(), nullptr);
  EXPECT_TRUE(window().settings_panel().isAncestorOf(QApplication::focusWidget()));
  EXPECT_EQ(document().history().count(), 0);
}

TEST_F(Palette, WhatIsNotPossibleIsGreyAndDoesNothing) {
  palette().set_query("redo");
  ASSERT_EQ(first(), "action/redo");
  EXPECT_FALSE(palette().items().front().is_possible);
  EXPECT_FALSE(palette().items().front().keys.isEmpty());
  key(Qt::Key_Return);
  EXPECT_NE(window().command_palette(), nullptr);
}

TEST_F(Palette, TakesCommandsWithArguments) {
  palette().set_query("add a point");
  ASSERT_EQ(first(), "command/add-point");
  key(Qt::Key_Return);
  EXPECT_EQ(palette().query(), "add-point ");
  type("3 4");
  const auto before = points().size();
  key(Qt::Key_Return);
  EXPECT_EQ(points().size(), before + 1);
  EXPECT_EQ(points().back(), (Point_2{3, 4}));
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  palette().set_query("add-point x");
  key(Qt::Key_Return);
  EXPECT_TRUE(window().messages().lines().last().startsWith("add-point: expected X Y"));
}

TEST_F(Palette, KeysOfTheWindowDoNothingWhileItIsOpen) {
  palette();
  type("p");
  key(Qt::Key_Delete);
  EXPECT_EQ(palette().query(), "p");
  EXPECT_TRUE(window().actions()["tool-select"]->isChecked());
}

}  // namespace
}  // namespace mesecina
