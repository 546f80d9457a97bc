// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QClipboard>
#include <QHeaderView>
#include <string>

#include "app3d/clipboard_3.h"
#include "core/point.h"
#include "tests/app3d/window_fixture_3.h"

namespace mesecina {
namespace {

TEST(Clipboard_3, RowsReadBackExactlyAndEachKindApart) {
  const std::string both = to_rows({{1, -2.5, 1e-300}}, {{{0.1, 2, 3}, 1.0 / 3}});
  EXPECT_EQ(both, "1\t-2.5\t1e-300\n0.1\t2\t3\t0.3333333333333333\n");
  EXPECT_EQ(parts_of_rows(both), (std::vector<std::string>{"1\t-2.5\t1e-300\n", "\n0.1\t2\t3\t0.3333333333333333\n"}));
  EXPECT_EQ(parts_of_rows("x y z\r\n1 2 3\r\n\r\n4 5 6"), std::vector<std::string>{"x y z\n1 2 3\n\n4 5 6\n"});
  EXPECT_EQ(parts_of_rows("1 2 3\nx,y,z,r\n1,2,3,4\n5,6,7,8"),
            (std::vector<std::string>{"1 2 3\n", "\nx,y,z,r\n1,2,3,4\n5,6,7,8\n"}));
  // What fits no kind stays where the reader can say so.
  EXPECT_EQ(parts_of_rows("1 2 3\n1 2\n"), std::vector<std::string>{"1 2 3\n1 2\n"});
}

class Input_table_window_3 : public Window_3 {
 protected:
  void SetUp() override {
    open({{write("two.woff", "WOFF 2 0 0\n-1 0 0 0.5\n1 0 0 0.75\n")}, {"given-balls", "points"}, {}});
    ASSERT_TRUE(wait_until([&] { return balls().size() == 2 && !window_->computation().is_busy(); }));
  }
  Editor_3& editor() { return window_->editor(); }
  QUndoStack& history() { return window_->document().history(); }
  std::vector<Ball_3> balls() {
    const auto all = window_->document().inputs().get(balls_input);
    return all ? *all : std::vector<Ball_3>();
  }
  std::vector<Point_3> points() {
    const auto all = window_->document().inputs().get(cloud_input);
    return all ? *all : std::vector<Point_3>();
  }
  void use(const char* action) { window_->actions()[QLatin1String(action)]->trigger(); }
  void show(QWidget& table) {
    for (QWidget* widget = &table; widget; widget = widget->parentWidget()) widget->show();
    table.parentWidget()->raise();
    ASSERT_TRUE(wait_until([&] { return table.isVisible(); }));
  }
};

TEST_F(Input_table_window_3, TypingChangesBallsAndSelectionsAreOne) {
  Input_table_3& table = window_->balls_table();
  show(table);
  QAbstractItemModel& model = *table.model();
  ASSERT_EQ(model.rowCount(), 2);
  ASSERT_EQ(model.columnCount(), 4);
  EXPECT_EQ(model.index(1, 3).data().toString(), "0.75");
  EXPECT_EQ(model.headerData(3, Qt::Horizontal).toString(), "radius");

  EXPECT_TRUE(model.setData(model.index(1, 3), "0.1"));
  EXPECT_TRUE(model.setData(model.index(0, 2), "-7e3"));
  EXPECT_EQ(balls(), (std::vector<Ball_3>{{{-1, 0, -7000}, 0.5}, {{1, 0, 0}, 0.1}}));
  EXPECT_EQ(history().count(), 2);
  EXPECT_EQ(model.index(0, 2).data().toString(), "-7000");
  for (const char* bad : {"-0.1", "1,5", "nan", "inf", "", "one"})
    EXPECT_FALSE(model.setData(model.index(1, 3), bad)) << bad;
  EXPECT_TRUE(window_->messages().lines().join("").contains("Ball 1: expected a radius of at least 0, found \"one\"."))
      << window_->messages().lines().join("\n").toStdString();

  table.selectRow(1);
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {1}}));
  editor().select({{}, {0, 1}});
  EXPECT_EQ(table.selectionModel()->selectedRows().size(), 2);
  use("delete");
  EXPECT_EQ(model.rowCount(), 0);
  use("undo");
  EXPECT_EQ(model.rowCount(), 2);
  EXPECT_EQ(table.selectionModel()->selectedRows().size(), 2);
}

