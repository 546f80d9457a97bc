// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/graph.h"
#include "geometries/modules_3.h"
#include "geometries/samples_3/module.h"
#include "geometries/union_3/module.h"
#include "geometries/union_3/power_diagram_3.h"
#include "tests/geometries/solid_3/meshes_3.h"

namespace mesecina::test {
namespace {

class Ball_source_3 : public testing::Test {
 protected:
  void set(const Inputs& inputs, const char* source = "automatic") {
    graph_.set_inputs(inputs);
    graph_.set_settings(Settings().with("delta", 0.08).with("ball-source", source));
  }
  std::vector<Ball_3> balls() {
    const auto found = graph_.structure(balls_3_key, progress_);
    EXPECT_TRUE(found.value) << found.reason;
    return found.value ? *found.value : std::vector<Ball_3>();
  }
  std::string reason() { return graph_.structure(balls_3_key, progress_).reason; }
  Topology topology_of(const char* layer) { return *topology(*graph_.layer(layer, progress_).value); }

  Graph graph_{make_registry_3()};
  Progress progress_;
};

const std::vector<Ball_3> given{{{1.2, 0, 0}, 0.5}, {{0.1, 0.2, 0}, 0.05}, {{4, 0, 0}, 0.25}};
const auto sphere = [] { return sphere_mesh({0, 0, 0}, 1, 24); };

TEST_F(Ball_source_3, GivenBallsComeBeforeThoseOfTheMesh) {
  set(Inputs().with(mesh_input, sphere()));
  const std::vector<Ball_3> of_mesh = balls();
  ASSERT_GT(of_mesh.size(), 20u);
  std::vector<Ball_3> expected = given;
  expected.insert(expected.end(), of_mesh.begin(), of_mesh.end());
  set(Inputs().with(mesh_input, sphere()).with(balls_input, given));
  EXPECT_EQ(balls(), expected);
  // Balls can be taken out again.
  set(Inputs().with(mesh_input, sphere()).with(balls_input, std::vector<Ball_3>()));
  EXPECT_EQ(balls(), of_mesh);
}

TEST_F(Ball_source_3, StructuresAreThoseOfAllBallsTogether) {
  const auto of_mesh = [&] {
    set(Inputs().with(mesh_input, sphere()));
    return balls();
  }();
  std::vector<Ball_3> all = given;
  all.insert(all.end(), of_mesh.begin(), of_mesh.end());
  const auto expected = std::make_shared<const Regular_3>(regular_triangulation(all, progress_));
  set(Inputs().with(mesh_input, sphere()).with(balls_input, given));
  const auto found = graph_.structure(regular_3_key, progress_).value;
  EXPECT_EQ(found->balls, all);
  EXPECT_EQ(edges_of(*found), edges_of(*expected));
  const auto dual = graph_.structure(dual_3_key, progress_).value;
  const Dual_3 expected_dual = dual_complex(expected, progress_);
  EXPECT_EQ(dual->vertices, expected_dual.vertices);
  // The sphere with what sticks out of it, and a ball apart.
  EXPECT_EQ(topology(*dual).betti, (std::array<std::int64_t, 3>{2, 0, 0}));
  EXPECT_EQ(topology_of("medial-axis").betti, (std::array<std::int64_t, 3>{2, 0, 0}));
  // The ball inside is hidden by those around it or swallowed: nothing is singular there.
  EXPECT_EQ(dual->vertices[2], Simplex_kind_3::singular);
  EXPECT_NE(dual->vertices[0], Simplex_kind_3::outside);
}

TEST_F(Ball_source_3, TheSettingChoosesSome) {
  set(Inputs().with(mesh_input, sphere()));
  const std::vector<Ball_3> of_mesh = balls();
  const Inputs both = Inputs().with(mesh_input, sphere()).with(balls_input, given);
  set(both, "given");
  EXPECT_EQ(balls(), given);
  set(both, "computed");
  EXPECT_EQ(balls(), of_mesh);
  // Then also how far they are from the mesh is known.
  graph_.layer("balls", progress_);
  EXPECT_TRUE(graph_.measures().contains("hausdorff"));
  set(Inputs().with(mesh_input, sphere()), "given");
  EXPECT_TRUE(reason().starts_with("there are no given balls")) << reason();
}

TEST_F(Ball_source_3, AMeshThatBoundsNoSolidTakesNothingFromGivenBalls) {
  graph_.set_inputs(Inputs().with(mesh_input, sheet_mesh(3, 3)).with(balls_input, given));
  graph_.set_settings(Settings().with("repair", "off"));
  EXPECT_EQ(balls(), given);
  graph_.layer("balls", progress_);
  const std::vector<std::string> said = graph_.warnings("balls");
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(said[0].starts_with("Given balls alone: the mesh has none. ")) << said[0];
}

TEST_F(Ball_source_3, BesidePointsGivenBallsAreAlone) {
  std::vector<Point_3> cloud = sphere().vertices;
  set(Inputs().with(cloud_input, cloud).with(balls_input, given));
  EXPECT_EQ(balls(), given);
  set(Inputs().with(cloud_input, cloud).with(balls_input, given), "computed");
  EXPECT_GT(balls().size(), 0u);
  EXPECT_NE(balls(), given);
}

}  // namespace
}  // namespace mesecina::test
