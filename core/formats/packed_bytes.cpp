// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/packed_bytes.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <new>
#include <stdexcept>

namespace mesecina {

namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

const Bytef* input_of(std::string_view bytes) { return reinterpret_cast<const Bytef*>(bytes.data()); }

}  // namespace

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string stream(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(stream.data()), &size, input_of(bytes), bytes.size()) != Z_OK)
    throw std::bad_alloc();
  stream.resize(size);
  return stream;
}

std::string inflated(std::string_view stream, std::size_t most) {
  z_stream state{};
  // zlib never writes there.
  state.next_in = const_cast<Bytef*>(input_of(stream));
  state.avail_in = static_cast<uInt>(stream.size());
  if (inflateInit(&state) != Z_OK) throw std::bad_alloc();
  std::string bytes;
  std::array<char, 1 << 16> piece{};
  int code = Z_OK;
  while (code == Z_OK && bytes.size() <= most) {
    state.next_out = reinterpret_cast<Bytef*>(piece.data());
    state.avail_out = piece.size();
    code = inflate(&state, Z_NO_FLUSH);
    bytes.append(piece.data(), piece.size() - state.avail_out);
  }
  inflateEnd(&state);
  if (bytes.size() > most)
    throw std::invalid_argument("expected at most " + std::to_string(most) + " compressed bytes, found more");
  if (code != Z_STREAM_END)
    throw std::invalid_argument("expected a complete zlib stream, found one that is cut off or damaged after " +
                                std::to_string(bytes.size()) + " bytes");
  return bytes;
}

std::string to_base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::string from_base64(std::string_view text) {
  if (text.size() % 4 != 0)
    throw std::invalid_argument("expected base 64 in groups of four characters, found " + std::to_string(text.size()) +
                                " characters");
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    const bool is_last = i + 4 == text.size();
    const std::size_t padding = !is_last || text[i + 3] != '=' ? 0 : text[i + 2] != '=' ? 1 : 2;
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t digit = k >= 4 - padding ? 0 : digits.find(text[i + k]);
      if (digit == std::string_view::npos)
        throw std::invalid_argument("expected base 64, found '" + std::string(1, text[i + k]) + "' at character " +
                                    std::to_string(i + k));
      group = group << 6 | static_cast<std::uint32_t>(digit);
    }
    for (std::size_t k = 0; k < 3 - padding; ++k) bytes += static_cast<char>(group >> (16 - 8 * k) & 255U);
  }
  return bytes;
}

}  // namespace mesecina
