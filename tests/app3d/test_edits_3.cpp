// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "app3d/editor_3.h"
#include "app3d/edits_3.h"
#include "app3d/mesh_transform_3.h"

namespace mesecina {
namespace {

std::vector<Ball_3> balls_of(const Inputs& inputs) {
  const auto balls = inputs.get(balls_input);
  return balls ? *balls : std::vector<Ball_3>();
}

std::vector<Point_3> points_of(const Inputs& inputs) {
  const auto points = inputs.get(cloud_input);
  return points ? *points : std::vector<Point_3>();
}

/// Two points and three balls.
Inputs sample() {
  return Inputs()
      .with(cloud_input, std::vector<Point_3>{{0, 0, 0}, {10, 0, 0}})
      .with(balls_input, std::vector<Ball_3>{{{0, 0, 5}, 1}, {{4, 0, 5}, 2}, {{8, 0, 5}, 0}});
}

TEST(Edits_3, SelectionsAreSets) {
  const Selection_3 all = all_of(sample(), {});
  EXPECT_EQ(all, (Selection_3{{0, 1}, {0, 1, 2}}));
  EXPECT_EQ(all_of(sample(), {false, true}), (Selection_3{{}, {0, 1, 2}}));
  EXPECT_EQ(toggled(all, {{1}, {0, 2}}), (Selection_3{{0}, {1}}));
  EXPECT_EQ(united({{1}, {}}, {{0}, {2}}), (Selection_3{{0, 1}, {2}}));
  EXPECT_TRUE(contains(all, {{1}, {2}}));
  EXPECT_FALSE(contains({{1}, {}}, {{}, {0}}));
  EXPECT_EQ(restricted({{1, 2}, {2, 3}}, sample()), (Selection_3{{1}, {2}}));
}

TEST(Edits_3, MovesResizesRemovesAndCopiesWhatIsSelected) {
  const Selection_3 some{{1, 77}, {0, 2, 99}};
  const Inputs after = moved(sample(), some, {1, 2, 3});
  EXPECT_EQ(points_of(after), (std::vector<Point_3>{{0, 0, 0}, {11, 2, 3}}));
  EXPECT_EQ(balls_of(after), (std::vector<Ball_3>{{{1, 2, 8}, 1}, {{4, 0, 5}, 2}, {{9, 2, 8}, 0}}));
  EXPECT_EQ(balls_of(resized(sample(), some, 3)),
            (std::vector<Ball_3>{{{0, 0, 5}, 3}, {{4, 0, 5}, 2}, {{8, 0, 5}, 0}}));
  EXPECT_EQ(balls_of(resized(sample(), some, std::numeric_limits<double>::infinity())), balls_of(sample()));
  EXPECT_EQ(balls_of(without(sample(), some)), (std::vector<Ball_3>{{{4, 0, 5}, 2}}));
  EXPECT_EQ(without(sample(), all_of(sample(), {})).ids(), std::vector<std::string>());
  const auto [copied, copies] = duplicated(sample(), some, {0, 0, 1});
  EXPECT_EQ(copies, (Selection_3{{2}, {3, 4}}));
  EXPECT_EQ(balls_of(copied)[4], (Ball_3{{8, 0, 6}, 0}));
  EXPECT_EQ(positions(sample(), some), (std::vector<Point_3>{{10, 0, 0}, {0, 0, 5}, {8, 0, 5}}));
  EXPECT_EQ(balls_of(with_ball(sample(), 1, {{7, 7, 7}, 7}))[1], (Ball_3{{7, 7, 7}, 7}));
  EXPECT_EQ(points_of(with_point(sample(), 5, {7, 7, 7})), points_of(sample()));
}

/// A tetrahedron with its outside outside.
Inputs tetrahedron() {
  return Inputs().with(mesh_input, Triangle_mesh_3{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
}

double volume(const Inputs& inputs) {
  const Triangle_mesh_3& mesh = *inputs.get(mesh_input);
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += dot(mesh.vertices[static_cast<std::size_t>(a)],
               cross(mesh.vertices[static_cast<std::size_t>(b)], mesh.vertices[static_cast<std::size_t>(c)])) /
           6;
  return sum;
}

const Point_3& corner(const Inputs& inputs, std::size_t index) { return inputs.get(mesh_input)->vertices[index]; }

TEST(Transform_3, ShiftsAndQuarterTurnsAreExact) {
  Transform_3 shift;
  shift.pivot = {1.0 / 3, 0.1, 7};
  shift.shift = {0.1, 0.2, 0.3};
  EXPECT_EQ(corner(transformed(tetrahedron(), shift), 1), (Point_3{1.1, 0.2, 0.3}));
  Transform_3 turn;
  turn.degrees = {0, 0, 90};
  EXPECT_EQ(corner(transformed(tetrahedron(), turn), 1), (Point_3{0, 1, 0}));
  turn.degrees = {-90, 0, 0};
  EXPECT_EQ(corner(transformed(tetrahedron(), turn), 3), (Point_3{0, 1, 0}));
  turn.degrees = {0, 450, 0};
  EXPECT_EQ(corner(transformed(tetrahedron(), turn), 3), (Point_3{1, 0, 0}));
}

TEST(Transform_3, TurnsAboutXBeforeYBeforeZ) {
  Transform_3 turn;
  turn.degrees = {90, 90, 0};
  // y to z by the first, z to x by the second.
  EXPECT_EQ(corner(transformed(tetrahedron(), turn), 2), (Point_3{1, 0, 0}));
  turn.degrees = {30, 0, 0};
  EXPECT_NEAR(corner(transformed(tetrahedron(), turn), 2).z, 0.5, 1e-15);
  turn.pivot = {0, 1, 0};
  EXPECT_EQ(corner(transformed(tetrahedron(), turn), 2), (Point_3{0, 1, 0}));
}

TEST(Transform_3, KeepsOutsideOutsideAndScalesRadii) {
  Transform_3 transform;
  transform.scale = 2;
  transform.mirrored = {true, false, false};
  const Inputs after = transformed(tetrahedron().with(balls_input, std::vector<Ball_3>{{{1, 0, 0}, 3}}), transform);
  EXPECT_NEAR(volume(after), 8 * volume(tetrahedron()), 1e-12);
  EXPECT_EQ(corner(after, 1), (Point_3{-2, 0, 0}));
  EXPECT_EQ(balls_of(after)[0], (Ball_3{{-2, 0, 0}, 6}));
  transform.mirrored = {true, true, false};
  EXPECT_NEAR(volume(transformed(tetrahedron(), transform)), 8 * volume(tetrahedron()), 1e-12);
}

TEST(Transform_3, CentersAndNormalizes) {
  Transform_3 transform;
  transform.degrees = {10, 20, 30};
  transform.pivot = {5, 5, 5};
  const Box box = bounding_box(transformed(tetrahedron(), normalized(tetrahedron(), transform)));
  EXPECT_NEAR(box.diagonal(), 1, 1e-14);
  EXPECT_NEAR(distance(midpoint(box.lower, box.upper), {0, 0, 0}), 0, 1e-14);
  const Transform_3 center = centered(tetrahedron(), {});
  EXPECT_EQ(center.shift, (Point_3{-0.5, -0.5, -0.5}));
  EXPECT_EQ(center.scale, 1);
  const Inputs one = Inputs().with(cloud_input, std::vector<Point_3>{{1, 2, 3}});
  EXPECT_EQ(points_of(transformed(one, normalized(one, {}))), (std::vector<Point_3>{{0, 0, 0}}));
}

class Editor_3_test : public testing::Test {
 protected:
  Document document_{Document_state{sample(), {}, {}}};
  Editor_3 editor_{document_};
};

TEST_F(Editor_3_test, ADragIsOneStepAndBackToTheStartNone) {
  editor_.select({{}, {0, 1}});
  editor_.begin_drag();
  editor_.drag_by({1, 0, 0});
  editor_.drag_by({2, 0, 0});
  EXPECT_EQ(document_.history().count(), 1);
  EXPECT_EQ(document_.history().text(0), "Move 2 balls");
  EXPECT_EQ(balls_of(document_.inputs())[1].center, (Point_3{6, 0, 5}));
  document_.history().undo();
  EXPECT_EQ(balls_of(document_.inputs()), balls_of(sample()));
  EXPECT_EQ(editor_.selection(), (Selection_3{{}, {0, 1}}));
  EXPECT_FALSE(document_.is_modified());
  editor_.begin_drag();
  editor_.drag_by({1, 0, 0});
  editor_.drag_by({});
  EXPECT_EQ(document_.history().count(), 0);
}

TEST_F(Editor_3_test, ResizingScalesTheOtherSelectedBalls) {
  editor_.select({{0}, {0, 1, 2}});
  editor_.begin_drag();
  editor_.drag_radius(0, 1.5);
  EXPECT_EQ(balls_of(document_.inputs())[1].radius, 3);
  EXPECT_EQ(balls_of(document_.inputs())[2].radius, 0);
  EXPECT_EQ(document_.history().text(0), "Resize 3 balls");
  editor_.drag_radius(2, 4);
  EXPECT_EQ(balls_of(document_.inputs())[2].radius, 4);
  editor_.drag_radius(0, -1);
  editor_.drag_radius(9, 1);
  EXPECT_EQ(balls_of(document_.inputs())[2].radius, 4);
  EXPECT_EQ(document_.history().count(), 1);
}

TEST_F(Editor_3_test, TheWheelTurnedBackLeavesNoStep) {
  editor_.select({{}, {1}});
  editor_.turn_wheel(15);
  EXPECT_GT(balls_of(document_.inputs())[1].radius, 2.1);
  editor_.turn_wheel(-15);
  EXPECT_EQ(document_.history().count(), 0);
  EXPECT_EQ(balls_of(document_.inputs())[1].radius, 2);
}

TEST_F(Editor_3_test, UndoSelectsWhatItBringsBack) {
  editor_.select({{1}, {0}});
  editor_.remove_selected();
  EXPECT_EQ(document_.history().text(0), "Delete 1 point and 1 ball");
  EXPECT_TRUE(editor_.selection().is_empty());
  document_.history().undo();
  EXPECT_EQ(editor_.selection(), (Selection_3{{1}, {0}}));
  EXPECT_EQ(balls_of(document_.inputs()), balls_of(sample()));
  document_.history().redo();
  EXPECT_EQ(balls_of(document_.inputs()).size(), 2U);
}

TEST_F(Editor_3_test, AddsOneStepEachWithTheRadiusOfTheLast) {
  editor_.add_ball({{1, 1, 1}, 0.5});
  editor_.add_ball({{2, 2, 2}, editor_.usual_radius(100)});
  EXPECT_EQ(balls_of(document_.inputs())[4].radius, 0.5);
  EXPECT_EQ(document_.history().count(), 2);
  EXPECT_EQ(editor_.selection(), (Selection_3{{}, {4}}));
  editor_.add_point({3, 3, 3});
  EXPECT_EQ(points_of(document_.inputs()).size(), 3U);
  for (int i = 0; i < 3; ++i) document_.history().undo();
  EXPECT_EQ(balls_of(document_.inputs()), balls_of(sample()));
  EXPECT_FALSE(document_.is_modified());
}

TEST_F(Editor_3_test, TransformingWithOneKeyIsOneStep) {
  const Inputs start = document_.inputs();
  Transform_3 transform;
  transform.shift = {1, 0, 0};
  editor_.transform(start, transform, "key");
  transform.shift = {0, 0, 2};
  editor_.transform(start, transform, "key");
  EXPECT_EQ(document_.history().count(), 1);
  EXPECT_EQ(points_of(document_.inputs())[1], (Point_3{10, 0, 2}));
  transform.shift = {};
  editor_.transform(start, transform, "key");
  EXPECT_EQ(document_.history().count(), 0);
  EXPECT_TRUE(document_.inputs() == start);
}

TEST_F(Editor_3_test, SavedPartsOfSpaceAreNotModified) {
  editor_.select({{}, {0}});
  editor_.nudge({1, 0, 0});
  EXPECT_TRUE(document_.is_modified());
  document_.mark_saved({std::string(balls_input.id)});
  EXPECT_FALSE(document_.is_modified());
  document_.history().undo();
  EXPECT_TRUE(document_.is_modified());
}

}  // namespace
}  // namespace mesecina
