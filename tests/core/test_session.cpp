// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/formats/input_json.h"
#include "core/session_formats.h"

namespace mesecina {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const double nasty[] = {0.0,
                        -0.0,
                        0.1,
                        1.0 / 3.0,
                        -1e-308,
                        std::numeric_limits<double>::denorm_min(),
                        std::numeric_limits<double>::max(),
                        std::numeric_limits<double>::lowest(),
                        std::nextafter(1.0, 2.0),
                        9007199254740993.0,
                        123456789012345678.0,
                        1e22,
                        5e-324,
                        -17.0};

Registry registry_of(int dimension) {
  Registry registry(dimension);
  registry.begin_module({"test", "Test", ""});
  registry.add_setting({"factor", "Factor", "", "", 1.5, 0, 100, {}, {}});
  registry.add_setting({"steps", "Steps", "", "", std::int64_t{3}, 0, 10, {}, {}});
  registry.add_setting({"is-on", "On", "", "", true, {}, {}, {}, {}});
  registry.add_setting({"kind", "Kind", "", "", std::string("a"), 0, 0, {"a", "b"}, {}});
  for (const char* id : {"points", "axis"}) registry.add_layer({id, id, "Input", "", {}, {}, "", "", "", "", {}});
  return registry;
}

/// Equal to the last bit.
bool is_same(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

Session full_session() {
  Session session;
  session.title = "a \"title\" with > < & \xc3\xbc";
  session.file = "/somewhere/points.xy";
  session.is_modified = true;
  std::vector<Point_2> points;
  std::vector<Disk_2> disks;
  for (const double x : nasty) {
    points.push_back({x, -x});
    disks.push_back({{x, 1 / 3.0}, std::abs(x)});
  }
  Outline_2 outline{{{{0, 0}, {1, 0}, {0, 1}}, {}, {{0.1, 0.2}, {0.3, 1e-300}, {-0.0, 7}}}};
  Image image{2, 3, {}, {-1.5, 0.1}, 0.3};
  for (int i = 0; i < 24; ++i) image.rgba.push_back(static_cast<std::uint8_t>(11 * i));
  session.inputs = Inputs()
                       .with(points_input, points)
                       .with(disks_input, disks)
                       .with(outline_input, outline)
                       .with(image_input, image);
  session.settings = Settings()
                         .with("factor", 0.1 + 0.2)
                         .with("steps", std::int64_t{7})
                         .with("is-on", false)
                         .with("kind", std::string("b"));
  Style style;
  style.visible = true;
  style.color = {1, 127, 255};
  style.opacity = 0.1;
  style.point_size = 1.0 / 3;
  style.filled = style.edges = style.vertices = style.smooth = true;
  style.sliced = false;
  style.value = "lambda";
  style.color_map = "magma";
  style.color_map_reversed = true;
  style.range_minimum = -0.0;
  style.range_maximum = std::numeric_limits<double>::infinity();
  style.threshold_minimum = 1e-310;
  session.layers = {{"axis", style}, {"points", {}}};
  session.view_2 = View_2{{0.1, -1e-17}, 1e9 / 7};
  session.width = 800.5;
  session.height = 600;
  session.bundle = Session::Bundle_name{"My \"bundle\"", true};
  session.background = Canvas_background::dark;
  session.film = Film_wish{Film_wish::Source::animation,
                           "/films/a b.webm",
                           641,
                           481,
                           0.1 + 0.2,
                           true,
                           {{"factor", 0.1, 1.0 / 3, 7, Sweep::Easing::smooth, true}, {"steps", 1, 9, 5}},
                           77};
  return session;
}

std::string message_of(const std::string& text, const Registry& registry) {
  try {
    parse_session(text, registry);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Session_test, plane_reads_back_to_the_last_bit) {
  const Session session = full_session();
  const Registry registry = registry_of(2);
  const std::string text = to_json(session);
  const Session back = parse_session(text, registry);
  EXPECT_THAT(back.unknown.parts.notes, IsEmpty());
  EXPECT_EQ(back.title, session.title);
  EXPECT_EQ(back.file, session.file);
  EXPECT_TRUE(back.is_modified);
  EXPECT_EQ(back.settings, session.settings);
  EXPECT_EQ(back.layers, session.layers);
  EXPECT_TRUE(std::signbit(*back.layers[0].style.range_minimum));
  EXPECT_EQ(back.view_2, session.view_2);
  EXPECT_EQ(back.width, session.width);
  EXPECT_EQ(back.bundle, session.bundle);
  EXPECT_EQ(back.background, session.background);
  EXPECT_EQ(back.film, session.film);
  const auto points = back.inputs.get(points_input);
  const auto disks = back.inputs.get(disks_input);
  ASSERT_EQ(points->size(), std::size(nasty));
  for (std::size_t i = 0; i < std::size(nasty); ++i) {
    EXPECT_TRUE(is_same((*points)[i].x, nasty[i])) << nasty[i];
    EXPECT_TRUE(is_same((*points)[i].y, -nasty[i])) << nasty[i];
    EXPECT_TRUE(is_same((*disks)[i].radius, std::abs(nasty[i]))) << nasty[i];
  }
  EXPECT_EQ(*back.inputs.get(outline_input), *session.inputs.get(outline_input));
  const auto image = back.inputs.get(image_input);
  EXPECT_EQ(image->rgba, session.inputs.get(image_input)->rgba);
  EXPECT_EQ(image->lower_left, (Point_2{-1.5, 0.1}));
  EXPECT_EQ(image->pixel_size, 0.3);
  EXPECT_EQ(to_json(back), text);
  for (const char c : text) EXPECT_TRUE(static_cast<unsigned char>(c) < 128);
}

TEST(Session_test, space_reads_back) {
  Session session;
  session.dimension = 3;
  Triangle_mesh_3 mesh{{{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}, {0, 0, -0.0}}, {{0, 1, 2}, {3, 2, 1}}};
  session.inputs = Inputs()
                       .with(mesh_input, mesh)
                       .with(balls_input, std::vector<Ball_3>{{{0.1, 0.2, 0.3}, 1e-5}})
                       .with(cloud_input, std::vector<Point_3>{{1, 2, 3}, {-0.1, 5e-324, 1e300}});
  session.view_3 = View_3{{{1, 2, 3}, {0.1, 0, 0}, {0, 0, 1}, Camera_3::Projection::perspective, 33.3, 2},
                          Cutting_plane_3{{0, 0, 0.1}, {1, 1, 0}, 0.25}};
  session.camera_path = {session.view_3->camera, session.view_3->camera};
  const Session back = parse_session(to_json(session), registry_of(3));
  EXPECT_EQ(*back.inputs.get(mesh_input), mesh);
  EXPECT_EQ(*back.inputs.get(balls_input), *session.inputs.get(balls_input));
  EXPECT_EQ(*back.inputs.get(cloud_input), *session.inputs.get(cloud_input));
  EXPECT_EQ(back.view_3, session.view_3);
  EXPECT_EQ(back.camera_path, session.camera_path);
}

TEST(Session_test, numbers_that_are_none_read_back) {
  Session session;
  const double infinity = std::numeric_limits<double>::infinity();
  session.inputs = Inputs().with(points_input, std::vector<Point_2>{{infinity, -infinity}, {std::nan(""), 1}});
  const Session back = parse_session(to_json(session), registry_of(2));
  const auto points = back.inputs.get(points_input);
  EXPECT_EQ((*points)[0], (Point_2{infinity, -infinity}));
  EXPECT_TRUE(std::isnan((*points)[1].x));
}

TEST(Session_test, what_is_unknown_is_kept) {
  const Registry registry = registry_of(2);
  auto json = nlohmann::json::parse(to_json(full_session()));
  json["settings"]["later"] = 5;
  json["inputs"]["surfaces"] = {1, 2, 3};
  json["layers"].push_back({{"id", "later-layer"}, {"visible", true}, {"style", {{"glow", 3}}}});
  json["music"] = {{"loud", true}};
  json["recording"]["sound"] = "waves";
  json["recording"]["sweeps"].push_back("later=1:2:3");
  const Session read = parse_session(json.dump(), registry);
  EXPECT_THAT(read.unknown.parts.notes, testing::SizeIs(6));
  EXPECT_THAT(read.unknown.parts.notes, testing::Contains(HasSubstr("recording.sweeps: ")));
  EXPECT_EQ(read.film, full_session().film);
  EXPECT_THAT(read.unknown.parts.notes, testing::Contains(HasSubstr("later-layer")));
  EXPECT_EQ(read.layers.size(), 2u);
  const auto again = nlohmann::json::parse(to_json(read));
  EXPECT_EQ(again, json);
  EXPECT_EQ(to_json(parse_session(again.dump(), registry)), to_json(read));
}

TEST(Session_test, files_of_earlier_versions_read_without_bundle_background_and_film) {
  const Registry registry = registry_of(2);
  auto json = nlohmann::json::parse(to_json(full_session()));
  json.erase("bundle");
  json.erase("background");
  json.erase("recording");
  const Session read = parse_session(json.dump(), registry);
  EXPECT_THAT(read.unknown.parts.notes, IsEmpty());
  EXPECT_EQ(read.bundle, std::nullopt);
  EXPECT_EQ(read.background, std::nullopt);
  EXPECT_EQ(read.film, std::nullopt);
  EXPECT_EQ(nlohmann::json::parse(to_json(read)), json);
}

TEST(Session_test, a_film_that_says_little_is_as_usual) {
  const Registry registry = registry_of(2);
  auto json = nlohmann::json::parse(to_json(full_session()));
  json["recording"] = {{"file", "x.mp4"}};
  Film_wish usual;
  usual.file = "x.mp4";
  EXPECT_EQ(parse_session(json.dump(), registry).film, usual);
  json["recording"] = {{"source", "dreams"}, {"turntable", 5}};
  const Session read = parse_session(json.dump(), registry);
  EXPECT_THAT(read.unknown.parts.notes, ElementsAre(HasSubstr("cannot record 'dreams'")));
  EXPECT_EQ(read.film->source, Film_wish::Source::changes);
  EXPECT_EQ(read.film->turntable, 5);
}

TEST(Session_test, inputs_of_other_names_are_written_by_their_type) {
  constexpr Input_key<std::vector<Point_2>> chosen_input{"landmarks"};
  constexpr Input_key<std::vector<Ball_3>> seen_input{"seen-balls"};
  constexpr Input_key<int> strange_input{"strange"};
  Session session;
  session.inputs = Inputs()
                       .with(chosen_input, std::vector<Point_2>{{0.1, 1}, {2, 3}})
                       .with(seen_input, std::vector<Ball_3>{{{1, 2, 3}, 4}})
                       .with(strange_input, 3);
  EXPECT_THAT(without_form(session.inputs), ElementsAre("strange"));
  const Session back = parse_session(to_json(session), registry_of(2));
  ASSERT_NE(back.inputs.get(chosen_input), nullptr);
  EXPECT_EQ(*back.inputs.get(chosen_input), *session.inputs.get(chosen_input));
  EXPECT_EQ(*back.inputs.get(seen_input), *session.inputs.get(seen_input));
  EXPECT_EQ(back.inputs.ids().size(), 2u);
}

TEST(Session_test, steps_share_the_inputs_that_they_shared) {
  Session session;
  const Inputs start = Inputs()
                           .with(points_input, std::vector<Point_2>{{0.1, 0.2}})
                           .with(outline_input, Outline_2{{{{0, 0}, {1, 0}, {0, 1}}}});
  const Inputs next = start.with(points_input, std::vector<Point_2>{{0.3, 0.4}});
  const Inputs last = next.with(points_input, std::vector<Point_2>{{0.5, 0.6}});
  session.steps = {{start, {{"factor", std::nullopt}}, "", 0},
                   {next, {{"factor", 2.5}}, "smooth", 1},
                   {last, {{"factor", 3.0}}, "smooth", 2}};
  session.position = 1;
  session.step_settings = {"kind", "steps"};
  session.inputs = next;
  const std::string text = to_json(session);
  const Session back = parse_session(text, registry_of(2));
  ASSERT_EQ(back.steps.size(), 3u);
  EXPECT_EQ(back.position, 1u);
  EXPECT_EQ(back.step_settings, session.step_settings);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(*back.steps[i].inputs.get(points_input), *session.steps[i].inputs.get(points_input));
    EXPECT_EQ(back.steps[i].inputs.get(outline_input), back.inputs.get(outline_input));
    EXPECT_EQ(back.steps[i].settings, session.steps[i].settings);
    EXPECT_EQ(back.steps[i].evolution, session.steps[i].evolution);
    EXPECT_EQ(back.steps[i].number, session.steps[i].number);
  }
  EXPECT_TRUE(back.steps[1].inputs == back.inputs);
  EXPECT_EQ(to_json(back), text);
  auto json = nlohmann::json::parse(text);
  json["evolution"]["steps"][0]["inputs"]["points"] = {{"same-as", 2}};
  EXPECT_THAT(message_of(json.dump(), registry_of(2)), HasSubstr("evolution.steps[0].inputs.points: expected"));
  json = nlohmann::json::parse(text);
  json["evolution"]["position"] = 3;
  EXPECT_THAT(message_of(json.dump(), registry_of(2)), HasSubstr("evolution.position: expected the number of a step"));
}

TEST(Session_test, damaged_text_is_refused_with_its_line) {
  const Registry registry = registry_of(2);
  const std::string text = to_json(full_session());
  EXPECT_THAT(message_of(text.substr(0, text.size() / 2), registry), HasSubstr("the file is damaged or cut off"));
  const auto with_deep_member = [](std::size_t levels) {
    return R"({"format": "mesecina-session", "version": 1, "dimension": 2, "title": "[[\"[",)"
           "\n\"later\": " +
           std::string(levels, '[') + std::string(levels, ']') + "}";
  };
  EXPECT_NO_THROW(parse_session(with_deep_member(499), registry));
  EXPECT_THAT(message_of(with_deep_member(500), registry), HasSubstr("line 2: expected at most 500 lists"));
  EXPECT_THAT(message_of(with_deep_member(200000), registry), HasSubstr("line 2: expected at most 500 lists"));
  EXPECT_THAT(message_of("{\n\"format\": \"mesecina-session\",\n\"version\": 1,\n!", registry),
              HasSubstr("line 4: expected JSON, found '!'"));
  EXPECT_THAT(message_of("", registry), HasSubstr("the end of the file"));
  // No part of a text is taken for the whole.
  for (std::size_t length = 0; length + 3 < text.size(); length += 97)
    EXPECT_NE(message_of(text.substr(0, length), registry), "none") << length;
}

TEST(Session_test, wrong_parts_are_refused_with_their_place) {
  const Registry registry = registry_of(2);
  const auto with = [&](const std::string& pointer, nlohmann::json value) {
    auto json = nlohmann::json::parse(to_json(full_session()));
    json[nlohmann::json::json_pointer(pointer)] = std::move(value);
    return message_of(json.dump(), registry);
  };
  EXPECT_THAT(with("/format", "other"), HasSubstr("expected a session"));
  EXPECT_THAT(with("/version", 2), HasSubstr("found version 2; open it with a newer Mesecina"));
  EXPECT_THAT(with("/version", 0), HasSubstr("expected a \"version\" from 1"));
  EXPECT_THAT(with("/dimension", 3), HasSubstr("one of mesecina3d; open it with that program"));
  EXPECT_THAT(with("/inputs/points/5", "five"), HasSubstr("inputs.points[5]: expected a number, found '\"five\"'"));
  EXPECT_THAT(with("/inputs/points", {1, 2, 3}), HasSubstr("2 per element, found a list of 3"));
  EXPECT_THAT(with("/inputs/image/width", 5), HasSubstr("inputs.image.rgba: expected 60 bytes"));
  EXPECT_THAT(with("/inputs/image/rgba", "????"), HasSubstr("expected base 64"));
  EXPECT_THAT(with("/settings/factor", 1000), HasSubstr("settings.factor: "));
  EXPECT_THAT(with("/settings/is-on", 1), HasSubstr("settings.is-on: expected true or false"));
  EXPECT_THAT(with("/layers/0/style/opacity", 2), HasSubstr("layers[0].style.opacity: expected a number from 0 to 1"));
  EXPECT_THAT(with("/layers/1/id", "axis"), HasSubstr("layers[1].id: expected each layer once"));
  EXPECT_THAT(with("/view/scale", 0), HasSubstr("view.scale: expected a positive number"));
  EXPECT_THAT(with("/bundle/name", 3), HasSubstr("bundle: expected an object with the \"name\""));
  EXPECT_THAT(with("/bundle/changed", 3), HasSubstr("bundle.changed: expected true or false"));
  EXPECT_THAT(with("/background", "red"), HasSubstr("background: expected \"paper\", \"dark\""));
  EXPECT_THAT(with("/recording", 3), HasSubstr("recording: expected an object"));
  EXPECT_THAT(with("/recording/size/0", 0), HasSubstr("recording.size[0]: expected a whole number from 1 to 32768"));
  EXPECT_THAT(with("/recording/size", {1, 2, 3}), HasSubstr("recording.size: expected a width and a height"));
  EXPECT_THAT(with("/recording/frames-per-second", 0), HasSubstr("frames-per-second: expected a positive number"));
  EXPECT_THAT(with("/recording/turntable", 0), HasSubstr("recording.turntable: expected a whole number from 1"));
  EXPECT_THAT(with("/recording/sweeps/0", 3), HasSubstr("recording.sweeps: expected sweeps"));
  EXPECT_THAT(with("/recording/transparent", 3), HasSubstr("recording.transparent: expected true or false"));
  EXPECT_THAT(with("/inputs/points", {{"file", "x"}}), HasSubstr("2 per element, found an object"));
}

TEST(Session_test, corners_that_are_no_vertices_are_refused) {
  Session session;
  session.dimension = 3;
  session.inputs = Inputs().with(mesh_input, Triangle_mesh_3{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  auto json = nlohmann::json::parse(to_json(session));
  for (const nlohmann::json& wrong : {nlohmann::json(3), nlohmann::json(-1), nlohmann::json(1.5)}) {
    json["inputs"]["mesh"]["triangles"][1] = wrong;
    EXPECT_THAT(message_of(json.dump(), registry_of(3)),
                HasSubstr("inputs.mesh.triangles[1]: expected a whole number from 0 to 2"));
  }
}

TEST(Session_test, view_shows_as_much_in_another_size) {
  Session session;
  EXPECT_FALSE(view_for(session, 100, 100));
  session.view_2 = View_2{{1, 2}, 10};
  EXPECT_EQ(view_for(session, 100, 100)->scale, 10);
  session.width = 200;
  session.height = 100;
  EXPECT_EQ(view_for(session, 400, 400)->scale, 20);
  EXPECT_EQ(view_for(session, 400, 100)->scale, 10);
}

}  // namespace
}  // namespace mesecina
