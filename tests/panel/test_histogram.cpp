// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <chrono>
#include <limits>
#include <numeric>
#include <random>

#include "layers/histogram.h"
#include "layers/histogram_widget.h"
#include "tests/panel/panel_fixture.h"

namespace mesecina {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Handle = Histogram_widget::Handle;

TEST(Histogram, counts_every_value_once) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(0, 3);
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i) values.push_back(normal(generator));
  values.push_back(infinity);
  values.push_back(-infinity);
  values.push_back(std::numeric_limits<double>::quiet_NaN());
  const Histogram histogram = compute_histogram(values, 50);
  ASSERT_EQ(histogram.bins.size(), 50u);
  EXPECT_EQ(std::accumulate(histogram.bins.begin(), histogram.bins.end(), std::size_t{0}), 10000u);
  EXPECT_EQ(histogram.finite, 10000u);
  EXPECT_EQ(histogram.infinite, 1u);
  EXPECT_EQ(histogram.other, 2u);
  EXPECT_FALSE(histogram.is_logarithmic);
  for (std::size_t bin = 0; bin < 50; ++bin) {
    const double from = histogram.value(static_cast<double>(bin) / 50);
    const double to = bin == 49 ? infinity : histogram.value(static_cast<double>(bin + 1) / 50);
    const auto expected =
        std::count_if(values.begin(), values.end(), [&](double v) { return std::isfinite(v) && v >= from && v < to; });
    EXPECT_NEAR(static_cast<double>(histogram.bins[bin]), static_cast<double>(expected), 1) << bin;
  }
}

TEST(Histogram, is_logarithmic_beyond_three_decades) {
  EXPECT_FALSE(compute_histogram(std::vector<double>{0.5, 1, 400}).is_logarithmic);
  EXPECT_FALSE(compute_histogram(std::vector<double>{-0.5, 0.001, 4000}).is_logarithmic);
  const Histogram histogram = compute_histogram(std::vector<double>{0, 0, 0.1, 12, 1000}, 4);
  EXPECT_TRUE(histogram.is_logarithmic);
  EXPECT_EQ(histogram.below, 2u);
  EXPECT_DOUBLE_EQ(histogram.lower, 0.1);
  EXPECT_DOUBLE_EQ(histogram.position(10), 0.5);
  EXPECT_DOUBLE_EQ(histogram.value(0.5), 10);
  EXPECT_EQ(histogram.bins, (std::vector<std::size_t>{1, 0, 1, 1}));
}

TEST(Histogram, integers_have_bins_of_their_own) {
  const Histogram histogram = compute_histogram(std::vector<double>{3, 4, 4, 7});
  EXPECT_EQ(histogram.bins, (std::vector<std::size_t>{1, 2, 0, 0, 1}));
  EXPECT_DOUBLE_EQ(histogram.value(0.3), 4);
}

TEST(Histogram, degenerate_values) {
  EXPECT_TRUE(compute_histogram(std::vector<double>{}).bins.empty());
  EXPECT_TRUE(compute_histogram(std::vector<double>{infinity}).bins.empty());
  const Histogram constant = compute_histogram(std::vector<double>{0.5, 0.5});
  EXPECT_EQ(constant.bins, std::vector<std::size_t>{2});
  EXPECT_GT(constant.position(0.5), 0);
  EXPECT_LT(constant.position(0.5), 1);
}

TEST(Histogram, million_values_take_no_time) {
  std::mt19937 generator(1);
  std::lognormal_distribution<double> distribution(0, 3);
  std::vector<double> values(1000000);
  for (double& value : values) value = distribution(generator);
  const auto start = std::chrono::steady_clock::now();
  const Histogram histogram = compute_histogram(values);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(histogram.finite, values.size());
  EXPECT_LT(elapsed.count(), 0.5);
}

class Histogram_handles : public Panel_test {
 protected:
  void SetUp() override {
    Layer_list layers = panel_.layers();
    find_entry(layers, "b")->style.value = "lambda";
    panel_.set_layers(layers);
    panel_.set_primitives("b", make_points(7));
    panel_.set_primitives("e", make_points(10));
  }
  Histogram_widget& histogram() { return *panel_.findChild<Histogram_widget*>(); }
  void drag(double from, std::vector<double> to) {
    const int y = histogram().height() / 2;
    const auto at = [&](double x) { return QPoint(static_cast<int>(std::lround(x)), y); };
    QTest::mousePress(&histogram(), Qt::LeftButton, {}, at(from));
    for (const double x : to) QTest::mouseMove(&histogram(), at(x));
    QTest::mouseRelease(&histogram(), Qt::LeftButton, {}, at(to.back()));
  }
  /// What a pixel is worth.
  double resolution() { return 1 / (histogram().x_of(1) - histogram().x_of(0)); }
};

