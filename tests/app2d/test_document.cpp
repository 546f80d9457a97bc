// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shell/document.h"

namespace mesecina {
namespace {

Inputs with(std::vector<Point_2> points) { return Inputs().with(points_input, std::move(points)); }

TEST(Document, UndoAndRedoGiveTheVeryValuesBack) {
  Document document({with({{0, 0}}), {}, {{"points", {}}}});
  const void* first = document.inputs().identity("points");
  document.edit_inputs(with({{1, 1}}), "Move 1 point");
  Layer_list layers = document.layers();
  layers[0].style.opacity = 0.5;
  document.edit_layers(layers, "Opacity of Points");
  document.edit_settings(Settings().with("limit", 2.0), "Limit");
  EXPECT_EQ(document.history().count(), 3);

  document.history().undo();
  EXPECT_EQ(document.settings().find("limit"), nullptr);
  EXPECT_EQ(document.layers()[0].style.opacity, 0.5);
  document.history().undo();
  EXPECT_EQ(document.layers()[0].style.opacity, 1);
  document.history().undo();
  EXPECT_EQ(document.inputs().identity("points"), first);

  for (int i = 0; i < 3; ++i) document.history().redo();
  EXPECT_EQ(document.inputs().get(points_input)->at(0), (Point_2{1, 1}));
  EXPECT_EQ(document.layers()[0].style.opacity, 0.5);
  EXPECT_NE(document.settings().find("limit"), nullptr);
}

TEST(Document, StepsOfOneDragAreOne) {
  Document document({with({{0, 0}}), {}, {}});
  for (int i = 1; i <= 20; ++i) document.edit_inputs(with({{double(i), 0}}), "Move 1 point", "drag/1");
  EXPECT_EQ(document.history().count(), 1);
  document.edit_inputs(with({{5, 5}}), "Move 1 point", "drag/2");
  EXPECT_EQ(document.history().count(), 2);
  document.history().undo();
  document.history().undo();
  EXPECT_EQ(document.inputs().get(points_input)->at(0), (Point_2{0, 0}));
}

TEST(Document, ADragBackToTheStartIsNoStep) {
  Document document({with({{0, 0}}), {}, {}});
  const Inputs start = document.inputs();
  document.edit_inputs(with({{3, 0}}), "Move 1 point", "drag/1");
  EXPECT_TRUE(document.is_modified());
  document.edit_inputs(with({{0, 0}}), "Move 1 point", "drag/1");
  EXPECT_EQ(document.history().count(), 0);
  EXPECT_TRUE(document.inputs() == start);
  EXPECT_FALSE(document.is_modified());
}

TEST(Document, NoChangeIsNoStep) {
  Document document({with({{0, 0}}), {}, {}});
  int changes = 0;
  QObject::connect(&document, &Document::changed, [&] { ++changes; });
  document.edit_inputs(document.inputs(), "Nothing");
  EXPECT_EQ(document.history().count(), 0);
  EXPECT_EQ(changes, 0);
}

TEST(Document, TellsWhichPartsChanged) {
  Document document({with({{0, 0}}), {}, {{"points", {}}}});
  Document_change seen;
  QObject::connect(&document, &Document::changed, [&](const Document_change& change) { seen = change; });
  document.edit_inputs(with({{1, 0}}), "a");
  EXPECT_TRUE(seen.inputs && !seen.settings && !seen.layers);
  document.edit_settings(Settings().with("limit", 2.0), "b");
  EXPECT_TRUE(!seen.inputs && seen.settings && !seen.layers);
  document.edit_layers({}, "c");
  EXPECT_TRUE(!seen.inputs && !seen.settings && seen.layers);
}

TEST(Document, IsModifiedByDataUntilItIsSavedOrUndone) {
  Document document({with({{0, 0}}), {}, {}});
  document.edit_settings(Settings().with("limit", 2.0), "Limit");
  EXPECT_FALSE(document.is_modified());
  document.edit_inputs(with({{1, 0}}), "Move", "drag/1");
  EXPECT_TRUE(document.is_modified());
  document.mark_saved({"points"});
  EXPECT_FALSE(document.is_modified());
  // What was saved can be gone back to, even within one drag.
  document.edit_inputs(with({{2, 0}}), "Move", "drag/1");
  document.history().undo();
  EXPECT_FALSE(document.is_modified());
  document.edit_inputs(document.inputs().with(outline_input, Outline_2{{{{0, 0}, {1, 0}, {0, 1}}}}), "Draw");
  document.mark_saved({"points"});
  EXPECT_TRUE(document.is_modified());
  document.mark_saved({"outline"});
  EXPECT_FALSE(document.is_modified());
}

TEST(Document, KeepsTwoHundredSteps) {
  Document document({with({{0, 0}}), {}, {}});
  for (int i = 1; i <= 250; ++i) document.edit_inputs(with({{double(i), 0}}), "Move");
  EXPECT_EQ(document.history().count(), 200);
}

}  // namespace
}  // namespace mesecina
