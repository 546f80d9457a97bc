// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "evolving.h"
#include "geometries/balls_2/module.h"
#include "geometries/modules_2.h"
#include "geometries/modules_3.h"

namespace mesecina {
namespace {

using Names = std::set<std::string>;

Names fit_for(const Registry& registry, const Evolution_state& state) {
  Names names;
  for (const Evolution_spec& evolution : registry.evolutions())
    if (why_unfit(evolution, state).empty()) names.insert(evolution.id);
  return names;
}

Inputs disks() { return Inputs().with(disks_input, std::vector<Disk_2>{{{0, 0}, 2}, {{3, 0}, 2}}); }
Inputs square() { return Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}); }
Inputs square_outline() { return Inputs().with(outline_input, Outline_2{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}}); }
Inputs tetrahedron() {
  return Inputs().with(mesh_input, Triangle_mesh_3{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}});
}
Inputs balls() { return Inputs().with(balls_input, std::vector<Ball_3>{{{0, 0, 0}, 1}, {{1, 0, 0}, 1}}); }
Inputs cloud() {
  return Inputs().with(cloud_input, std::vector<Point_3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
}

TEST(Evolution_needs, OfThePlaneAreWhatEachWorksOn) {
  const auto registry = make_registry_2();
  const Names on_curves{"laplacian-smoothing", "subdivision", "noise"};
  const Names of_disks{"noise", "grow-balls", "shrink-balls", "stepped-growing", "landmark-disks"};
  EXPECT_EQ(fit_for(*registry, {}), Names{});
  EXPECT_EQ(fit_for(*registry, {disks(), {}}), of_disks);
  Names of_outlines = of_disks;
  of_outlines.insert(on_curves.begin(), on_curves.end());
  of_outlines.insert("max-min-landmarks");
  EXPECT_EQ(fit_for(*registry, {square_outline(), {}}), of_outlines);
  Names of_points = of_outlines;
  of_points.insert("lloyd");
  EXPECT_EQ(fit_for(*registry, {square(), {}}), of_points);
  const Inputs two = Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {1, 0}});
  EXPECT_EQ(fit_for(*registry, {two, {}}).count("laplacian-smoothing"), 0u) << "two points are no curve";
  EXPECT_EQ(fit_for(*registry, {two, {}}).count("lloyd"), 1u);
}

TEST(Evolution_needs, OfDisksGoByTheSettingThatSaysWhich) {
  const auto registry = make_registry_2();
  const Evolution_spec& growing = *registry->find_evolution("grow-balls");
  const auto with_source = [](std::string_view name) {
    return Settings().with(ball_source_setting.id, std::string(name));
  };
  EXPECT_THAT(why_unfit(growing, {square(), with_source(ball_source_drawn)}), testing::HasSubstr("no disks"));
  EXPECT_EQ(why_unfit(growing, {square(), with_source(ball_source_inner_poles)}), "");
  EXPECT_THAT(why_unfit(growing, {disks(), with_source(ball_source_inner_voronoi)}),
              testing::HasSubstr("no points or outline"));
  EXPECT_EQ(why_unfit(growing, {disks(), with_source(ball_source_drawn)}), "");
}

TEST(Evolution_needs, OfSpaceAreWhatEachWorksOn) {
  const auto registry = make_registry_3();
  const Names of_balls{"noise", "grow-balls", "shrink-balls", "stepped-growing"};
  Names of_meshes = of_balls;
  of_meshes.insert("laplacian-smoothing");
  EXPECT_EQ(fit_for(*registry, {}), Names{});
  EXPECT_EQ(fit_for(*registry, {balls(), {}}), of_balls);
  EXPECT_EQ(fit_for(*registry, {cloud(), {}}), of_balls);
  EXPECT_EQ(fit_for(*registry, {tetrahedron(), {}}), of_meshes);
  const Settings computed = Settings().with("ball-source", std::string("computed"));
  EXPECT_EQ(fit_for(*registry, {balls(), computed}), Names{"noise"});
  const Settings given = Settings().with("ball-source", std::string("given"));
  EXPECT_EQ(fit_for(*registry, {cloud(), given}), Names{"noise"});
}

TEST(Evolution_needs, AreSaidByAllAndAreTheReasonThatTheFirstStepGives) {
  const std::vector<Inputs> planar{{}, disks(), square(), square_outline()};
  const std::vector<Inputs> spatial{{}, balls(), cloud(), tetrahedron()};
  for (const auto& [registry, cases] : {std::pair(make_registry_2(), planar), std::pair(make_registry_3(), spatial)}) {
    for (const Evolution_spec& evolution : registry->evolutions()) {
      EXPECT_FALSE(evolution.needs.what.empty() || evolution.needs.what.ends_with('.')) << evolution.id;
      EXPECT_NE(evolution.needs.why_not, nullptr) << evolution.id;
      for (const Inputs& inputs : cases) {
        const std::string reason = why_unfit(evolution, {inputs, {}});
        if (reason.empty()) continue;
        EXPECT_EQ(test::run_steps(registry, inputs, evolution.id, 1).result.end_reason, reason) << evolution.id;
      }
    }
  }
}

TEST(Evolution_needs, AnEvolutionThatSaysNothingStartsFromAnything) { EXPECT_EQ(why_unfit({}, {}), ""); }

}  // namespace
}  // namespace mesecina
