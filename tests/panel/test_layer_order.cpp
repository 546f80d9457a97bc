// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "layers/layer_order.h"
#include "tests/panel/panel_fixture.h"

namespace mesecina {
namespace {

Layer_list list_of(const std::string& ids) {
  Layer_list result;
  for (const char id : ids) result.push_back({std::string(1, id), {}});
  return result;
}

std::string text(const Layer_list& layers) {
  std::string result;
  for (const Layer_entry& entry : layers) result += entry.id;
  return result;
}

TEST(Layer_order, topmost_layer_comes_first) {
  const auto stages = shown_stages(*make_registry(), list_of("abcde"));
  const std::vector<Shown_stage> expected{{"Second", {4, 3}, false}, {"First", {2, 1, 0}, false}};
  EXPECT_EQ(stages, expected);
}

TEST(Layer_order, interleaved_stage_says_so) {
  const auto stages = shown_stages(*make_registry(), list_of("adbec"));
  const std::vector<Shown_stage> expected{{"First", {4, 2, 0}, true}, {"Second", {3, 1}, true}};
  EXPECT_EQ(stages, expected);
  EXPECT_FALSE(shown_stages(*make_registry(), list_of("adeb"))[1].is_interleaved);
}

TEST(Layer_order, unknown_layers_are_not_shown_and_do_not_interleave) {
  const auto stages = shown_stages(*make_registry(), list_of("axb"));
  const std::vector<Shown_stage> expected{{"First", {2, 0}, false}};
  EXPECT_EQ(stages, expected);
}

TEST(Layer_order, move_permutes_only_the_stage) {
  const auto registry = make_registry();
  // Rows of First: c b a.
  EXPECT_EQ(text(move_within_stage(*registry, list_of("abcde"), "First", {"a"}, 0)), "bcade");
  EXPECT_EQ(text(move_within_stage(*registry, list_of("abcde"), "First", {"c"}, 3)), "cabde");
  EXPECT_EQ(text(move_within_stage(*registry, list_of("abcde"), "First", {"a", "c"}, 1)), "bacde");
  EXPECT_EQ(text(move_within_stage(*registry, list_of("adbec"), "First", {"a"}, 0)), "bdcea");
  EXPECT_EQ(text(move_within_stage(*registry, list_of("abcde"), "First", {"e"}, 0)), "abcde");
  EXPECT_EQ(text(move_within_stage(*registry, list_of("abcde"), "None", {"a"}, 0)), "abcde");
}

TEST(Layer_order, whole_stages_move_and_gather) {
  const auto registry = make_registry();
  EXPECT_EQ(text(move_stage_above(*registry, list_of("abcde"), "First", "Second")), "deabc");
  EXPECT_EQ(text(move_stage_above(*registry, list_of("abcde"), "Second", "First")), "abcde");
  EXPECT_EQ(text(move_stage_above(*registry, list_of("abcde"), "First", "First")), "abcde");
  EXPECT_EQ(text(gather_stage(*registry, list_of("adbec"), "Second")), "abdec");
  EXPECT_EQ(text(gather_stage(*registry, list_of("adbec"), "First")), "deabc");
}

}  // namespace
}  // namespace mesecina
