// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <set>

#include "core/formats/format.h"

namespace mesecina {
namespace {

namespace fs = std::filesystem;

class Scene_store_test : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "mesecina-scenes-XXXXXX").string();
    root_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(root_); }

  static Session session_with(double x, const std::string& title = "points.xy") {
    Session session;
    session.title = title;
    session.inputs = Inputs()
                         .with(points_input, std::vector<Point_2>{{x, 0.1}})
                         .with(outline_input, Outline_2{{{{0, 0}, {1, 0}, {0, 1}}}});
    return session;
  }
  static double x_of(const Session& session) { return session.inputs.get(points_input)->front().x; }
  static std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
    return names;
  }
  /// A process that writes a scene and is killed.
  void crash(double x) const {
    const pid_t process = fork();
    if (process == 0) {
      Running_scene running{Scene_store(root_)};
      running.write(session_with(x));
      kill(getpid(), SIGKILL);
    }
    waitpid(process, nullptr, 0);
  }

  fs::path root_;
  Registry registry_{2};
};

TEST_F(Scene_store_test, writes_only_what_is_new) {
  Running_scene running{Scene_store(root_)};
  Session session = session_with(1);
  running.write(session);
  EXPECT_EQ(x_of(read_scene_folder(running.folder(), registry_)), 1);
  const auto first = files_in(running.folder());
  EXPECT_EQ(first.size(), 4u);  // lock, scene, two inputs
  const auto outline_file = *std::ranges::find_if(first, [](auto& name) { return name.starts_with("input-outline"); });
  const auto written = fs::last_write_time(running.folder() / outline_file);

  session.title = "another.xy";
  running.write(session);
  EXPECT_EQ(files_in(running.folder()), first);

  session.inputs = session.inputs.with(points_input, std::vector<Point_2>{{2, 3}});
  running.write(session);
  const auto second = files_in(running.folder());
  EXPECT_EQ(second.size(), 4u);
  EXPECT_NE(second, first);
  EXPECT_TRUE(second.contains(outline_file));
  EXPECT_EQ(fs::last_write_time(running.folder() / outline_file), written);
  const Session back = read_scene_folder(running.folder(), registry_);
  EXPECT_EQ(back.title, "another.xy");
  EXPECT_EQ(x_of(back), 2);
  EXPECT_EQ(*back.inputs.get(outline_input), *session.inputs.get(outline_input));
}

TEST_F(Scene_store_test, what_a_scene_holds_is_known_without_its_inputs) {
  const Scene_store store(root_);
  Session session = session_with(1);
  session.file = "/a/points.xy";
  session.inputs = session.inputs.with(mesh_input, Triangle_mesh_3{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}})
                       .with(image_input, Image{1, 1, {1, 2, 3, 4}, {}, 1})
                       .with(balls_input, std::vector<Ball_3>(7));
  Style shown;
  shown.visible = true;
  session.layers = {{"one", shown}, {"other", {}}};
  {
    Running_scene running(store);
    running.write(session);
    running.close(true);
  }
  const auto kept = store.kept();
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].file, "/a/points.xy");
  EXPECT_EQ(kept[0].visible_layers, 1u);
  EXPECT_EQ(kept[0].counts, (std::map<std::string, std::uint64_t>{
                                {"points", 1}, {"outline", 1}, {"mesh", 1}, {"image", 1}, {"balls", 7}}));
  EXPECT_EQ(*read_scene_folder(kept[0].folder, registry_).inputs.get(balls_input), std::vector<Ball_3>(7));
  Stored_scene other = kept[0];
  other.title = "renamed";
  EXPECT_TRUE(is_same_scene(kept[0], other));
  other.file = "/b/points.xy";
  EXPECT_FALSE(is_same_scene(kept[0], other));
  EXPECT_TRUE(is_same_scene({"a", "Example", {}}, {"b", "Example", {}}));
  EXPECT_FALSE(is_same_scene({"a", "Example", {}}, {"b", "", {}}));
}

TEST_F(Scene_store_test, inputs_of_earlier_versions_are_json) {
  Running_scene running{Scene_store(root_)};
  running.write(session_with(1));
  std::ofstream(running.folder() / "input-points-9.json") << "[7, 8]";
  std::ofstream(running.folder() / "scene.json") << R"({"format": "mesecina-session", "version": 1, "dimension": 2,)"
                                                 << R"( "inputs": {"points": {"file": "input-points-9.json"}}})";
  EXPECT_EQ(x_of(read_scene_folder(running.folder(), registry_)), 7);
}

