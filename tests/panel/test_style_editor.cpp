// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QLineEdit>
#include <QSlider>
#include <QTest>
#include <QWheelEvent>

#include "layers/number_field.h"
#include "layers/style_editor.h"
#include "tests/panel/panel_fixture.h"

namespace mesecina {
namespace {

class Style_fields : public Panel_test {
 protected:
  template <class Widget>
  Widget* named(const QString& name) {
    for (Widget* widget : panel_.findChildren<Widget*>()) {
      if (widget->accessibleName() == name) return widget;
    }
    return nullptr;
  }
  QLineEdit* text_of(Number_field* field) { return field->findChild<QLineEdit*>(); }
  void type(Number_field* field, const QString& text) {
    field->setFocus();
    field->selectAll();
    QTest::keyClick(field, Qt::Key_Delete);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  }
  void show_values(const std::string& layer, const std::string& value) {
    panel_.set_primitives(layer, make_points());
    Layer_list layers = panel_.layers();
    find_entry(layers, layer)->style.value = value;
    panel_.set_layers(layers);
  }
};

TEST_F(Style_fields, change_applies_to_all_selected) {
  panel_.select({"b", "c"});
  named<QSlider>("Opacity")->setValue(40);
  ASSERT_EQ(edits_.size(), 1u);
  EXPECT_EQ(edits_[0].what, "Opacity of 2 layers");
  EXPECT_DOUBLE_EQ(style("b").opacity, 0.4);
  EXPECT_DOUBLE_EQ(style("c").opacity, 0.4);
  EXPECT_DOUBLE_EQ(style("a").opacity, 1);
  EXPECT_EQ(text_of(named<Number_field>("Opacity"))->text(), "40 %");
}

TEST_F(Style_fields, switches_of_space_are_there_for_layers_in_space_only) {
  const auto box = [&](const char* text) -> QCheckBox* {
    for (auto* candidate : panel_.findChildren<QCheckBox*>())
      if (candidate->text() == QLatin1String(text)) return candidate;
    return nullptr;
  };
  panel_.set_primitives("b", make_points());
  panel_.select({"b"});
  EXPECT_FALSE(box("Edges")->isVisible());
  auto in_space = std::make_shared<Primitive_set>(*make_points());
  in_space->dimension = 3;
  panel_.set_primitives("b", in_space);
  EXPECT_TRUE(box("Edges")->isVisible());
  EXPECT_FALSE(box("Edges")->isChecked());
  EXPECT_TRUE(box("Sliced")->isChecked());
  box("Edges")->click();
  box("Sliced")->click();
  EXPECT_TRUE(style("b").edges);
  EXPECT_FALSE(style("b").sliced);
  EXPECT_FALSE(style("b").smooth || style("b").vertices || style("a").edges);
}

TEST_F(Style_fields, mixed_values_are_shown_as_such) {
  Layer_list layers = panel_.layers();
  find_entry(layers, "b")->style.line_width = 4;
  find_entry(layers, "b")->style.filled = true;
  find_entry(layers, "b")->style.color_map = "magma";
  panel_.set_layers(layers);
  panel_.select({"b", "c"});
  auto* field = named<Number_field>("Line width");
  EXPECT_FALSE(field->value());
  EXPECT_EQ(text_of(field)->placeholderText(), "mixed");
  EXPECT_TRUE(edits_.empty());
  QCheckBox* filled = panel_.findChild<QCheckBox*>();
  EXPECT_EQ(filled->checkState(), Qt::PartiallyChecked);
  EXPECT_EQ(named<QComboBox>("Colour map")->currentIndex(), -1);

  type(field, "2.5");
  EXPECT_DOUBLE_EQ(style("b").line_width, 2.5);
  EXPECT_DOUBLE_EQ(style("c").line_width, 2.5);
  filled->click();
  EXPECT_TRUE(style("b").filled);
  EXPECT_TRUE(style("c").filled);
  EXPECT_EQ(filled->checkState(), Qt::Checked);
  filled->click();
  EXPECT_FALSE(style("b").filled);
}

TEST_F(Style_fields, moves_of_one_slider_drag_merge_and_of_two_do_not) {
  panel_.select({"b"});
  auto* slider = named<QSlider>("Point size");
  slider->setSliderDown(true);
  slider->setSliderPosition(20);
  slider->setSliderPosition(21);
  slider->setSliderDown(false);
  ASSERT_EQ(edits_.size(), 2u);
  EXPECT_FALSE(edits_[0].merge.isEmpty());
  EXPECT_EQ(edits_[0].merge, edits_[1].merge);
  EXPECT_DOUBLE_EQ(style("b").point_size, 10.5);
  slider->setSliderDown(true);
  slider->setSliderPosition(30);
  slider->setSliderDown(false);
  ASSERT_EQ(edits_.size(), 3u);
  EXPECT_NE(edits_[1].merge, edits_[2].merge);
}

TEST_F(Style_fields, numbers_are_those_of_the_c_locale) {
  ASSERT_EQ(QLocale().decimalPoint(), ",");
  panel_.select({"b"});
  auto* field = named<Number_field>("Line width");
  EXPECT_EQ(text_of(field)->text(), "1.5 px");
  type(field, "2.25");
  EXPECT_DOUBLE_EQ(style("b").line_width, 2.25);
  EXPECT_EQ(text_of(field)->text(), "2.25 px");
  type(field, "3,5");
  EXPECT_DOUBLE_EQ(style("b").line_width, 3.5);
  EXPECT_EQ(text_of(field)->text(), "3.5 px");
  type(field, "thick");
  EXPECT_DOUBLE_EQ(style("b").line_width, 3.5);
  EXPECT_EQ(text_of(field)->text(), "3.5 px");
  QTest::keyClick(field, Qt::Key_Up);
  EXPECT_DOUBLE_EQ(style("b").line_width, 3.75);
}

TEST_F(Style_fields, leaving_a_field_untouched_changes_nothing) {
  Layer_list layers = panel_.layers();
  find_entry(layers, "b")->style.line_width = 1.23456789012;
  panel_.set_layers(layers);
  panel_.select({"b"});
  auto* field = named<Number_field>("Line width");
  field->setFocus();
  QTest::keyClick(field, Qt::Key_Return);
  field->clearFocus();
  EXPECT_TRUE(edits_.empty());
}

TEST_F(Style_fields, wheel_changes_nothing_without_focus) {
  panel_.select({"b"});
  for (QWidget* widget :
       {static_cast<QWidget*>(named<QSlider>("Opacity")), static_cast<QWidget*>(named<Number_field>("Opacity"))}) {
    widget->clearFocus();
    QWheelEvent wheel(QPointF(5, 5), widget->mapToGlobal(QPointF(5, 5)), {}, QPoint(0, -120), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
  }
  EXPECT_TRUE(edits_.empty());
}

TEST_F(Style_fields, colour_dialog_is_live) {
  panel_.select({"b", "c"});
  panel_.findChild<Style_editor*>()->choose_color();
  auto* dialog = panel_.findChild<QColorDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->isModal());
  EXPECT_TRUE(edits_.empty());
  dialog->setCurrentColor(QColor(10, 20, 30));
  dialog->setCurrentColor(QColor(11, 20, 30));
  ASSERT_EQ(edits_.size(), 2u);
  EXPECT_EQ(style("b").color, (Color{11, 20, 30}));
  EXPECT_EQ(style("c").color, (Color{11, 20, 30}));
  EXPECT_EQ(edits_[0].merge, edits_[1].merge);
}

TEST_F(Style_fields, values_of_the_primitives_are_offered) {
  panel_.set_primitives("b", make_points());
  panel_.select({"b"});
  auto* combo = named<QComboBox>("Colour by");
  ASSERT_EQ(combo->count(), 3);
  EXPECT_EQ(combo->itemText(0), "plain");
  EXPECT_EQ(combo->itemText(1), "lambda");
  auto* map = named<QComboBox>("Colour map");
  EXPECT_FALSE(map->isVisible());
  combo->setCurrentIndex(1);
  Q_EMIT combo->activated(1);
  EXPECT_EQ(style("b").value, "lambda");
  EXPECT_TRUE(map->isVisible());
  const int magma = map->findData("magma");
  ASSERT_GE(magma, 0);
  map->setCurrentIndex(magma);
  Q_EMIT map->activated(magma);
  EXPECT_EQ(style("b").color_map, "magma");
}

TEST_F(Style_fields, range_is_automatic_until_chosen) {
  show_values("b", "lambda");
  panel_.select({"b"});
  auto* maximum = named<Number_field>("Range: maximum");
  EXPECT_FALSE(maximum->value());
  EXPECT_EQ(text_of(maximum)->placeholderText(), "100");
  type(maximum, "50.5");
  EXPECT_EQ(style("b").range_maximum, 50.5);
  type(maximum, "");
  EXPECT_EQ(style("b").range_maximum, std::nullopt);
  type(named<Number_field>("Shown: minimum"), "7");
  EXPECT_EQ(style("b").threshold_minimum, 7);
}

TEST_F(Style_fields, other_value_forgets_limits_of_the_old_one) {
  show_values("b", "lambda");
  panel_.select({"b"});
  type(named<Number_field>("Shown: minimum"), "7");
  auto* combo = named<QComboBox>("Colour by");
  Q_EMIT combo->activated(combo->findData("weight"));
  EXPECT_EQ(style("b").value, "weight");
  EXPECT_EQ(style("b").threshold_minimum, std::nullopt);
}

TEST_F(Style_fields, cut_is_a_setting) {
  panel_.set_primitives("e", make_points(10));
  panel_.select({"e"});
  auto* field = named<Number_field>("Limit");
  ASSERT_NE(field, nullptr);
  EXPECT_TRUE(field->isVisible());
  EXPECT_EQ(field->value(), 2);
  type(field, "3.5");
  ASSERT_EQ(setting_edits_.size(), 1u);
  EXPECT_EQ(setting_edits_[0].setting, "limit");
  EXPECT_DOUBLE_EQ(setting_edits_[0].value, 3.5);
  type(field, "99");
  EXPECT_DOUBLE_EQ(setting_edits_.back().value, 10);
  EXPECT_TRUE(edits_.empty());
  panel_.select({"b"});
  EXPECT_FALSE(field->isVisible());
}

}  // namespace
}  // namespace mesecina
