// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/batch/bundle_library.h"
#include "core/batch/bundle_option.h"
#include "core/bundle.h"

namespace mesecina {
namespace {

using Json = nlohmann::json;

Registry small_registry() {
  Registry registry;
  registry.begin_module({"module", "Module", "For tests."});
  for (const char* id : {"points", "edges", "faces", "axis"}) {
    Layer_spec layer;
    layer.id = id;
    layer.style.visible = layer.id == "points";
    if (layer.id == "axis") {
      layer.cut_value = "angle";
      layer.cut_setting = "limit";
    }
    registry.add_layer(layer);
  }
  registry.add_setting({"limit", "Limit", "", "", 0.5, 0, 1, {}, {}});
  registry.add_setting({"scale", "Scale", "", "", 1.2, 1, 9, {}, {}});
  return registry;
}

std::string text_of(const Layer_list& layers) {
  std::string text;
  for (const Layer_entry& layer : layers) text += layer.id + (layer.style.visible ? "+ " : "- ");
  return text;
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

std::vector<Bundle> parse(const std::string& text) { return parse_bundles(text, small_registry()); }

TEST(Bundle, IsReadAsItWasWritten) {
  Bundle bundle;
  bundle.name = "Größe \"1\"";
  bundle.help = "Help.";
  Style style;
  style.visible = true;
  style.opacity = 0.1;
  bundle.layers = {{"axis", style}, {"points", style}};
  bundle.settings = Settings().with("limit", 1.0 / 3);
  bundle.view = View_2{{0.1, 2}, 3};
  bundle.background = Canvas_background::dark;
  bundle.key = 7;
  bundle.needs = {"points", "outline"};
  const std::string text = bundles_to_text({bundle, bundle}, small_registry());
  EXPECT_EQ(parse(text), (std::vector<Bundle>{bundle, bundle}));
  EXPECT_EQ(bundles_to_text(parse(text), small_registry()), text);
}

TEST(Bundle, WhatIsUnknownIsToldAndWrittenAgain) {
  const std::string text = R"({"format": "mesecina-bundles", "version": 1, "bundles": [{"name": "A", "layers": [
      {"id": "points"}, {"id": "axs", "style": {"magic": 5}}], "settings": {"limt": 2}}]})";
  const std::vector<Bundle> bundles = parse(text);
  ASSERT_EQ(bundles.size(), 1U);
  ASSERT_EQ(bundles[0].unknown.notes.size(), 2U);
  EXPECT_EQ(bundles[0].unknown.notes[0], "bundles[0].layers[1]: there is no layer 'axs'; did you mean 'axis'?");
  EXPECT_EQ(bundles[0].unknown.notes[1], "bundles[0].settings: there is no setting 'limt'; did you mean 'limit'?");
  const Json again = Json::parse(bundles_to_text(bundles, small_registry()));
  EXPECT_EQ(again["bundles"][0]["layers"][1], Json::parse(R"({"id": "axs", "style": {"magic": 5}})"));
  EXPECT_EQ(again["bundles"][0]["settings"]["limt"], 2);
}

TEST(Bundle, FilesBeforeVersionOneAreRead) {
  EXPECT_EQ(parse(R"([{"name": "A"}, {"name": "B"}])").size(), 2U);
  EXPECT_EQ(parse(R"({"name": "A", "layers": [{"id": "axis"}]})")[0].layers.size(), 1U);
}

TEST(Bundle, OtherFilesAreRefused) {
  EXPECT_EQ(refusal([] { parse("{"); }),
            "line 1: expected JSON, found the end of the file at byte 1; the file is damaged or cut off");
  EXPECT_EQ(refusal([] { parse(std::string(200000, '[') + std::string(200000, ']')); }),
            "line 1: expected at most 500 lists and objects within each other, found more at byte 500; the file is "
            "damaged");
  EXPECT_EQ(refusal([] { parse("{}"); }),
            "the file: expected bundles: {\"format\": \"mesecina-bundles\", ...}, found {}");
  EXPECT_EQ(refusal([] { parse(R"({"format": "mesecina-bundles", "version": 2})"); }),
            "version: expected at most 1, as a newer program wrote this, found 2");
  EXPECT_EQ(refusal([] { parse(R"({"format": "mesecina-bundles", "version": 1, "dimension": 3, "bundles": []})"); }),
            "dimension: expected 2, for bundles of this program, found 3");
  EXPECT_EQ(refusal([] { parse(R"([{"help": ""}])"); }), "bundles[0].name: expected a text, found nothing");
  EXPECT_EQ(refusal([] { parse(R"([{"name": "A", "settings": {"limit": 7}}])"); }),
            "bundles[0].settings.limit: setting limit: expected a number >= 0 and <= 1, found '7'");
}

