// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "layers/layer_list.h"

namespace mesecina {
namespace {

TEST(Layer_list, holds_every_layer_of_the_registry_in_order) {
  Registry registry;
  registry.begin_module({"module", "Module", "Help."});
  for (const char* id : {"points", "crust", "axis"}) {
    Layer_spec spec;
    spec.id = id;
    spec.label = id;
    spec.style.visible = spec.id == "crust";
    registry.add_layer(spec);
  }
  Layer_list layers = default_layers(registry);
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0].id, "points");
  EXPECT_EQ(layers[2].id, "axis");
  EXPECT_TRUE(layers[1].style.visible);
  ASSERT_NE(find_entry(layers, "axis"), nullptr);
  find_entry(layers, "axis")->style.opacity = 0.5;
  EXPECT_EQ(layers[2].style.opacity, 0.5);
  EXPECT_EQ(find_entry(layers, "no such layer"), nullptr);
}

}  // namespace
}  // namespace mesecina