TEST_F(Histogram_handles, drag_of_the_cut_edits_the_setting) {
  panel_.select({"e"});
  EXPECT_NEAR(histogram().handle_x(Handle::minimum), histogram().x_of(2), 1e-9);
  drag(histogram().x_of(2), {histogram().x_of(4), histogram().x_of(7.5)});
  ASSERT_EQ(setting_edits_.size(), 2u);
  EXPECT_EQ(setting_edits_[1].setting, "limit");
  EXPECT_NEAR(setting_edits_[0].value, 4, resolution());
  EXPECT_NEAR(setting_edits_[1].value, 7.5, resolution());
  EXPECT_FALSE(setting_edits_[0].merge.isEmpty());
  EXPECT_EQ(setting_edits_[0].merge, setting_edits_[1].merge);
  EXPECT_TRUE(edits_.empty());
  EXPECT_NEAR(histogram().handle_x(Handle::minimum), histogram().x_of(setting_edits_[1].value), 1e-9);

  drag(histogram().handle_x(Handle::minimum), {histogram().x_of(1)});
  EXPECT_NE(setting_edits_[2].merge, setting_edits_[1].merge);
  drag(histogram().handle_x(Handle::minimum), {-50.0});
  EXPECT_DOUBLE_EQ(setting_edits_.back().value, 0);
}

TEST_F(Histogram_handles, double_click_resets_the_cut_to_its_default) {
  panel_.select({"e"});
  drag(histogram().x_of(2), {histogram().x_of(5)});
  QTest::mouseDClick(&histogram(), Qt::LeftButton, {},
                     QPoint(static_cast<int>(histogram().x_of(8)), histogram().height() / 2));
  EXPECT_DOUBLE_EQ(setting_edits_.back().value, 2);
}

TEST_F(Histogram_handles, drag_of_thresholds_edits_the_style) {
  panel_.select({"b"});
  drag(histogram().handle_x(Handle::minimum), {histogram().x_of(3), histogram().x_of(5)});
  ASSERT_EQ(edits_.size(), 2u);
  EXPECT_EQ(edits_[0].merge, edits_[1].merge);
  ASSERT_TRUE(style("b").threshold_minimum);
  EXPECT_NEAR(*style("b").threshold_minimum, 5, resolution());
  EXPECT_FALSE(style("b").threshold_maximum);
  drag(histogram().handle_x(Handle::maximum), {histogram().x_of(9)});
  EXPECT_NEAR(*style("b").threshold_maximum, 9, resolution());
  // One cannot pass the other, and beyond the end is no limit.
  drag(histogram().handle_x(Handle::maximum), {histogram().x_of(2)});
  EXPECT_EQ(style("b").threshold_maximum, style("b").threshold_minimum);
  drag(histogram().handle_x(Handle::maximum), {1000.0});
  EXPECT_FALSE(style("b").threshold_maximum);
  EXPECT_TRUE(setting_edits_.empty());
}

TEST_F(Histogram_handles, handle_values_have_no_more_digits_than_pixels_can_tell) {
  panel_.select({"b"});
  drag(histogram().handle_x(Handle::minimum), {histogram().x_of(4.1234567)});
  const double value = *style("b").threshold_minimum;
  EXPECT_DOUBLE_EQ(value, std::round(value * 100) / 100);
}

TEST_F(Histogram_handles, double_click_resets_both_thresholds_at_once) {
  panel_.select({"b"});
  drag(histogram().handle_x(Handle::minimum), {histogram().x_of(3)});
  drag(histogram().handle_x(Handle::maximum), {histogram().x_of(12)});
  const std::size_t before = edits_.size();
  QTest::mouseDClick(&histogram(), Qt::LeftButton, {},
                     QPoint(static_cast<int>(histogram().x_of(7)), histogram().height() / 2));
  EXPECT_EQ(edits_.size(), before + 1);
  EXPECT_FALSE(style("b").threshold_minimum);
  EXPECT_FALSE(style("b").threshold_maximum);
}

TEST_F(Histogram_handles, keys_move_the_focused_handle) {
  panel_.activateWindow();
  panel_.select({"b"});
  histogram().setFocus();
  QTest::keyClick(&histogram(), Qt::Key_Right, Qt::ShiftModifier);
  QTest::keyClick(&histogram(), Qt::Key_Right);
  ASSERT_TRUE(style("b").threshold_minimum);
  const double first = *style("b").threshold_minimum;
  EXPECT_NEAR(first, 100.0 / 7 * 11 / 200, 2 * resolution());
  QTest::keyClick(&histogram(), Qt::Key_Left);
  EXPECT_LT(*style("b").threshold_minimum, first);
  QTest::keyClick(&histogram(), Qt::Key_Tab);
  QTest::keyClick(&histogram(), Qt::Key_Left, Qt::ShiftModifier);
  ASSERT_TRUE(style("b").threshold_maximum);
  QTest::keyClick(&histogram(), Qt::Key_Delete);
  EXPECT_FALSE(style("b").threshold_maximum);
  EXPECT_TRUE(style("b").threshold_minimum);
}

TEST_F(Histogram_handles, bins_are_those_of_the_selected_layer) {
  panel_.select({"b"});
  EXPECT_DOUBLE_EQ(histogram().histogram().maximum, 100.0 / 7);
  panel_.select({"e"});
  EXPECT_DOUBLE_EQ(histogram().histogram().maximum, 10);
  panel_.select({"a"});
  EXPECT_TRUE(histogram().histogram().bins.empty());
  EXPECT_FALSE(histogram().accessibleDescription().isEmpty());
}

}  // namespace
}  // namespace mesecina
