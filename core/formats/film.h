// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

#include "core/style.h"
#include "core/view_3.h"

namespace mesecina {

/// What a film is made of: exactly its name, and what all its frames have in common.
struct Film_request {
  std::filesystem::path file;  ///< its name decides what it is (film_kind_of)
  int width = 1200;            ///< in pixels
  int height = 900;
  double frames_per_second = 30;
  bool is_transparent = false;  ///< no background; not in mp4, which cannot say so
  Color background{255, 255, 255};
};

struct Film_frame {
  Scene scene;
  View_2 view;    ///< in the plane
  View_3 view_3;  ///< in space
};

/// Pictures on their way into a file, one after the other. Nothing is seen under the name of the file until finish();
/// without it, nothing stays. All functions, the destructor too, belong into one thread.
class Film {
 public:
  Film() = default;
  virtual ~Film() = default;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// Paints it, as pictures in files are painted, and waits until the encoder has taken it. Throws Cancelled when
  /// `stop` says so meanwhile, File_error where there is no room for it or the encoder fails.
  virtual void add(const Film_frame& frame, const std::stop_token& stop) = 0;
  /// Waits until the film is complete and gives it its name. Returns nothing; or, where no film could be encoded and
  /// there are numbered pictures instead, where these are and which command makes the film of them. Throws as add().
  virtual std::string finish(const std::stop_token& stop) = 0;
};

enum class Film_kind { mp4, webm, gif, frames };

/// By the name: *.mp4, *.webm, *.gif, or a name like frame-%05d.png with one place for the number of the frame. nullopt
/// for others.
std::optional<Film_kind> film_kind_of(const std::filesystem::path& file);
/// Why there can be no film of this name, size and look, in one line; empty when there can.
std::string reason_against(const Film_request& request);
/// With the number of the frame, 1 for the first, in the place for it.
std::filesystem::path frame_name(const std::filesystem::path& pattern, int number);
/// The folder of a film that is not finished, for whoever cleans up after a process that ended by force.
std::filesystem::path unfinished_film(const std::filesystem::path& file);

}  // namespace mesecina
