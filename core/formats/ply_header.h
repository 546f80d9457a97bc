// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/text_file.h"

namespace mesecina {

enum class Ply_encoding { text, little_endian, big_endian };

enum class Ply_type { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// In bytes.
std::size_t size_of(Ply_type type);

struct Ply_property {
  std::string name;
  Ply_type type = Ply_type::float32;
  std::optional<Ply_type> count_type;  ///< of a list; absent: one number
};

struct Ply_element {
  std::string name;
  std::uint64_t count = 0;  ///< as it is said; the file may hold less
  std::vector<Ply_property> properties;
};

struct Ply_header {
  Ply_encoding encoding = Ply_encoding::text;
  std::vector<Ply_element> elements;
  std::size_t size = 0;  ///< in bytes, with the end of its last line
};

/// The header of a PLY file. Throws File_error for what is none.
Ply_header parse_ply_header(const Text_file& file);

}  // namespace mesecina
