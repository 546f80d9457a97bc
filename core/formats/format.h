// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/inputs.h"
#include "core/primitives.h"
#include "core/settings.h"
#include "core/style.h"
#include "core/view_3.h"

namespace mesecina {

/// A file that cannot be read or written. what() is one line: "FILE:LINE: expected ..., found ...; what to do".
class File_error : public std::runtime_error {
 public:
  /// line 0: the file as a whole.
  File_error(const std::filesystem::path& file, std::size_t line, const std::string& message);
};

struct Session;

/// What a file held. `inputs` has only the keys that the file gave.
struct File_contents {
  Inputs inputs;
  std::vector<std::string> warnings;  ///< one line each, naming place and numbers ("ring 3 is not closed: ...")
  std::shared_ptr<const Session> session = {};  ///< of a file that says how the inputs are seen; null else
};

/// Reads files of some extensions. Throws File_error; never returns half a file.
struct Reader {
  std::string name;                     ///< "WKT outlines"
  std::vector<std::string> extensions;  ///< lower case, no dot
  std::function<File_contents(const std::filesystem::path&)> read;
};

/// A layer on its way into a file.
struct Layer_document {
  std::string layer;
  std::string input;  ///< name of the input file, or ""
  std::map<std::string, Setting_value> settings;
  const Primitive_set* primitives = nullptr;  ///< null iff there is a reason
  std::string reason;
  int dimension = 2;  ///< of the space, for when there are no primitives to tell
};

/// Writes one layer. The bytes depend only on the document.
struct Layer_writer {
  std::string name;       ///< of the format, as in --formats
  std::string extension;  ///< no dot
  std::string help;
  std::function<void(std::ostream&, const Layer_document&)> write;
  /// Of formats that hold some kinds of elements only: what these are ("triangles"), and whether a layer has any.
  std::string holds = {};
  std::function<bool(const Primitive_set&)> holds_any = {};
};

/// What to tell where a layer that has elements gives an empty file in this format: "stl holds triangles, and there are
/// 12 points and 3 segments: the file is empty"; else empty.
std::string empty_file_text(const Layer_writer& writer, const Primitive_set* primitives);

/// Writes a picture of all layers. Width and height in pixels. Throws File_error.
struct Picture_writer {
  std::string name;
  std::string extension;
  std::string help;
  std::function<void(const std::filesystem::path&, const Scene&, const View_2&, int width, int height)> write;
  /// The same of a scene in space. A format of a program has one of the two.
  std::function<void(const std::filesystem::path&, const Scene&, const View_3&, int width, int height)> write_3 = {};
};

/// Writes inputs back, losslessly: reading the file gives equal inputs. (Only the order of an outline's rings may
/// change: holes follow their outer ring; and STL keeps what its format can, triangles in single precision.)
struct Input_writer {
  std::string name;
  std::string extension;
  std::string input_id;  ///< the key it writes: "points", "disks", "outline", "mesh", "balls", "cloud"
  std::function<void(std::ostream&, const Inputs&)> write;
};

class Film;
struct Film_request;

/// The formats a program knows; what needs Qt is added by `layers`.
struct Formats {
  std::vector<Reader> readers;
  std::vector<Layer_writer> layer_writers;
  std::vector<Picture_writer> picture_writers;
  std::vector<Input_writer> input_writers;
  /// Begins a film (core/formats/film.h). Throws File_error. Empty where a program can make none.
  std::function<std::unique_ptr<Film>(const Film_request&)> make_film = {};

  const Reader* reader_for(const std::filesystem::path& file) const;  ///< by extension, any case; null if none
  const Layer_writer* find_layer_writer(std::string_view name) const;
  const Picture_writer* find_picture_writer(std::string_view name) const;
};

/// Every planar format that needs no Qt: points and disks (xy xyz csv txt poff wpoff), outlines (wkt svg geojson);
/// json csv obj ply out.
Formats planar_formats();

/// Every format of space that needs no Qt: meshes (off obj ply stl inr), points and balls (xyz pts pwn csv txt cin woff
/// moff ma); json csv ply off obj stl ma woff moff out.
Formats spatial_formats();

/// Reads a file with the reader of its extension. Throws File_error also for a missing file, a directory, an unreadable
/// file, an unknown extension (the message lists the known ones) and an empty file.
File_contents read_file(const Formats& formats, const std::filesystem::path& file);

/// Writes through a temporary name in the same directory and renames, so that a file is complete or not there.
/// Throws File_error.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

}  // namespace mesecina
