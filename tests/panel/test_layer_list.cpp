// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "layers/layer_model.h"
#include "layers/layer_visibility.h"
#include "tests/panel/panel_fixture.h"

namespace mesecina {
namespace {

using Part = Layer_delegate::Part;

class Layer_rows : public Panel_test {
 protected:
  /// Drops dragged layers as the view does.
  bool drop(const QStringList& layers, int position, const QModelIndex& parent) {
    QModelIndexList rows;
    for (const QString& layer : layers) rows << row(layer);
    const std::unique_ptr<QMimeData> data(tree().model()->mimeData(rows));
    return tree().model()->canDropMimeData(data.get(), Qt::MoveAction, position, 0, parent) &&
           tree().model()->dropMimeData(data.get(), Qt::MoveAction, position, 0, parent);
  }
  void choose_from_menu(const QModelIndex& index, const QString& text) {
    Q_EMIT tree().customContextMenuRequested(part(index, Part::label));
    auto* menu = panel_.findChild<QMenu*>();
    ASSERT_NE(menu, nullptr);
    for (QAction* action : menu->actions()) {
      if (action->text() == text && action->isEnabled()) action->trigger();
    }
    menu->close();
    delete menu;
  }
};

TEST_F(Layer_rows, click_on_eye_asks_for_visibility_and_leaves_selection) {
  click(row("b"), Part::eye);
  ASSERT_EQ(edits_.size(), 1u);
  EXPECT_TRUE(find_entry(edits_[0].layers, "b")->style.visible);
  EXPECT_EQ(edits_[0].what, "Show Layer b");
  EXPECT_EQ(visible(), "abd");
  EXPECT_TRUE(panel_.selected().isEmpty());
  click(row("a"), Part::eye);
  EXPECT_EQ(edits_[1].what, "Hide Layer a");
  EXPECT_EQ(visible(), "bd");
  EXPECT_NE(edits_[0].merge, edits_[1].merge);
}

TEST_F(Layer_rows, panel_shows_what_it_was_given_only) {
  Layer_panel alone(registry_);
  alone.set_layers(default_layers(*registry_));
  alone.select({"b"});
  QSignalSpy spy(&alone, &Layer_panel::layers_edited);
  alone.toggle_visibility();
  EXPECT_EQ(spy.count(), 1);
  EXPECT_FALSE(find_entry(alone.layers(), "b")->style.visible);
}

TEST_F(Layer_rows, eye_of_a_selected_row_is_that_of_all_selected) {
  panel_.select({"b", "c"});
  click(row("c"), Part::eye);
  EXPECT_EQ(visible(), "abcd");
  EXPECT_EQ(edits_.back().what, "Show 2 layers");
  EXPECT_EQ(panel_.selected(), (QStringList{"c", "b"}));
}

TEST_F(Layer_rows, pressed_mouse_sweeps_over_eyes_as_one_change) {
  QTest::mousePress(tree().viewport(), Qt::LeftButton, {}, part(row("c"), Part::eye));
  QTest::mouseMove(tree().viewport(), part(row("b"), Part::eye));
  QTest::mouseMove(tree().viewport(), part(row("a"), Part::eye));
  QTest::mouseRelease(tree().viewport(), Qt::LeftButton, {}, part(row("a"), Part::eye));
  EXPECT_EQ(visible(), "abcd");
  ASSERT_EQ(edits_.size(), 2u);
  EXPECT_FALSE(edits_[0].merge.isEmpty());
  EXPECT_EQ(edits_[0].merge, edits_[1].merge);
}

TEST_F(Layer_rows, solo_and_back_restores) {
  click(row("b"), Part::eye, Qt::AltModifier);
  EXPECT_EQ(visible(), "b");
  click(row("c"), Part::eye, Qt::AltModifier);
  EXPECT_EQ(visible(), "c");
  click(row("c"), Part::eye, Qt::AltModifier);
  EXPECT_EQ(visible(), "ad");

  panel_.select({"b", "e"});
  panel_.solo();
  EXPECT_EQ(visible(), "be");
  panel_.solo();
  EXPECT_EQ(visible(), "ad");
}

TEST_F(Layer_rows, solo_after_other_changes_remembers_those) {
  panel_.select({"b"});
  panel_.solo();
  panel_.show_all();
  panel_.solo();
  EXPECT_EQ(visible(), "b");
  panel_.solo();
  EXPECT_EQ(visible(), "abcde");
}

TEST_F(Layer_rows, eye_of_a_stage_hides_and_brings_back) {
  ASSERT_EQ(stage(1).data().toString(), "First");
  EXPECT_EQ(stage(1).data(Qt::CheckStateRole).toInt(), Qt::PartiallyChecked);
  click(stage(1), Part::eye);
  EXPECT_EQ(visible(), "d");
  EXPECT_EQ(stage(1).data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
  click(stage(1), Part::eye);
  EXPECT_EQ(visible(), "ad");
}

TEST_F(Layer_rows, stage_never_seen_is_shown_whole) {
  panel_.set_layers(Layer_list{{"a", {}}, {"b", {}}, {"d", {}}});
  click(stage(1), Part::eye);
  EXPECT_EQ(visible(), "ab");
  EXPECT_EQ(stage(1).data(Qt::CheckStateRole).toInt(), Qt::Checked);
}

TEST_F(Layer_rows, keys_toggle_and_open_style) {
  panel_.select({"b", "c"});
  QTest::keyClick(&tree(), Qt::Key_Space);
  EXPECT_EQ(visible(), "abcd");
  QTest::keyClick(&tree(), Qt::Key_Space);
  EXPECT_EQ(visible(), "ad");
  QSignalSpy spy(&tree(), &Layer_tree::style_requested);
  QTest::keyClick(&tree(), Qt::Key_Return);
  EXPECT_EQ(spy.count(), 1);
}

TEST_F(Layer_rows, click_on_a_stage_collapses_it_and_keeps_the_selection) {
  panel_.select({"b"});
  click(stage(0), Part::label);
  EXPECT_FALSE(tree().isExpanded(stage(0)));
  EXPECT_EQ(panel_.selected(), QStringList{"b"});
  panel_.show_all();
  EXPECT_FALSE(tree().isExpanded(stage(0)));
  click(stage(0), Part::arrow);
  EXPECT_TRUE(tree().isExpanded(stage(0)));
}

TEST_F(Layer_rows, stages_without_a_visible_layer_start_closed) {
  EXPECT_TRUE(tree().isExpanded(stage(0)));
  EXPECT_TRUE(tree().isExpanded(stage(1)));
  Layer_panel other(registry_);
  auto& rows = *other.findChild<Layer_tree*>();
  Layer_list layers = with_only_visible(default_layers(*registry_), {"a"});
  other.set_layers(layers);
  EXPECT_FALSE(rows.isExpanded(rows.model()->index(0, 0)));
  EXPECT_TRUE(rows.isExpanded(rows.model()->index(1, 0)));
  // Later lists leave stages as the user has them.
  rows.setExpanded(rows.model()->index(0, 0), true);
  std::reverse(layers.begin(), layers.end());
  other.set_layers(with_only_visible(layers, {}));
  EXPECT_TRUE(rows.isExpanded(rows.model()->index(0, 0)));
  EXPECT_TRUE(rows.isExpanded(rows.model()->index(1, 0)));
}

TEST_F(Layer_rows, drop_reorders_within_a_stage) {
  EXPECT_EQ(shown(), "edcba");
  EXPECT_TRUE(drop({"a"}, 0, stage(1)));
  EXPECT_EQ(order(), "bcade");
  EXPECT_EQ(shown(), "edacb");
  EXPECT_EQ(edits_.back().what, "Order of layers");
  EXPECT_FALSE(drop({"a"}, 0, stage(0)));
  EXPECT_FALSE(drop({"a", "d"}, 0, stage(1)));
  EXPECT_FALSE(drop({"a"}, 0, QModelIndex()));
  EXPECT_EQ(edits_.size(), 1u);
}

TEST_F(Layer_rows, selection_survives_reordering_and_new_lists) {
  panel_.select({"a", "d"});
  Layer_list layers = panel_.layers();
  std::reverse(layers.begin(), layers.end());
  panel_.set_layers(layers);
  EXPECT_EQ(shown(), "abcde");
  EXPECT_EQ(panel_.selected(), (QStringList{"a", "d"}));
  layers.erase(layers.end() - 1);
  panel_.set_layers(layers);
  EXPECT_EQ(shown(), "bcde");
  EXPECT_EQ(panel_.selected(), QStringList{"d"});
  panel_.set_layers(default_layers(*registry_));
  EXPECT_EQ(shown(), "edcba");
  EXPECT_TRUE(tree().isExpanded(stage(1)));
}

TEST_F(Layer_rows, filter_looks_into_label_id_and_help) {
  auto* filter = panel_.findChild<QLineEdit*>();
  panel_.select({"a", "b"});
  filter->setText("needle haystack");
  EXPECT_EQ(shown(), "b");
  EXPECT_TRUE(tree().isRowHidden(0, {}));
  EXPECT_EQ(panel_.selected(), QStringList{"b"});
  filter->setText("HELP d");
  EXPECT_EQ(shown(), "d");
  filter->setText("nothing of that kind");
  EXPECT_EQ(shown(), "");
  filter->clear();
  EXPECT_EQ(shown(), "edcba");
}

TEST_F(Layer_rows, visible_only_follows_visibility) {
  for (auto* button : panel_.findChildren<QToolButton*>()) {
    if (button->accessibleName() == "Visible layers only") button->setChecked(true);
  }
  EXPECT_EQ(shown(), "da");
  click(row("d"), Part::eye);
  EXPECT_EQ(shown(), "a");
}

TEST_F(Layer_rows, states_are_told_by_the_row) {
  EXPECT_EQ(row("a").data(Layer_model::state_role).toInt(), static_cast<int>(Layer_status::State::not_computed));
  EXPECT_TRUE(row("a").data(Layer_model::count_role).toString().isEmpty());
  const int plain_height = tree().visualRect(row("a")).height();

  Layer_status failed;
  failed.state = Layer_status::State::failed;
  failed.reason = "needs at least 3 points";
  panel_.set_status("a", failed);
  EXPECT_EQ(row("a").data(Layer_model::reason_role).toString(), "needs at least 3 points");
  EXPECT_TRUE(row("a").data(Qt::ToolTipRole).toString().contains("needs at least 3 points"));
  QApplication::processEvents();
  EXPECT_GT(tree().visualRect(row("a")).height(), plain_height);
  EXPECT_FALSE(
      tree().delegate().part_rectangle(row("a"), tree().visualRect(row("a")), tree().font(), Part::state).isEmpty());

  Layer_status current;
  current.state = Layer_status::State::current;
  current.count = 12345;
  current.warnings = QStringList{"2 points are duplicates"};
  panel_.set_status("a", current);
  EXPECT_EQ(row("a").data(Layer_model::count_role).toString(), QString("12") + QChar(0x202f) + "345");
  EXPECT_TRUE(row("a").data(Layer_model::reason_role).toString().isEmpty());
  EXPECT_EQ(row("a").data(Layer_model::warnings_role).toStringList(), QStringList{"2 points are duplicates"});
  QApplication::processEvents();
  EXPECT_EQ(tree().visualRect(row("a")).height(), plain_height);
  EXPECT_TRUE(
      tree().delegate().part_rectangle(row("a"), tree().visualRect(row("a")), tree().font(), Part::state).isEmpty());
  panel_.set_primitives("a", make_points());
  EXPECT_EQ(row("a").data(Layer_model::count_role).toString(), "101");
}

TEST_F(Layer_rows, what_is_hidden_or_has_no_input_does_not_alarm) {
  const auto has_badge = [&] {
    return !tree()
                .delegate()
                .part_rectangle(row("a"), tree().visualRect(row("a")), tree().font(), Part::state)
                .isEmpty();
  };
  QApplication::processEvents();
  const int plain_height = tree().visualRect(row("a")).height();
  Layer_status failed;
  failed.state = Layer_status::State::failed;
  failed.reason = "there is no mesh: open one";
  panel_.set_status("a", failed);
  QApplication::processEvents();
  EXPECT_EQ(row("a").data(Layer_model::reason_role).toString(), "there is no mesh: open one");
  EXPECT_TRUE(row("a").data(Layer_model::is_input_missing_role).toBool());
  EXPECT_FALSE(has_badge());
  failed.reason = "needs at least 3 points";
  failed.warnings = QStringList{"something odd"};
  panel_.set_status("a", failed);
  QApplication::processEvents();
  EXPECT_FALSE(row("a").data(Layer_model::is_input_missing_role).toBool());
  EXPECT_TRUE(has_badge());
  click(row("a"), Part::eye);
  QApplication::processEvents();
  EXPECT_EQ(tree().visualRect(row("a")).height(), plain_height);
  EXPECT_FALSE(has_badge());
  EXPECT_TRUE(row("a").data(Layer_model::reason_role).toString().isEmpty());
  EXPECT_TRUE(row("a").data(Layer_model::warnings_role).toStringList().isEmpty());
  EXPECT_TRUE(row("a").data(Qt::ToolTipRole).toString().contains("needs at least 3 points"));
}

TEST_F(Layer_rows, menu_commands) {
  choose_from_menu(row("b"), "Hide others");
  EXPECT_EQ(visible(), "");
  choose_from_menu(row("b"), "Show all");
  EXPECT_EQ(visible(), "abcde");
  choose_from_menu(row("b"), "Hide");
  EXPECT_EQ(visible(), "acde");
  choose_from_menu(row("b"), "Copy id");
  EXPECT_EQ(QApplication::clipboard()->text(), "b");

  Layer_list layers = panel_.layers();
  find_entry(layers, "a")->style.color = {1, 2, 3};
  panel_.set_layers(layers);
  choose_from_menu(row("a"), "Copy style");
  panel_.select({"b", "c"});
  choose_from_menu(row("b"), "Paste style");
  EXPECT_EQ(style("b").color, (Color{1, 2, 3}));
  EXPECT_EQ(style("c").color, (Color{1, 2, 3}));
  EXPECT_FALSE(style("b").visible);
  choose_from_menu(row("b"), "Reset style");
  EXPECT_EQ(style("b"), registry_->find_layer("b")->style);

  choose_from_menu(stage(0), "Draw below First");
  EXPECT_EQ(order(), "deabc");
}

TEST_F(Layer_rows, nothing_is_wider_than_the_panel) {
  EXPECT_LE(panel_.minimumSizeHint().width(), 300);
  EXPECT_EQ(tree().horizontalScrollBarPolicy(), Qt::ScrollBarAlwaysOff);
}

}  // namespace
}  // namespace mesecina