TEST(Bundle, SwitchesOffWhatItDoesNotHave) {
  const Registry registry = small_registry();
  const Bundle bundle = parse(R"([{"name": "A", "layers": [{"id": "axis"}, {"id": "edges", "style": {"opacity": 0.5}}],
      "settings": {"limit": 0.5}}])")[0];
  Arrangement before{Settings().with("limit", 0.25).with("scale", 2.0), default_layers(registry)};
  before.layers[2].style.opacity = 0.125;
  const Arrangement after = apply_bundle(bundle, registry, before);
  EXPECT_EQ(text_of(after.layers), "points- axis+ edges+ faces- ");
  EXPECT_EQ(find_entry(after.layers, "faces")->style.opacity, 0.125);
  EXPECT_EQ(find_entry(after.layers, "edges")->style.opacity, 0.5);
  // A default is no change; what the bundle does not name stays.
  EXPECT_EQ(after.settings, Settings().with("scale", 2.0));
  EXPECT_EQ(apply_bundle(bundle, registry, after), after);
}

TEST(Bundle, HoldsWhatIsSeenAndItsLimits) {
  const Registry registry = small_registry();
  Arrangement arrangement{Settings().with("scale", 2.0), default_layers(registry)};
  find_entry(arrangement.layers, "axis")->style.visible = true;
  const Bundle bundle = bundle_of(arrangement, registry, "Mine");
  EXPECT_EQ(text_of(bundle.layers), "points+ axis+ ");
  EXPECT_EQ(bundle.settings, Settings().with("scale", 2.0).with("limit", 0.5));
  EXPECT_EQ(apply_bundle(bundle, registry, arrangement), arrangement);
}

TEST(Bundle, IsFoundByNameAndId) {
  EXPECT_EQ(bundle_id("  Scale axis, s = 1.2!"), "scale-axis-s-1-2");
  std::vector<Bundle> bundles(2);
  bundles[0].name = "Scale axis";
  bundles[1].name = "Mine";
  EXPECT_EQ(find_bundle(bundles, "scale-axis"), bundles.data());
  EXPECT_EQ(find_bundle(bundles, "Scale axis"), bundles.data());
  EXPECT_EQ(find_bundle(bundles, "scale"), nullptr);
  EXPECT_EQ(free_name(bundles, "Mine"), "Mine 2");
  EXPECT_EQ(free_name(bundles, "Other"), "Other");
}

TEST(Bundle, WrongBackgroundsKeysAndNeedsAreRefused) {
  EXPECT_EQ(refusal([] { parse(R"([{"name": "A", "background": "pink"}])"); }),
            "bundles[0].background: expected \"paper\", \"dark\", \"window\" or \"none\", found \"pink\"");
  EXPECT_EQ(refusal([] { parse(R"([{"name": "A", "key": 10}])"); }),
            "bundles[0].key: expected a digit, 0 for no key, found 10");
  EXPECT_EQ(refusal([] { parse(R"([{"name": "A", "key": -1}])"); }),
            "bundles[0].key: expected a digit, 0 for no key, found -1");
  EXPECT_EQ(refusal([] { parse(R"([{"name": "A", "needs": "points"}])"); }),
            "bundles[0].needs: expected an array of inputs, found \"points\"");
  EXPECT_EQ(refusal([] { parse(R"([{"name": "A", "needs": [1]}])"); }), "bundles[0].needs: expected texts, found 1");
  for (const char* name : {"paper", "dark", "window", "none"})
    EXPECT_EQ(name_of(*parse(R"([{"name": "A", "background": ")" + std::string(name) + "\"}]")[0].background), name);
}

