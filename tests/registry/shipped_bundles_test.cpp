// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "core/bundle.h"
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

TEST(Shipped_bundles, NameOnlyWhatThereIsInThePlane) { check(*make_registry_2()); }
TEST(Shipped_bundles, NameOnlyWhatThereIsInSpace) { check(*make_registry_3()); }

}  // namespace
}  // namespace mesecina
