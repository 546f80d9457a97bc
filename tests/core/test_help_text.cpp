// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/help_text.h"
#include "core/place.h"

namespace mesecina {
namespace {

Registry registry_with_help() {
  Registry registry;
  registry.begin_module({"module", "Module", "For tests."});
  Layer_spec layer;
  layer.id = "label-conflicts";
  layer.label = "Label conflicts";
  registry.add_layer(layer);
  registry.add_setting({"ball-source", "Ball source", "", "", 0.5, 0, 1, {}, {}});
  Evolution_spec evolution;
  evolution.id = "grow-balls";
  evolution.label = "Growing";
  registry.add_evolution(evolution);
  return registry;
}

TEST(Help_text, NamesByLabelsInWindowsAndByIdsElsewhere) {
  const std::string text = "{grow-balls} takes what {ball-source} says; {label-conflicts} shows where.";
  EXPECT_EQ(with_labels(text, registry_with_help()),
            "“Growing” takes what “Ball source” says; “Label conflicts” shows where.");
  EXPECT_EQ(with_ids(text), "grow-balls takes what ball-source says; label-conflicts shows where.");
}

TEST(Help_text, LeavesOtherBraces) {
  const Registry registry = registry_with_help();
  for (const char* text :
       {"", "none", "{", "}", "{}", "an open {ball-source", "{\"center\": [x, y]}", "{Ball-source}"}) {
    EXPECT_EQ(with_labels(text, registry), text);
    EXPECT_EQ(with_ids(text), text);
  }
  EXPECT_EQ(with_labels("{unknown} {{ball-source}}", registry), "{unknown} {“Ball source”}");
  EXPECT_EQ(with_ids("{a {ball-source}"), "{a ball-source");
}

TEST(Places, AreShownWithWhatIsAround) {
  Box data;
  data.add(Point_2{0, 0});
  data.add(Point_2{30, 40});
  EXPECT_TRUE(box_around({}, data).is_empty());
  const Box box = box_around({{{10, 10, 0}}, {{20, 10, 0}}}, data);
  EXPECT_DOUBLE_EQ(box.lower.x, 8.5);
  EXPECT_DOUBLE_EQ(box.upper.x, 21.5);
  EXPECT_DOUBLE_EQ(box.upper.y, 11.5);
}

}  // namespace
}  // namespace mesecina
