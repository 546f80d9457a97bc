// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <limits>
#include <stdexcept>

#include "core/graph.h"
#include "core/registry.h"
#include "core/settings.h"

namespace mesecina {
namespace {

using testing::HasSubstr;

Setting_spec setting(std::string id, Setting_value value) {
  Setting_spec spec;
  spec.id = std::move(id);
  spec.default_value = std::move(value);
  return spec;
}

Layer_spec layer(std::string id) {
  Layer_spec spec;
  spec.id = std::move(id);
  spec.build = [](Context&) { return Primitive_set{}; };
  return spec;
}

TEST(Registry, rejects_duplicates_and_keeps_the_order) {
  Registry registry;
  EXPECT_ANY_THROW(registry.add_layer(layer("homeless")));
  EXPECT_ANY_THROW(registry.add_setting(setting("homeless", 1.0)));
  registry.begin_module({"first", "First", ""});
  registry.add_layer(layer("zebra"));
  registry.add_layer(layer("ant"));
  registry.add_setting(setting("limit", 1.0));
  registry.add_structure<int>(Key<int>{"number"}, [](Context&) { return 1; });
  EXPECT_ANY_THROW(registry.add_layer(layer("zebra")));
  EXPECT_ANY_THROW(registry.add_setting(setting("limit", 2.0)));
  EXPECT_ANY_THROW(registry.add_structure<double>(Key<double>{"number"}, [](Context&) { return 1.0; }));
  registry.begin_module({"second", "Second", ""});
  registry.add_layer(layer("limit"));
  registry.add_setting(setting("other", false));
  ASSERT_EQ(registry.layers().size(), 3U);
  EXPECT_EQ(registry.layers()[0].id, "zebra");
  EXPECT_EQ(registry.layers()[1].id, "ant");
  EXPECT_EQ(registry.settings().size(), 2U);
  EXPECT_EQ(registry.structures().size(), 1U);
  EXPECT_EQ(registry.module_of("ant")->id, "first");
  EXPECT_EQ(registry.module_of("other")->id, "second");
  EXPECT_EQ(registry.module_of("nothing"), nullptr);
  EXPECT_EQ(registry.find_layer("nothing"), nullptr);
  EXPECT_EQ(registry.find_layer("ant")->id, "ant");
  EXPECT_EQ(registry.find_setting("nothing"), nullptr);
  EXPECT_EQ(registry.find_structure("number")->id, "number");
}

TEST(Registry, refuses_a_default_outside_of_its_range) {
  Registry registry;
  registry.begin_module({"module", "", ""});
  Setting_spec spec = setting("limit", 5.0);
  spec.maximum = 4;
  EXPECT_THROW(registry.add_setting(spec), std::invalid_argument);
}

TEST(Registry, gives_values_and_cuts) {
  Registry registry;
  registry.begin_module({"module", "", ""});
  registry.add_setting(setting("limit", 0.5));
  registry.add_setting(setting("count", std::int64_t{3}));
  Layer_spec cut_layer = layer("cut");
  cut_layer.cut_value = "angle";
  cut_layer.cut_setting = "limit";
  registry.add_layer(cut_layer);
  cut_layer.id = "cut-by-integer";
  cut_layer.cut_setting = "count";
  registry.add_layer(cut_layer);
  registry.add_layer(layer("plain"));
  EXPECT_EQ(std::get<double>(registry.value({}, "limit")), 0.5);
  const Settings changed = Settings{}.with("limit", 0.75);
  EXPECT_EQ(std::get<double>(registry.value(changed, "limit")), 0.75);
  EXPECT_THROW(registry.value({}, "nothing"), std::out_of_range);
  EXPECT_EQ(registry.cut(registry.layers()[0], {}), (Cut{"angle", 0.5}));
  EXPECT_EQ(registry.cut(registry.layers()[0], changed), (Cut{"angle", 0.75}));
  EXPECT_EQ(registry.cut(registry.layers()[1], changed), (Cut{"angle", 3}));
  EXPECT_EQ(registry.cut(registry.layers()[2], changed), std::nullopt);
}

TEST(Nearest_name, finds_misspellings_only) {
  const std::vector<std::string> names{"delaunay", "voronoi", "medial-axis", "crust", "samples"};
  EXPECT_EQ(nearest_name("delauney", names), "delaunay");
  EXPECT_EQ(nearest_name("vornoi", names), "voronoi");
  EXPECT_EQ(nearest_name("medial_axis", names), "medial-axis");
  EXPECT_EQ(nearest_name("curst", names), "crust");
  EXPECT_EQ(nearest_name("crust", names), "crust");
  EXPECT_EQ(nearest_name("photosynthesis", names), "");
  EXPECT_EQ(nearest_name("anything", {}), "");
}

void expect_refused(const Setting_spec& spec, const std::string& text) {
  try {
    parse_setting(spec, text);
    FAIL() << "'" << text << "' was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr(spec.id));
    EXPECT_THAT(error.what(), HasSubstr("'" + text + "'"));
  }
}

TEST(Parse_setting, numbers) {
  Setting_spec spec = setting("angle", 30.0);
  spec.minimum = 0;
  spec.maximum = 180;
  EXPECT_EQ(std::get<double>(parse_setting(spec, "45.5")), 45.5);
  EXPECT_EQ(std::get<double>(parse_setting(spec, "0")), 0);
  EXPECT_EQ(std::get<double>(parse_setting(spec, "1.8e2")), 180);
  for (const char* text : {"", " ", "-1", "180.1", "abc", "12x", "1,5", "nan", "inf", "0x10", "1 2"})
    expect_refused(spec, text);
}

TEST(Parse_setting, numbers_in_a_decimal_comma_locale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "there is no locale de_DE.UTF-8 here";
  EXPECT_EQ(std::get<double>(parse_setting(setting("angle", 30.0), "45.5")), 45.5);
  EXPECT_EQ(to_text(Setting_value(0.5)), "0.5");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Parse_setting, integers) {
  Setting_spec spec = setting("count", std::int64_t{3});
  spec.minimum = 1;
  spec.maximum = 1000;
  EXPECT_EQ(std::get<std::int64_t>(parse_setting(spec, "17")), 17);
  for (const char* text : {"", "0", "1001", "1.5", "seven", "99999999999999999999"}) expect_refused(spec, text);
}

TEST(Parse_setting, flags_and_texts) {
  const Setting_spec flag = setting("flag", false);
  EXPECT_EQ(std::get<bool>(parse_setting(flag, "true")), true);
  EXPECT_EQ(std::get<bool>(parse_setting(flag, "false")), false);
  for (const char* text : {"", "maybe", "2"}) expect_refused(flag, text);
  const Setting_spec free_text = setting("name", std::string("x"));
  EXPECT_EQ(std::get<std::string>(parse_setting(free_text, "any text")), "any text");
  Setting_spec choice = setting("kind", std::string("plain"));
  choice.choices = {"plain", "preserving"};
  EXPECT_EQ(std::get<std::string>(parse_setting(choice, "preserving")), "preserving");
  expect_refused(choice, "plains");
}

TEST(Parse_setting, reads_what_to_text_writes) {
  for (const double value : {0.1, 1e-300, 1.7976931348623157e308, -0.0, 123456789.0, 1.0 / 3}) {
    const Setting_spec spec = setting("number", 0.0);
    EXPECT_EQ(std::get<double>(parse_setting(spec, to_text(Setting_value(value)))), value);
  }
  const std::int64_t least = std::numeric_limits<std::int64_t>::min();
  EXPECT_EQ(std::get<std::int64_t>(parse_setting(setting("n", std::int64_t{0}), to_text(Setting_value(least)))), least);
  EXPECT_EQ(to_text(Setting_value(true)), "true");
}

TEST(Check_setting, refuses_other_types) {
  EXPECT_THROW(check_setting(setting("number", 0.0), std::int64_t{1}), std::invalid_argument);
  EXPECT_THROW(check_setting(setting("number", 0.0), std::string("1")), std::invalid_argument);
  EXPECT_THROW(check_setting(setting("number", 0.0), std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_NO_THROW(check_setting(setting("number", 0.0), -1e300));
}

}  // namespace
}  // namespace mesecina
