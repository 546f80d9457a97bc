// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/session.h"

namespace mesecina {

/// A scene in a folder of its own: the session, and every input in a file beside it, so that an input that stays the
/// same is written once.
struct Stored_scene {
  std::filesystem::path folder;
  std::string title;                                 ///< of the session; empty for one without
  std::chrono::system_clock::time_point changed;     ///< when it was written last
  std::string file = {};                             ///< of the session; empty for one without
  std::map<std::string, std::uint64_t> counts = {};  ///< of points, triangles, ... by the id of the input
  std::size_t visible_layers = 0;
};

/// Whether both are states of what the user would call one scene: of the same file, or, where there is none, with the
/// same title.
bool is_same_scene(const Stored_scene& one, const Stored_scene& other);

/// Reads a scene that was written by Running_scene. Throws File_error.
Session read_scene_folder(const std::filesystem::path& folder, const Registry& registry);

/// The scenes of a program that nobody had to save. ROOT/running has one folder per window; whoever holds the lock in
/// it is alive. ROOT/kept has those of windows that are closed.
class Scene_store {
 public:
  explicit Scene_store(std::filesystem::path root) : root_(std::move(root)) {}

  /// Those whose windows ended without being closed, the newest first.
  std::vector<Stored_scene> crashed() const;
  /// The newest first.
  std::vector<Stored_scene> kept() const;
  /// Moves a crashed scene to the kept ones; returns its new place. Throws File_error when another window was faster,
  /// or where it cannot be moved.
  std::filesystem::path keep(const std::filesystem::path& crashed) const;
  /// Removes kept scenes that are older than this, and those beyond the newest `most`.
  void expire(std::chrono::hours age, std::size_t most) const;

 private:
  friend class Running_scene;
  std::filesystem::path running() const { return root_ / "running"; }
  std::filesystem::path kept_folder() const { return root_ / "kept"; }
  std::filesystem::path root_;
};

/// The scene of a window that runs. One thread uses it at a time.
class Running_scene {
 public:
  /// Makes a folder and locks it until this object or the process ends. Throws File_error.
  explicit Running_scene(const Scene_store& store);
  ~Running_scene();
  Running_scene(const Running_scene&) = delete;
  Running_scene& operator=(const Running_scene&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

  /// Writes what is new since the last time. Whenever it ends, even by force, the folder holds either the last scene
  /// or this one. Throws File_error.
  void write(const Session& session);
  /// The window is closed: its scene is moved to the kept ones, or removed.
  void close(bool is_kept);

 private:
  std::string write_input(const Inputs& inputs, std::string_view id);
  void remove_unused() const;

  Scene_store store_;
  std::filesystem::path folder_;
  int lock_ = -1;
  Session written_;  ///< keeps its inputs alive, so that no other has their address
  std::map<const void*, std::string> files_;
  std::map<const void*, std::string> used_;
  std::size_t next_ = 1;
};

}  // namespace mesecina
