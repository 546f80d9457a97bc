// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene_store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/formats/durable_file.h"
#include "core/formats/format.h"
#include "core/formats/input_bytes.h"
#include "core/formats/text_file.h"

namespace mesecina {

namespace {

namespace fs = std::filesystem;

constexpr const char* scene_name = "scene.json";
constexpr const char* lock_name = "lock";
constexpr const char* input_prefix = "input-";

/// A file that is locked while this object lives.
class File_lock {
 public:
  explicit File_lock(const fs::path& file) : descriptor_(open(file.c_str(), O_RDWR | O_CLOEXEC)) {
    if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      ::close(descriptor_);
      descriptor_ = -1;
    }
  }
  ~File_lock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File_lock(const File_lock&) = delete;
  File_lock& operator=(const File_lock&) = delete;
  bool is_held() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

/// How many elements a list of the user's data has; what an input of another type is, counts as one.
std::uint64_t count_of(const Inputs& inputs, std::string_view id) {
  const auto size_of = [&]<class T>(Input_key<std::vector<T>>) -> std::uint64_t {
    const auto list = inputs.get(Input_key<std::vector<T>>{id});
    return list ? list->size() : 0;
  };
  if (const auto mesh = inputs.get(Input_key<Triangle_mesh_3>{id})) return mesh->triangles.size();
  if (const auto outline = inputs.get(Input_key<Outline_2>{id})) return outline->rings.size();
  const std::uint64_t size = size_of(points_input) + size_of(disks_input) + size_of(balls_input) + size_of(cloud_input);
  return inputs.get(Input_key<Image>{id}) ? 1 : size;
}

/// What can be said of a scene without reading its inputs.
Stored_scene description_of(const fs::path& scene) {
  Stored_scene description;
  description.folder = scene.parent_path();
  try {
    const auto json = nlohmann::json::parse(load_bytes(scene).text);
    description.title = json.value("title", std::string());
    description.file = json.value("file", std::string());
    const auto layers = json.value("layers", nlohmann::json::array());
    const auto inputs = json.value("inputs", nlohmann::json::object());
    for (const auto& layer : layers)
      if (layer.value("visible", true)) ++description.visible_layers;
    for (const auto& input : inputs.items())
      if (input.value().is_object() && input.value().contains("count"))
        description.counts[input.key()] = input.value()["count"].get<std::uint64_t>();
  } catch (const std::exception&) {
    // A damaged scene is listed all the same; reading it says what is wrong.
    return description;
  }
  return description;
}

/// All folders in `folder` that hold a scene, the newest first.
std::vector<Stored_scene> scenes_in(const fs::path& folder) {
  std::vector<Stored_scene> scenes;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const fs::path scene = it->path() / scene_name;
    std::error_code missing;
    const auto changed = fs::last_write_time(scene, missing);
    if (missing) continue;
    scenes.push_back(description_of(scene));
    scenes.back().changed =
        std::chrono::time_point_cast<std::chrono::system_clock::duration>(std::chrono::file_clock::to_sys(changed));
  }
  std::ranges::sort(scenes, [](const Stored_scene& one, const Stored_scene& other) {
    return std::pair(one.changed, one.folder) > std::pair(other.changed, other.folder);
  });
  return scenes;
}

/// Moves a folder into another one, under a name that is free there. Returns its new place, or sets the error.
fs::path move_into(const fs::path& parent, const fs::path& folder, std::error_code& error) {
  fs::create_directories(parent, error);
  if (error) return {};
  fs::path place = parent / folder.filename();
  for (int i = 1; fs::exists(place, error); ++i)
    place = parent / (folder.filename().string() + "-" + std::to_string(i));
  fs::rename(folder, place, error);
  return place;
}

/// A new folder in `parent`, named by the time and this process.
fs::path make_folder(const fs::path& parent) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &local);
  const std::string name = std::string(text) + "-" + std::to_string(getpid());
  std::error_code error;
  fs::create_directories(parent, error);
  constexpr int most_attempts = 1000;
  for (int i = 0; i < most_attempts && !error; ++i) {
    const fs::path folder = parent / (i == 0 ? name : name + "-" + std::to_string(i));
    if (fs::create_directory(folder, error)) return folder;
  }
  throw File_error(parent, 0,
                   "expected to make a folder here for what is not saved, found '" + error.message() +
                       "'; free disk space or check the permissions");
}

}  // namespace

