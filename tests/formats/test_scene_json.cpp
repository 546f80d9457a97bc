// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/batch/style_option.h"
#include "core/formats/scene_json.h"

namespace mesecina {
namespace {

using Json = nlohmann::json;

Registry small_registry() {
  Registry registry;
  registry.begin_module({"module", "Module", "For tests."});
  for (const char* id : {"points", "edges", "faces"}) {
    Layer_spec layer;
    layer.id = id;
    layer.style.visible = true;
    registry.add_layer(layer);
  }
  registry.add_setting({"limit", "Limit", "", "", 0.5, 0, 1, {}, {}});
  registry.add_setting({"count", "Count", "", "", std::int64_t{3}, 0, 1e18, {}, {}});
  registry.add_setting({"exact", "Exact", "", "", true, 0, 0, {}, {}});
  registry.add_setting({"kind", "Kind", "", "", std::string("a"), 0, 0, {"a", "b"}, {}});
  return registry;
}

/// A look in which every property differs from the usual one.
Style unusual_style() {
  Style style;
  style.color = {1, 0xab, 0xff};
  style.opacity = 0.1 + 0.2;
  style.point_size = 1.0 / 3;
  style.line_width = 5e-324;
  style.filled = style.edges = style.vertices = style.smooth = true;
  style.sliced = false;
  style.value = "angle \"\n";
  style.color_map = "cividis";
  style.color_map_reversed = true;
  style.range_minimum = -std::numeric_limits<double>::infinity();
  style.range_maximum = std::nextafter(1.0, 2.0);
  style.threshold_minimum = -0.0;
  style.threshold_maximum = 1.7976931348623157e308;
  return style;
}

template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Scene_json, EveryPropertyOfALookComesBackAsItWas) {
  Unknown_parts unknown;
  const Style style = unusual_style();
  const Json json = Json::parse(style_to_json(style).dump());
  const Style read = style_from_json(json, Style{}, "style", unknown);
  EXPECT_EQ(read, style);
  EXPECT_TRUE(std::signbit(*read.threshold_minimum));
  EXPECT_TRUE(unknown.notes.empty());
}

TEST(Scene_json, LooksNameThePropertiesOfTheCommandLine) {
  std::vector<std::string> names = style_properties();
  std::ranges::sort(names);
  const auto keys = [](const Json& json) {
    std::vector<std::string> list;
    for (const auto& property : json.items()) list.push_back(property.key());
    return list;
  };
  EXPECT_EQ(keys(style_to_json(Style{})), names);
  EXPECT_EQ(keys(style_to_json(unusual_style(), Style{})), names) << "a property of the unusual look is usual";
  EXPECT_TRUE(style_to_json(Style{}, Style{}).empty());
}

TEST(Scene_json, PropertiesThatAreNotThereStayUsual) {
  Unknown_parts unknown;
  Style usual;
  usual.line_width = 4;
  usual.range_minimum = 1;
  const Style read = style_from_json(Json::parse(R"({"opacity": 0.5, "range-minimum": null})"), usual, "x", unknown);
  EXPECT_EQ(read.line_width, 4);
  EXPECT_EQ(read.opacity, 0.5);
  EXPECT_FALSE(read.range_minimum);
}

TEST(Scene_json, BadLooksAreRefusedWithPlaceExpectedAndFound) {
  Unknown_parts unknown;
  const auto read = [&](const char* text) {
    return refusal([&] { style_from_json(Json::parse(text), Style{}, "a[3].style", unknown); });
  };
  EXPECT_EQ(read("[]"), "a[3].style: expected an object with properties of a look, found []");
  EXPECT_EQ(read(R"({"opacity": 1.5})"), "a[3].style.opacity: expected a number from 0 to 1, found 1.5");
  EXPECT_EQ(read(R"({"opacity": "nan"})"), "a[3].style.opacity: expected a number from 0 to 1, found \"nan\"");
  EXPECT_EQ(read(R"({"line-width": -1})"), "a[3].style.line-width: expected a number from 0 to 100, found -1");
  EXPECT_EQ(read(R"({"filled": 1})"), "a[3].style.filled: expected true or false, found 1");
  EXPECT_EQ(read(R"({"value": null})"), "a[3].style.value: expected a text, found null");
  EXPECT_EQ(read(R"({"range-minimum": "x"})"),
            "a[3].style.range-minimum: expected a number, or null for none, found \"x\"");
  for (const char* color : {R"("#12345")", R"("123456")", R"("#12345g")", R"("#+12345")", R"("")", "5"})
    EXPECT_EQ(read(("{\"color\": " + std::string(color) + "}").c_str()),
              "a[3].style.color: expected a colour as \"#rrggbb\", found " + std::string(color));
  EXPECT_TRUE(unknown.notes.empty());
  EXPECT_EQ(read(R"({"opacty": 1})"), "nothing was thrown");
  ASSERT_EQ(unknown.notes.size(), 1U);
  EXPECT_EQ(unknown.notes[0], "a[3].style: there is no property 'opacty'; did you mean 'opacity'?");
}

TEST(Scene_json, SettingsComeBackWithTheirTypes) {
  const Registry registry = small_registry();
  const Settings settings = Settings()
                                .with("limit", 1.0)
                                .with("count", std::int64_t{9007199254740993})
                                .with("exact", false)
                                .with("kind", std::string("b"));
  Unknown_parts unknown;
  const Json json = Json::parse(settings_to_json(settings).dump());
  EXPECT_EQ(settings_from_json(json, registry, "settings", unknown), settings);
  EXPECT_EQ(settings_to_json(settings).dump(), R"({"count":9007199254740993,"exact":false,"kind":"b","limit":1.0})");
  // A number may be written without its decimal point.
  EXPECT_EQ(settings_from_json(Json::parse(R"({"limit": 1})"), registry, "s", unknown), Settings().with("limit", 1.0));
}

TEST(Scene_json, UnknownSettingsAreToldAndKept) {
  const Registry registry = small_registry();
  Unknown_parts unknown;
  const Json json = Json::parse(R"({"limit": 0.25, "limt": [1, 2.5], "z": null})");
  const Settings settings = settings_from_json(json, registry, "settings", unknown);
  EXPECT_EQ(settings, Settings().with("limit", 0.25));
  ASSERT_EQ(unknown.notes.size(), 2U);
  EXPECT_EQ(unknown.notes[0], "settings: there is no setting 'limt'; did you mean 'limit'?");
  EXPECT_EQ(settings_to_json(settings, unknown.settings), json);
}

TEST(Scene_json, BadSettingsAreRefused) {
  const Registry registry = small_registry();
  Unknown_parts unknown;
  const auto read = [&](const char* text) {
    return refusal([&] { settings_from_json(Json::parse(text), registry, "settings", unknown); });
  };
  EXPECT_EQ(read("5"), "settings: expected an object with values of settings, found 5");
  EXPECT_EQ(read(R"({"limit": true})"), "settings.limit: expected a number, found true");
  EXPECT_EQ(read(R"({"limit": 2})"), "settings.limit: setting limit: expected a number >= 0 and <= 1, found '2'");
  EXPECT_EQ(read(R"({"count": 2.5})"), "settings.count: expected an integer, found 2.5");
  EXPECT_EQ(read(R"({"exact": "yes"})"), "settings.exact: expected true or false, found \"yes\"");
  EXPECT_EQ(read(R"({"kind": "c"})"), "settings.kind: setting kind: expected one of a, b, found 'c'");
}

TEST(Scene_json, LayersComeBackInTheirOrder) {
  const Registry registry = small_registry();
  Layer_list layers{{"faces", unusual_style()}, {"points", Style{}}};
  layers[0].style.visible = true;
  Unknown_parts unknown;
  const Json json = Json::parse(layers_to_json(layers).dump());
  EXPECT_EQ(layers_from_json(json, registry, "layers", unknown), layers);
  EXPECT_TRUE(unknown.notes.empty());
}

TEST(Scene_json, UnknownLayersAreToldAndKept) {
  const Registry registry = small_registry();
  Unknown_parts unknown;
  const Json json = Json::parse(R"([{"id": "edgs", "style": {"magic": 1}}, {"id": "faces", "colour": "red"}])");
  const Layer_list layers = layers_from_json(json, registry, "layers", unknown);
  ASSERT_EQ(layers.size(), 1U);
  EXPECT_EQ(layers[0].id, "faces");
  EXPECT_TRUE(layers[0].style.visible);
  ASSERT_EQ(unknown.notes.size(), 2U);
  EXPECT_EQ(unknown.notes[0], "layers[0]: there is no layer 'edgs'; did you mean 'edges'?");
  EXPECT_EQ(unknown.notes[1], "layers[1]: 'colour' means nothing");
  EXPECT_EQ(layers_to_json(layers, unknown.layers)[1], json[0]);
}

TEST(Scene_json, BadLayersAreRefused) {
  const Registry registry = small_registry();
  Unknown_parts unknown;
  const auto read = [&](const char* text) {
    return refusal([&] { layers_from_json(Json::parse(text), registry, "layers", unknown); });
  };
  EXPECT_EQ(read("{}"), "layers: expected an array of layers, found {}");
  EXPECT_EQ(read("[1]"), "layers[0]: expected an object with the \"id\" of a layer, found 1");
  EXPECT_EQ(read("[{}]"), "layers[0].id: expected, found nothing");
  EXPECT_EQ(read(R"([{"id": 4}])"), "layers[0].id: expected a text, found 4");
  EXPECT_EQ(read(R"([{"id": "faces"}, {"id": "faces"}])"), "layers[1].id: expected each layer once, found \"faces\"");
  EXPECT_EQ(read(R"([{"id": "faces", "visible": 0}])"), "layers[0].visible: expected true or false, found 0");
}

TEST(Scene_json, MissingLayersFollowTheirNeighboursSwitchedOff) {
  const Registry registry = small_registry();
  const auto ids = [&](const Layer_list& listed) {
    std::string text;
    for (const Layer_entry& entry : with_missing_layers(listed, registry))
      text += entry.id + (entry.style.visible ? "+ " : "- ");
    return text;
  };
  Style on;
  on.visible = true;
  EXPECT_EQ(ids({}), "points- edges- faces- ");
  EXPECT_EQ(ids({{"faces", on}, {"points", on}}), "faces+ points+ edges- ");
  EXPECT_EQ(ids({{"edges", on}}), "points- edges+ faces- ");
}

TEST(Scene_json, ViewsComeBack) {
  const View_2 plane{{0.1, -1e-300}, 1.0 / 3};
  EXPECT_EQ(view_2_from_json(Json::parse(view_to_json(plane).dump()), "view"), plane);
  View_3 space;
  space.camera.position = {0.1, 2, 3};
  space.cutting_plane = Cutting_plane_3{{0, 1, 2}, {1, 1, 1}, 0.3};
  EXPECT_EQ(view_3_from_json(Json::parse(view_to_json(space).dump()), "view"), space);
  EXPECT_EQ(refusal([] { view_2_from_json(Json::parse(R"({"center": [1], "scale": 1})"), "view"); }),
            "view.center: expected two finite numbers [x, y], found [1]");
  EXPECT_EQ(refusal([] { view_2_from_json(Json::parse(R"({"center": [1, 2], "scale": 0})"), "view"); }),
            "view.scale: expected a positive number, found 0");
  EXPECT_EQ(refusal([] { view_3_from_json(Json::parse("{}"), "view"); }), "view: expected an object \"camera\"");
}

}  // namespace
}  // namespace mesecina