std::string keys_of(const std::vector<Bundle>& bundles) {
  std::string keys;
  for (std::size_t i = 0; i < bundles.size(); ++i) keys += std::to_string(key_of(bundles, i));
  return keys;
}

TEST(Bundle_keys, AreThoseOfThePlacesOrThoseThatAreGiven) {
  std::vector<Bundle> bundles(11);
  EXPECT_EQ(keys_of(bundles), "12345678900");
  EXPECT_EQ(place_with_key(bundles, 9), 8U);
  EXPECT_EQ(place_with_key(bundles, 0), std::nullopt);
  EXPECT_EQ(place_with_key(bundles, 10), std::nullopt);
  // The one in the third place loses its digit, all others keep theirs.
  give_key(bundles, 10, 3);
  EXPECT_EQ(keys_of(bundles), "12045678903");
  EXPECT_EQ(place_with_key(bundles, 3), 10U);
  give_key(bundles, 9, 3);
  EXPECT_EQ(keys_of(bundles), "12045678930");
  give_key(bundles, 9, std::nullopt);
  EXPECT_EQ(keys_of(bundles), "12345678900");
  // Without a key, also where the place has one.
  give_key(bundles, 0, 0);
  give_key(bundles, 1, 0);
  EXPECT_EQ(keys_of(bundles), "00345678900");
  EXPECT_EQ(place_with_key(bundles, 1), std::nullopt);
  // A bundle with a digit of its own does not answer to that of its place too.
  give_key(bundles, 2, 1);
  EXPECT_EQ(keys_of(bundles), "00145678900");
  bundles.resize(2);
  EXPECT_EQ(place_with_key(bundles, 4), std::nullopt);
}

TEST(Bundle_needs, SayWhatIsMissing) {
  const Inputs balls = Inputs().with(balls_input, std::vector<Ball_3>(1));
  EXPECT_EQ(missing_input_text({"cloud", "mesh"}, balls), "needs points or a mesh");
  EXPECT_EQ(missing_input_text({"points", "disks", "outline"}, balls), "needs points, disks or an outline");
  EXPECT_EQ(missing_input_text({"cloud", "balls"}, balls), "");
  EXPECT_EQ(missing_input_text({}, balls), "");
  EXPECT_EQ(missing_input_text({"mesh"}, Inputs()), "");
}

TEST(Canvas_background, DarkColorsAreLightenedOnDarkOnes) {
  const Color dark = canvas_color(Canvas_background::dark, light_window_color);
  EXPECT_EQ(canvas_color(Canvas_background::window, {1, 2, 3}), (Color{1, 2, 3}));
  EXPECT_EQ(canvas_color(Canvas_background::none, {1, 2, 3}), (Color{255, 255, 255}));
  EXPECT_EQ(visible_on(dark, {0, 0, 0}), (Color{255, 255, 255}));
  EXPECT_EQ(visible_on(dark, {0, 0, 80}), (Color{175, 175, 255}));
  EXPECT_EQ(visible_on(dark, {255, 128, 0}), (Color{255, 128, 0}));
  EXPECT_EQ(visible_on({255, 255, 255}, {0, 0, 0}), (Color{0, 0, 0}));
}

/// Gives an environment variable a value, null for none, as long as it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  ~Variable() { set(before_ ? before_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void set(const char* value) {
    if (value)
      setenv(name_, value, 1);
    else
      unsetenv(name_);
  }
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Bundle_library, TheListIsWhereTheSystemKeepsData) {
  const Variable home("HOME", "/home/somebody");
  {
    const Variable data("XDG_DATA_HOME", "/data");
    EXPECT_EQ(user_bundle_file("mesecina2d"), "/data/mesecina/mesecina2d-bundles.json");
  }
  for (const char* nothing : {static_cast<const char*>(nullptr), "", "relative"}) {
    const Variable data("XDG_DATA_HOME", nothing);
    EXPECT_EQ(user_bundle_file("mesecina3d"), "/home/somebody/.local/share/mesecina/mesecina3d-bundles.json");
  }
  const Variable data("XDG_DATA_HOME", nullptr);
  const Variable none("HOME", nullptr);
  EXPECT_EQ(user_bundle_file("mesecina2d"), "");
}

}  // namespace
}  // namespace mesecina