TEST_F(Input_table_window_3, LongNumbersAreShownWithTheDigitsThereIsRoomFor) {
  Input_table_3& table = window_->balls_table();
  show(table);
  ASSERT_TRUE(table.model()->setData(table.model()->index(0, 1), "0.123456789012345"));
  const QModelIndex index = table.model()->index(0, 1);
  EXPECT_EQ(index.data().toString(), "0.123456789012345");
  const auto picture = [&](int width) {
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table.setColumnWidth(1, width);
    QApplication::processEvents();
    return table.viewport()->grab(table.visualRect(index)).toImage();
  };
  // As the picture of the rounded number itself, without dots.
  const int width = QFontMetrics(table.font()).horizontalAdvance(QStringLiteral("0.1235")) + 12;
  const QImage rounded = picture(width);
  ASSERT_TRUE(table.model()->setData(index, "0.12346"));
  const QImage same = picture(width);
  EXPECT_EQ(rounded, same);
  ASSERT_TRUE(table.model()->setData(index, "0.52346"));
  EXPECT_NE(picture(width), same);
}

TEST_F(Input_table_window_3, RowsGoThroughTheClipboard) {
  const std::vector<Ball_3> start = balls();
  use("select-all");
  use("copy");
  EXPECT_EQ(QApplication::clipboard()->text(), "-1\t0\t0\t0.5\n1\t0\t0\t0.75\n");
  use("cut");
  EXPECT_TRUE(balls().empty());
  use("paste");
  EXPECT_EQ(balls(), start);
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {0, 1}}));
  EXPECT_EQ(history().undoText(), "Paste 2 balls");
  use("undo");
  use("undo");
  EXPECT_EQ(balls(), start);

  // As spreadsheets and people write them: both kinds, names, commas.
  QApplication::clipboard()->setText("x\ty\tz\n1.5\t2\t3\n\n4, 5, 6, 0.5\r\n7 8 9 1e-2\n");
  use("paste");
  EXPECT_EQ(points(), std::vector<Point_3>({{1.5, 2, 3}}));
  ASSERT_EQ(balls().size(), 4U);
  EXPECT_EQ(balls()[3], (Ball_3{{7, 8, 9}, 0.01}));
  EXPECT_EQ(editor().selection(), (Selection_3{{0}, {2, 3}}));
  use("duplicate");
  EXPECT_EQ(balls().size(), 6U);
  EXPECT_EQ(points().size(), 2U);

  Input_table_3& table = window_->points_table();
  show(table);
  EXPECT_EQ(table.model()->rowCount(), 2);
  EXPECT_EQ(table.model()->columnCount(), 3);
  EXPECT_EQ(table.model()->index(0, 0).data().toString(), "1.5");

  // A bad line adds nothing and is named.
  const int steps = history().count();
  for (const char* bad : {"1 2 3\nhello world there\n", "1 2 3 4\n1 2 3 -4\n", "1 2\n", "   \n"}) {
    QApplication::clipboard()->setText(bad);
    use("paste");
    EXPECT_EQ(history().count(), steps) << bad;
  }
  EXPECT_TRUE(window_->messages().lines().join("\n").contains("clipboard.txt:2"))
      << window_->messages().lines().join("\n").toStdString();
  editor().select({});
  QApplication::clipboard()->setText("kept");
  use("copy");
  EXPECT_EQ(QApplication::clipboard()->text(), "kept") << "nothing is selected";
}

TEST_F(Input_table_window_3, ManyRowsCostNoMoreThanTheirNumbers) {
  std::vector<Ball_3> many(140000);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = {{static_cast<double>(i), 0, 0}, 0.25};
  window_->document().edit_layers({}, "Show nothing");
  Input_table_3& table = window_->balls_table();
  show(table);
  window_->document().edit_inputs(Inputs().with(balls_input, many), "Many");
  ASSERT_EQ(table.model()->rowCount(), 140000);
  use("select-all");
  EXPECT_EQ(table.selectionModel()->selection().size(), 1) << "one run of rows";
  table.scrollToBottom();
  EXPECT_EQ(table.rowAt(table.viewport()->height() - 2), 139999);
  EXPECT_TRUE(table.model()->setData(table.model()->index(139999, 0), "0.5"));
  EXPECT_EQ(balls().back().center.x, 0.5);
}

}  // namespace
}  // namespace mesecina
