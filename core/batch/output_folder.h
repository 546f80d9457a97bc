// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace mesecina {

/// The folder of a run's results. All files of an input appear together, when the last of them is written, and with
/// them a record of what they depend on. Until then they lie in a folder of their own, out of sight. Inputs are told
/// apart by their file names without extension. Safe to call from several threads, for different inputs.
class Output_folder {
 public:
  explicit Output_folder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Makes the folder where there is none. Returns why that is not possible; nothing where it is.
  std::optional<std::string> create() const;
  const std::filesystem::path& path() const { return folder_; }

  /// The record of results that are complete: all of `names` (as given to `unfinished`) are there, and they were made
  /// from what `fingerprint` (one line) says. It is the line that `publish` was given.
  std::optional<std::string> find_complete(const std::filesystem::path& input, const std::string& fingerprint,
                                           const std::vector<std::string>& names) const;

  /// Makes room for the files of the input, and throws away what an earlier run has left half done.
  void begin(const std::filesystem::path& input) const;
  /// Whether somebody began and neither published nor discarded: still at work, or ended by force.
  bool is_begun(const std::filesystem::path& input) const;
  /// Where a file called <input stem><name> will be.
  std::filesystem::path place(const std::filesystem::path& input, const std::string& name) const;
  /// Where to write it until then.
  std::filesystem::path unfinished(const std::filesystem::path& input, const std::string& name) const;
  /// Moves all files of the input to their places, and keeps `fingerprint` and `record` (one line each, or empty) with
  /// them. Files of the names `refused`, which could not be made, are removed from their places: they are of an earlier
  /// run. Throws File_error, and then none of them is in its place.
  void publish(const std::filesystem::path& input, const std::string& fingerprint, const std::string& record,
               const std::vector<std::string>& refused = {});
  /// Removes what was not published.
  void discard(const std::filesystem::path& input) const;

  /// From now on nothing is published any more: `publish` does not return. For the end of a process that does not wait
  /// for its threads.
  void close() { publishing_.lock(); }

 private:
  std::filesystem::path hidden(const std::filesystem::path& input, const char* suffix) const {
    return folder_ / ".mesecina" / (input.stem().string() + suffix);
  }
  std::filesystem::path record_of(const std::filesystem::path& input) const { return hidden(input, ".json"); }
  std::filesystem::path workplace_of(const std::filesystem::path& input) const { return hidden(input, ".unfinished"); }

  std::filesystem::path folder_;
  std::mutex publishing_;
};

}  // namespace mesecina
