// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

#include "core/bundle.h"
#include "core/graph.h"
#include "core/help_text.h"
#include "geometries/modules_2.h"
#include "geometries/modules_3.h"

namespace mesecina {
namespace {

/// Names and ids are there once, everything named is known, and the help names its source.
void check(const Registry& registry) {
  const std::vector<Bundle> bundles = shipped_bundles(registry);
  EXPECT_GE(bundles.size(), 12U);
  std::set<std::string> ids;
  for (const Bundle& bundle : bundles) {
    EXPECT_TRUE(bundle.unknown.notes.empty()) << bundle.name << ": " << bundle.unknown.notes.front();
    EXPECT_TRUE(ids.insert(bundle_id(bundle.name)).second) << bundle.name;
    EXPECT_FALSE(bundle.layers.empty()) << bundle.name;
    EXPECT_GT(bundle.help.size(), 20U) << bundle.name;
    const Arrangement arrangement = apply_bundle(bundle, registry, {Settings(), default_layers(registry)});
    EXPECT_EQ(arrangement.layers.size(), registry.layers().size()) << bundle.name;
    EXPECT_EQ(apply_bundle(bundle, registry, arrangement), arrangement) << bundle.name;
  }
}

/// Every bundle shows something that was computed from these inputs, or says what it needs.
void check_on(const std::shared_ptr<const Registry>& registry, const Inputs& inputs) {
  Graph graph(registry);
  graph.set_inputs(inputs);
  Progress progress;
  for (const Bundle& bundle : shipped_bundles(*registry)) {
    const Arrangement arrangement = apply_bundle(bundle, *registry, {Settings(), default_layers(*registry)});
    graph.set_settings(arrangement.settings);
    std::size_t elements = 0;
    std::string reasons;
    for (const Layer_entry& layer : bundle.layers) {
      const bool is_input = registry->find_layer(layer.id)->stage == "Input";
      const Outcome<Primitive_set> outcome = graph.layer(layer.id, progress);
      if (outcome.value && (!is_input || bundle_id(bundle.name).find("points") != std::string::npos))
        elements += outcome.value->element_count();
      reasons += layer.id + ": " + outcome.reason + "; ";
    }
    const std::string missing = missing_input_text(bundle.needs, inputs);
    EXPECT_EQ(elements == 0, !missing.empty()) << bundle.name << ": " << missing << " (" << reasons << ")";
  }
}

TEST(Shipped_bundles, ShowSomethingOrSayWhatTheyNeedInThePlane) {
  const auto registry = make_registry_2();
  std::vector<Point_2> points;
  Ring_2 ring;
  for (int i = 0; i < 60; ++i) {
    const double t = i * 0.1047;
    const double r = 10 + 2 * std::cos(3 * t + 0.2);
    points.push_back({1.5 * r * std::cos(t), r * std::sin(t)});
    ring.push_back(points.back());
  }
  check_on(registry, Inputs().with(points_input, points));
  check_on(registry, Inputs().with(outline_input, Outline_2{{ring}}));
  check_on(registry, Inputs().with(disks_input, std::vector<Disk_2>{{{0, 0}, 2}, {{3, 0}, 2}, {{1, 2}, 2}}));
}

TEST(Shipped_bundles, ShowSomethingOrSayWhatTheyNeedInSpace) {
  const auto registry = make_registry_3();
  // An ellipsoid, as points along a spiral.
  std::vector<Point_3> points;
  constexpr int count = 150;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - 2 * (i + 0.5) / count;
    const double r = std::sqrt(1 - z * z);
    points.push_back({3 * r * std::cos(2.4 * i), 2 * r * std::sin(2.4 * i), z});
  }
  check_on(registry, Inputs().with(cloud_input, points));
  check_on(registry, Inputs().with(balls_input, std::vector<Ball_3>{{{0, 0, 0}, 2}, {{3, 0, 0}, 2}, {{1, 2, 0}, 2}}));
  const Triangle_mesh_3 octahedron{
      {{2, 0, 0}, {-2, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  check_on(registry, Inputs().with(mesh_input, octahedron));
}

/// What stands in braces is known, and what has a hyphen and is known stands in braces.
void check_helps(const Registry& registry) {
  const auto is_known = [&](const std::string& id) {
    return registry.find_setting(id) || registry.find_layer(id) || registry.find_evolution(id);
  };
  const auto check_help = [&](const std::string& of, const std::string& help) {
    static const std::regex word("\\{?[a-z0-9]+(-[a-z0-9]+)*\\}?");
    for (auto it = std::sregex_iterator(help.begin(), help.end(), word); it != std::sregex_iterator(); ++it) {
      const std::string text = it->str();
      const bool is_marked = text.front() == '{' && text.back() == '}';
      const std::string id = is_marked ? text.substr(1, text.size() - 2) : text;
      // A choice of a setting may be called like a layer.
      const bool is_setting = registry.find_setting(id) || registry.find_evolution(id);
      const bool is_bare = !is_marked && id.find('-') != std::string::npos;
      EXPECT_TRUE(!is_marked || is_known(id)) << of << ": " << text;
      EXPECT_FALSE(is_bare && is_setting) << of << ": " << text;
    }
    EXPECT_EQ(with_labels(help, registry).find('{'), std::string::npos) << of;
  };
  for (const Layer_spec& spec : registry.layers()) check_help(spec.id, spec.help);
  for (const Setting_spec& spec : registry.settings()) check_help(spec.id, spec.help);
  for (const Evolution_spec& spec : registry.evolutions()) check_help(spec.id, spec.help);
}

TEST(Helps, NameWhatThereIsInBracesInThePlane) { check_helps(*make_registry_2()); }
TEST(Helps, NameWhatThereIsInBracesInSpace) { check_helps(*make_registry_3()); }

TEST(Shipped_bundles, NameOnlyWhatThereIsInThePlane) { check(*make_registry_2()); }
TEST(Shipped_bundles, NameOnlyWhatThereIsInSpace) { check(*make_registry_3()); }

}  // namespace
}  // namespace mesecina
