// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLineEdit>
#include <QSlider>
#include <QToolButton>
#include <QtTest>

#include "core/graph.h"
#include "layers/number_field.h"
#include "shell/settings_browser.h"
#include "shell/settings_panel.h"

namespace mesecina {
namespace {

std::shared_ptr<const Registry> registry() {
  auto made = std::make_shared<Registry>();
  made->begin_module({"m", "Module", "help"});
  made->add_setting({"limit", "Limit", "help", "degrees", 60.0, 0, 180, {}, {}});
  made->add_setting({"open", "Open", "help", "", 1.0, 0, std::numeric_limits<double>::infinity(), {}, {}});
  made->add_setting({"switch", "Switch", "help", "", true, 0, 0, {}, {}});
  made->add_setting({"count", "Count", "help", "", std::int64_t{5}, 1, 9, {}, {}});
  return made;
}

class Panel : public testing::Test {
 protected:
  Panel() {
    QObject::connect(&panel, &Settings_panel::edited,
                     [this](const Settings& settings, const QString&, const QString& merge) {
                       last = settings;
                       keys << merge;
                       panel.set_settings(settings);
                     });
    panel.show();
  }
  template <class T>
  T* named(const QString& name) {
    for (T* widget : panel.findChildren<T*>())
      if (widget->accessibleName() == name) return widget;
    return nullptr;
  }

  Settings_panel panel{registry()};
  Settings last;
  QStringList keys;
};

TEST_F(Panel, ShowsDefaultsAndTheDefaultIsInTheMiddleOfTheSlider) {
  EXPECT_EQ(named<Number_field>("Limit")->value(), 60);
  EXPECT_NEAR(named<QSlider>("Slider of Limit")->value(), 500, 1);
  EXPECT_FALSE(named<QToolButton>("Reset Limit")->isVisible());
}

TEST_F(Panel, SliderReachesBothEndsAndOneDragHasOneKey) {
  auto* slider = named<QSlider>("Slider of Limit");
  ASSERT_NE(slider, nullptr);
  Q_EMIT slider->sliderPressed();
  slider->setValue(700);
  slider->setValue(slider->maximum());
  EXPECT_EQ(*last.find("limit"), Setting_value(180.0));
  slider->setValue(0);
  EXPECT_EQ(*last.find("limit"), Setting_value(0.0));
  Q_EMIT slider->sliderReleased();
  EXPECT_EQ(QSet<QString>(keys.begin(), keys.end()).size(), 1);
  EXPECT_FALSE(keys.front().isEmpty());
  slider->setValue(300);
  EXPECT_NE(keys.back(), keys.front());
}

TEST_F(Panel, ResetGoesBackToTheDefault) {
  panel.set_settings(Settings().with("limit", 90.0));
  auto* reset = named<QToolButton>("Reset Limit");
  EXPECT_TRUE(reset->isVisible());
  QTest::mouseClick(reset, Qt::LeftButton);
  EXPECT_EQ(last, Settings());
  EXPECT_FALSE(reset->isVisible());
}

TEST_F(Panel, NumbersAreTypedWithAPointWhateverTheLocale) {
  auto* field = named<Number_field>("Open");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "2.5");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(*last.find("open"), Setting_value(2.5));
  EXPECT_EQ(field->text(), "2.5");
}

TEST_F(Panel, SwitchesAndWholeNumbersKeepTheirTypes) {
  QTest::mouseClick(named<QCheckBox>("Switch"), Qt::LeftButton, {},
                    QPoint(8, named<QCheckBox>("Switch")->height() / 2));
  EXPECT_EQ(*last.find("switch"), Setting_value(false));
  named<QSlider>("Slider of Count")->setValue(1000);
  EXPECT_EQ(*last.find("count"), Setting_value(std::int64_t{9}));
}

TEST_F(Panel, AnOpenSliderFollowsTheData) {
  panel.set_slider_maximum("open", 40);
  named<QSlider>("Slider of Open")->setValue(1000);
  EXPECT_EQ(*last.find("open"), Setting_value(40.0));
}

TEST_F(Panel, ASliderMayEndBeforeTheBoundButNotBeyond) {
  panel.set_slider_maximum("limit", 90);
  named<QSlider>("Slider of Limit")->setValue(1000);
  EXPECT_EQ(*last.find("limit"), Setting_value(90.0));
  auto* field = named<Number_field>("Limit");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "150");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(*last.find("limit"), Setting_value(150.0));
  panel.set_slider_maximum("limit", 1000);
  named<QSlider>("Slider of Limit")->setValue(1000);
  EXPECT_EQ(*last.find("limit"), Setting_value(180.0));
}

TEST_F(Panel, FilterFindsWordsInAnyOrderAndHidesTheRest) {
  using Ids = std::vector<std::string>;
  EXPECT_EQ(panel.listed(), (Ids{"limit", "open", "switch", "count"}));
  panel.set_filter("DEGREES lim", false);
  EXPECT_EQ(panel.listed(), (Ids{"limit"}));
  EXPECT_TRUE(named<Number_field>("Limit")->isVisible());
  EXPECT_FALSE(named<Number_field>("Count")->isVisible());
  panel.set_filter("module", false);
  EXPECT_EQ(panel.listed().size(), 4U);
  panel.set_filter("nowhere", false);
  EXPECT_TRUE(panel.listed().empty());
  panel.set_filter({}, false);
  EXPECT_TRUE(named<Number_field>("Count")->isVisible());
}

TEST_F(Panel, ChangedOnesAloneAreListedAndFollowChanges) {
  panel.set_filter({}, true);
  EXPECT_TRUE(panel.listed().empty());
  panel.set_settings(Settings{}.with("count", std::int64_t{7}));
  EXPECT_EQ(panel.listed(), std::vector<std::string>{"count"});
  EXPECT_TRUE(named<Number_field>("Count")->isVisible());
  EXPECT_FALSE(named<Number_field>("Limit")->isVisible());
  named<QToolButton>("Reset Count")->click();
  EXPECT_FALSE(named<Number_field>("Count")->isVisible());
}

TEST(SettingsBrowser, SearchesWhatIsTyped) {
  auto* panel = new Settings_panel(registry());
  Settings_browser browser(panel);
  browser.show();
  QTest::keyClicks(browser.findChild<QLineEdit*>(), "swit");
  EXPECT_EQ(panel->listed(), std::vector<std::string>{"switch"});
  browser.search("count");
  EXPECT_EQ(panel->listed(), std::vector<std::string>{"count"});
}

}  // namespace
}  // namespace mesecina
