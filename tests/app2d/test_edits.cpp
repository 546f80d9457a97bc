// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "app2d/edits_2.h"

namespace mesecina {
namespace {

Inputs sample() {
  return Inputs()
      .with(points_input, std::vector<Point_2>{{0, 0}, {10, 0}, {20, 0}})
      .with(outline_input, Outline_2{{{{0, 0.5}, {10, 5}, {20, 5}, {5, 9}}, {{100, 100}, {110, 100}, {100, 110}}}});
}

TEST(Edits2, NearestPrefersThePointAndRespectsReach) {
  EXPECT_EQ(nearest(sample(), {}, {0, 0.25}, 1), (Selection_2{{0}, {}}));
  EXPECT_EQ(nearest(sample(), {}, {0, 0.3}, 1), (Selection_2{{}, {{0, 0}}}));
  EXPECT_EQ(nearest(sample(), {false, true}, {0, 0}, 1), (Selection_2{{}, {{0, 0}}}));
  EXPECT_TRUE(nearest(sample(), {}, {0, 3}, 1).is_empty());
  EXPECT_EQ(nearest(sample(), {}, {11, 0}, 1), (Selection_2{{1}, {}}));
}

TEST(Edits2, BoxSelectsPointsAndVertices) {
  Box box;
  box.add(Point_2{5, -1});
  box.add(Point_2{25, 6});
  EXPECT_EQ(inside(sample(), {}, box), (Selection_2{{1, 2}, {{0, 1}, {0, 2}}}));
  EXPECT_EQ(all_of(sample(), {}).size(), 10u);
}

TEST(Edits2, MovesOnlyTheSelected) {
  const Inputs after = moved(sample(), {{1}, {{1, 0}}}, 1, 2);
  EXPECT_EQ(*after.get(points_input), (std::vector<Point_2>{{0, 0}, {11, 2}, {20, 0}}));
  EXPECT_EQ(after.get(outline_input)->rings[1][0], (Point_2{101, 102}));
  EXPECT_EQ(after.get(outline_input)->rings[0], sample().get(outline_input)->rings[0]);
}

TEST(Edits2, RemovingVerticesOfATriangleRemovesTheRing) {
  const Inputs after = without(sample(), {{0, 2}, {{0, 3}, {1, 1}}});
  EXPECT_EQ(*after.get(points_input), (std::vector<Point_2>{{10, 0}}));
  ASSERT_EQ(after.get(outline_input)->rings.size(), 1u);
  EXPECT_EQ(after.get(outline_input)->rings[0].size(), 3u);
  const Inputs nothing = without(sample(), all_of(sample(), {}));
  EXPECT_TRUE(nothing.is_empty());
}

TEST(Edits2, DuplicatesPointsAndWholeRings) {
  const Selection_2 selection{{2}, {{0, 1}, {1, 0}, {1, 1}, {1, 2}}};
  const auto [after, copies] = duplicated(sample(), selection, 1, 1);
  EXPECT_EQ(after.get(points_input)->back(), (Point_2{21, 1}));
  ASSERT_EQ(after.get(outline_input)->rings.size(), 3u);
  EXPECT_EQ(after.get(outline_input)->rings[2][0], (Point_2{101, 101}));
  EXPECT_EQ(copies, (Selection_2{{3}, {{2, 0}, {2, 1}, {2, 2}}}));
}

TEST(Edits2, AppendsEverything) {
  const Inputs more =
      Inputs().with(points_input, std::vector<Point_2>{{7, 7}}).with(disks_input, std::vector<Disk_2>{{{1, 1}, 2}});
  const Inputs after = appended(sample(), more);
  EXPECT_EQ(after.get(points_input)->size(), 4u);
  EXPECT_EQ(after.get(disks_input)->size(), 1u);
}

TEST(Edits2, SelectionsThatPointBeyondTheDataAreIgnored) {
  const Selection_2 wild{{1, 99}, {{0, 50}, {7, 0}}};
  EXPECT_EQ(restricted(wild, sample()), (Selection_2{{1}, {}}));
  EXPECT_EQ(positions(sample(), wild), (std::vector<Point_2>{{10, 0}}));
  EXPECT_EQ(moved(sample(), wild, 1, 0).get(points_input)->at(1), (Point_2{11, 0}));
  EXPECT_EQ(without(sample(), wild).get(points_input)->size(), 2u);
}

Inputs with_three_disks() {
  return sample().with(disks_input, std::vector<Disk_2>{{{0, -20}, 5}, {{20, -20}, 5}, {{20, -20}, 1}});
}

TEST(Edits2, DisksAreFoundByCenterAndElseByBoundary) {
  EXPECT_EQ(nearest(with_three_disks(), {}, {0.5, -20}, 1), (Selection_2{{}, {}, {0}}));
  EXPECT_EQ(nearest(with_three_disks(), {}, {0, -14.5}, 1), (Selection_2{{}, {}, {0}}));
  EXPECT_TRUE(nearest(with_three_disks(), {}, {0, -17.5}, 1).is_empty());
  // A center comes before a boundary, and of equal centers the first.
  EXPECT_EQ(nearest(with_three_disks(), {}, {20, -19}, 1.5), (Selection_2{{}, {}, {1}}));
  EXPECT_EQ(nearest(with_three_disks(), {}, {20, -19}, 0.5), (Selection_2{{}, {}, {2}}));
  EXPECT_TRUE(nearest(with_three_disks(), {true, true, false}, {0, -20}, 1).is_empty());
}

TEST(Edits2, DisksAreMovedResizedRemovedAndCopied) {
  const Inputs start = with_three_disks();
  const Selection_2 selection{{}, {}, {0, 2, 99}};
  const auto disks = [](const Inputs& inputs) { return *inputs.get(disks_input); };
  EXPECT_EQ(disks(moved(start, selection, 1, 2)), (std::vector<Disk_2>{{{1, -18}, 5}, {{20, -20}, 5}, {{21, -18}, 1}}));
  EXPECT_EQ(disks(resized(start, selection, 2)), (std::vector<Disk_2>{{{0, -20}, 10}, {{20, -20}, 5}, {{20, -20}, 2}}));
  EXPECT_EQ(disks(resized(start, selection, 0)), disks(start));
  EXPECT_EQ(disks(resized(start, selection, std::numeric_limits<double>::infinity())), disks(start));
  EXPECT_EQ(disks(without(start, selection)), (std::vector<Disk_2>{{{20, -20}, 5}}));
  EXPECT_EQ(without(start, {{}, {}, {0, 1, 2}}).get(disks_input), nullptr);
  EXPECT_EQ(disks(with_disk(start, 1, {{7, 7}, 7}))[1], (Disk_2{{7, 7}, 7}));
  const auto [copied, copies] = duplicated(start, selection, 1, 0);
  EXPECT_EQ(copies, (Selection_2{{}, {}, {3, 4}}));
  EXPECT_EQ(disks(copied)[4], (Disk_2{{21, -20}, 1}));
  EXPECT_EQ(positions(start, {{1}, {}, {1}}), (std::vector<Point_2>{{10, 0}, {20, -20}}));
  EXPECT_EQ(disks(placed(start, {{}, {}, {1}}, {3, 4}))[1], (Disk_2{{3, 4}, 5}));
}

TEST(Edits2, TablesOfPointsAndDisksComeApart) {
  EXPECT_EQ(to_table({}, {{{0.1, 2}, 1.0 / 3}}), "0.1 2 0.3333333333333333\n");
  const std::string both = to_table({{1, 2}}, {{{3, 4}, 5}});
  EXPECT_EQ(both, "x y\n1 2\nx y radius\n3 4 5\n");
  EXPECT_EQ(table_parts(both), (std::vector<std::string>{"x y\n1 2\n", "\n\nx y radius\n3 4 5\n"}));
  EXPECT_EQ(table_parts("1 2\r\n3 4"), (std::vector<std::string>{"1 2\n3 4\n"}));
}

TEST(Edits2, TableIsExact) {
  EXPECT_EQ(to_table({{0.1, -1e300}, {1.0 / 3, 2}}), "0.1 -1e+300\n0.3333333333333333 2\n");
}

}  // namespace
}  // namespace mesecina