TEST_F(Scene_store_test, what_cannot_be_written_leaves_the_scene_before) {
  Running_scene running{Scene_store(root_)};
  running.write(session_with(1));
  // No name is left for the next scene, as on a disk that is full when its inputs are written.
  constexpr int most_attempts = 1000;
  for (int i = 0; i < most_attempts; ++i) std::ofstream(running.folder() / ("scene.json.part" + std::to_string(i)));
  EXPECT_THROW(running.write(session_with(2)), File_error);
  EXPECT_EQ(x_of(read_scene_folder(running.folder(), registry_)), 1);
  for (int i = 0; i < most_attempts; ++i) fs::remove(running.folder() / ("scene.json.part" + std::to_string(i)));
  running.write(session_with(3));
  EXPECT_EQ(x_of(read_scene_folder(running.folder(), registry_)), 3);
  EXPECT_EQ(files_in(running.folder()).size(), 4u);
}

TEST_F(Scene_store_test, no_other_data_gets_the_place_of_what_is_written) {
  Running_scene running{Scene_store(root_)};
  Session session = session_with(1);
  const std::weak_ptr<const std::vector<Point_2>> points = session.inputs.get(points_input);
  running.write(session);
  session = {};
  EXPECT_FALSE(points.expired());
  running.write(session);
  EXPECT_TRUE(points.expired());
}

TEST_F(Scene_store_test, those_who_live_are_left_alone) {
  const Scene_store store(root_);
  Running_scene one(store);
  Running_scene other(store);
  EXPECT_NE(one.folder(), other.folder());
  one.write(session_with(1));
  other.write(session_with(2));
  EXPECT_TRUE(store.crashed().empty());
  EXPECT_TRUE(store.kept().empty());
  EXPECT_THROW(store.keep(one.folder()), File_error);
  EXPECT_EQ(x_of(read_scene_folder(one.folder(), registry_)), 1);
}

TEST_F(Scene_store_test, what_was_killed_is_found) {
  const Scene_store store(root_);
  crash(1);
  crash(2);
  Running_scene alive(store);
  alive.write(session_with(3));
  const auto crashed = store.crashed();
  ASSERT_EQ(crashed.size(), 2u);
  EXPECT_EQ(crashed[0].title, "points.xy");
  std::set<double> found;
  for (const Stored_scene& scene : crashed) found.insert(x_of(read_scene_folder(scene.folder, registry_)));
  EXPECT_EQ(found, (std::set<double>{1, 2}));
  const fs::path place = store.keep(crashed[0].folder);
  EXPECT_EQ(store.crashed().size(), 1u);
  ASSERT_EQ(store.kept().size(), 1u);
  EXPECT_EQ(store.kept()[0].folder, place);
  EXPECT_NO_THROW(read_scene_folder(place, registry_));
  // Another window was faster.
  EXPECT_THROW(store.keep(crashed[0].folder), File_error);
}

TEST_F(Scene_store_test, closing_keeps_or_removes) {
  const Scene_store store(root_);
  {
    Running_scene running(store);
    running.write(session_with(1));
    running.close(true);
  }
  ASSERT_EQ(store.kept().size(), 1u);
  EXPECT_EQ(x_of(read_scene_folder(store.kept()[0].folder, registry_)), 1);
  {
    Running_scene running(store);
    running.write(session_with(2));
    running.close(false);
  }
  EXPECT_EQ(store.kept().size(), 1u);
  EXPECT_TRUE(fs::is_empty(root_ / "running"));
}

TEST_F(Scene_store_test, what_is_old_expires) {
  const Scene_store store(root_);
  for (int i = 0; i < 5; ++i) {
    Running_scene running(store);
    running.write(session_with(i));
    const fs::path scene = running.folder() / "scene.json";
    fs::last_write_time(scene, fs::file_time_type::clock::now() - std::chrono::hours(10 * i));
    running.close(true);
  }
  ASSERT_EQ(store.kept().size(), 5u);
  EXPECT_EQ(x_of(read_scene_folder(store.kept()[0].folder, registry_)), 0);
  store.expire(std::chrono::hours(35), 100);
  EXPECT_EQ(store.kept().size(), 4u);
  store.expire(std::chrono::hours(35), 2);
  ASSERT_EQ(store.kept().size(), 2u);
  EXPECT_EQ(x_of(read_scene_folder(store.kept()[1].folder, registry_)), 1);
}

TEST_F(Scene_store_test, damaged_scenes_are_told) {
  Running_scene running{Scene_store(root_)};
  running.write(session_with(1));
  const auto files = files_in(running.folder());
  const auto points = *std::ranges::find_if(files, [](auto& name) { return name.starts_with("input-points"); });
  std::ofstream(running.folder() / points) << "[1,";
  EXPECT_THROW(read_scene_folder(running.folder(), registry_), File_error);
  fs::remove(running.folder() / points);
  EXPECT_THROW(read_scene_folder(running.folder(), registry_), File_error);
  // No file but those beside it.
  std::ofstream(running.folder() / "scene.json")
      << R"({"format": "mesecina-session", "version": 1, "dimension": 2, "inputs": {"points": {"file": "../x"}}})";
  EXPECT_THROW(read_scene_folder(running.folder(), registry_), File_error);
}

}  // namespace
}  // namespace mesecina