Session read_scene_folder(const fs::path& folder, const Registry& registry) {
  const fs::path scene = folder / scene_name;
  const auto load = [&](const std::string& name) {
    if (name.find('/') != std::string::npos || !name.starts_with(input_prefix))
      throw std::invalid_argument("expected the name of a file beside the scene, found " + quote(name));
    return load_bytes(folder / name).text;
  };
  try {
    return parse_session(load_bytes(scene).text, registry, load);
  } catch (const std::invalid_argument& error) {
    throw File_error(scene, 0, error.what());
  }
}

bool is_same_scene(const Stored_scene& one, const Stored_scene& other) {
  return one.file.empty() && other.file.empty() ? one.title == other.title : one.file == other.file;
}

std::vector<Stored_scene> Scene_store::crashed() const {
  std::vector<Stored_scene> scenes = scenes_in(running());
  std::erase_if(scenes, [](const Stored_scene& scene) { return !File_lock(scene.folder / lock_name).is_held(); });
  return scenes;
}

std::vector<Stored_scene> Scene_store::kept() const { return scenes_in(kept_folder()); }

fs::path Scene_store::keep(const fs::path& crashed) const {
  const File_lock lock(crashed / lock_name);
  fs::path place;
  std::error_code error;
  if (lock.is_held()) {
    place = move_into(kept_folder(), crashed, error);
  } else {
    error = std::make_error_code(std::errc::resource_unavailable_try_again);
  }
  if (error)
    throw File_error(crashed, 0,
                     "expected a scene that can be moved to the kept ones, found '" + error.message() +
                         "'; another window may have taken it");
  return place;
}

void Scene_store::expire(std::chrono::hours age, std::size_t most) const {
  const std::vector<Stored_scene> scenes = kept();
  const auto oldest = std::chrono::system_clock::now() - age;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::error_code error;
    if (i >= most || scenes[i].changed < oldest) fs::remove_all(scenes[i].folder, error);
  }
}

Running_scene::Running_scene(const Scene_store& store) : store_(store), folder_(make_folder(store.running())) {
  const fs::path file = folder_ / lock_name;
  lock_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
  const std::string process = std::to_string(getpid()) + "\n";
  if (lock_ < 0 || flock(lock_, LOCK_EX | LOCK_NB) != 0 ||
      ::write(lock_, process.data(), process.size()) != static_cast<ssize_t>(process.size()))
    throw File_error(file, 0,
                     "expected to lock this file, found '" + std::generic_category().message(errno) +
                         "'; what is not saved is not kept");
}

Running_scene::~Running_scene() {
  if (lock_ >= 0) ::close(lock_);
}

void Running_scene::write(const Session& session) {
  used_.clear();
  const std::string text =
      to_json(session, [this](const Inputs& inputs, std::string_view id) { return write_input(inputs, id); });
  write_file_durably(folder_ / scene_name, [&](std::ostream& stream) { stream << text; });
  files_ = std::exchange(used_, {});
  written_ = session;
  remove_unused();
}

std::string Running_scene::write_input(const Inputs& inputs, std::string_view id) {
  const void* identity = inputs.identity(id);
  auto known = files_.find(identity);
  std::string name;
  if (known != files_.end()) {
    name = known->second;
  } else if (known = used_.find(identity); known != used_.end()) {
    name = known->second;
  } else {
    name = input_prefix + std::string(id) + "-" + std::to_string(next_++) + ".bin";
    write_file_durably(folder_ / name, [&](std::ostream& stream) { write_input_bytes(stream, inputs, id); });
  }
  used_[identity] = name;
  // How much there is, for lists of scenes.
  return R"({"file": ")" + name + R"(", "count": )" + std::to_string(count_of(inputs, id)) + "}";
}

void Running_scene::remove_unused() const {
  std::error_code error;
  std::vector<fs::path> unused;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    const bool is_used = std::ranges::any_of(files_, [&](const auto& file) { return file.second == name; });
    if (name.starts_with(input_prefix) && !is_used) unused.push_back(it->path());
  }
  for (const fs::path& file : unused) fs::remove(file, error);
}

void Running_scene::close(bool is_kept) {
  std::error_code error;
  if (is_kept && fs::exists(folder_ / scene_name, error)) {
    // One that cannot be moved is found as crashed.
    move_into(store_.kept_folder(), folder_, error);
  } else {
    fs::remove_all(folder_, error);
  }
}

}  // namespace mesecina
