// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/png_check.h"

#include <boost/crc.hpp>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "core/formats/format.h"

namespace mesecina {

namespace {

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<std::uint8_t>(byte);
  return number;
}

}  // namespace

void check_png(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
  std::string_view rest = bytes;
  if (!rest.starts_with(signature)) return;
  rest.remove_prefix(signature.size());
  constexpr std::size_t frame = 12;  // length, type and checksum of a chunk
  for (;;) {
    const auto position = std::to_string(bytes.size() - rest.size());
    const std::size_t length = rest.size() < frame ? 0 : big_endian(rest);
    if (rest.size() < frame || rest.size() - frame < length)
      throw File_error(file, 0,
                       "expected a complete PNG, found its end at byte " + std::to_string(bytes.size()) +
                           " within the part that starts at byte " + position + "; copy the file anew");
    boost::crc_32_type checksum;
    checksum.process_bytes(rest.data() + 4, length + 4);
    if (checksum.checksum() != big_endian(rest.substr(length + 8)))
      throw File_error(file, 0,
                       "expected an undamaged PNG, found a wrong checksum in the part that starts at byte " + position +
                           "; copy the file anew");
    if (rest.substr(4, 4) == "IEND") return;
    rest.remove_prefix(frame + length);
  }
}

}  // namespace mesecina
