// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <stdexcept>

#include "core/historical_bundles.h"

namespace mesecina {
namespace {

Registry planar_registry() {
  Registry registry;
  registry.begin_module({"module", "Module", "For tests."});
  for (const char* id : {"points", "voronoi", "one-step-crust"}) {
    Layer_spec layer;
    layer.id = id;
    registry.add_layer(layer);
  }
  return registry;
}

Registry spatial_registry() {
  Registry registry(3);
  registry.begin_module({"module", "Module", "For tests."});
  Layer_spec layer;
  layer.id = "medial-axis";
  registry.add_layer(layer);
  return registry;
}

/// Big-endian, byte by byte.
std::string number(std::uint64_t value, int size) {
  std::string bytes;
  for (int i = size - 1; i >= 0; --i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
  return bytes;
}
std::string real(double value, int size) {
  return size == 8 ? number(std::bit_cast<std::uint64_t>(value), 8)
                   : number(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
}
std::string block(const std::string& bytes) { return number(bytes.size(), 4) + bytes; }
std::string text(const std::string& ascii) {
  std::string bytes;
  for (const char c : ascii) bytes += number(static_cast<unsigned char>(c), 2);
  return block(bytes);
}
std::string color(unsigned alpha, unsigned red, unsigned green, unsigned blue) {
  return number(1, 1) + number(alpha * 257, 2) + number(red * 257, 2) + number(green * 257, 2) + number(blue * 257, 2) +
         number(0, 2);
}
/// Up to `active`.
std::string short_layer(unsigned token, bool is_active, int size) {
  return number(token, 4) + number(2, 4) + color(255, 10, 20, 30) + real(5, size) + real(2.5, size) +
         number(is_active, 1);
}
std::string whole_layer(bool is_active, int size) {
  return short_layer(0xB1, is_active, size) + text("Solid") + block(std::string(" \0", 2)) + number(0, 1);
}
std::string bundle(const std::string& layers) { return block(number(0xB2, 4) + number(1, 4) + layers); }
std::string file(const std::string& bundles) { return number(0xB3, 4) + number(1, 4) + bundles; }

std::string refusal_of_bytes(const std::string& bytes) {
  try {
    parse_historical_bundles(bytes, planar_registry());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Historical_bundles, WholeAndShortLayersAreReadWithNumbersOfBothSizes) {
  for (const int size : {4, 8}) {
    for (const bool is_whole : {false, true}) {
      const auto layer = [&](bool is_active) {
        return block(is_whole ? whole_layer(is_active, size) : short_layer(0xB1, is_active, size));
      };
      const std::string bytes =
          file(text("1. points") +
               bundle(text("Curve") + layer(true) + text("Voronoi") + layer(false) + text("Points") + layer(true)) +
               text("2. nothing") + bundle(""));
      const std::vector<Bundle> bundles = parse_historical_bundles(bytes, planar_registry());
      ASSERT_EQ(bundles.size(), 2U);
      EXPECT_EQ(bundles[0].name, "1. points");
      ASSERT_EQ(bundles[0].layers.size(), 2U) << size << is_whole;
      EXPECT_EQ(bundles[0].layers[0].id, "one-step-crust");
      EXPECT_EQ(bundles[0].layers[1].id, "points");
      const Style& style = bundles[0].layers[0].style;
      EXPECT_TRUE(style.visible);
      EXPECT_EQ(style.color, (Color{10, 20, 30}));
      EXPECT_EQ(style.point_size, 5);
      EXPECT_EQ(style.line_width, 2.5);
      EXPECT_EQ(style.opacity, 1);
      EXPECT_TRUE(bundles[1].layers.empty());
    }
  }
}

TEST(Historical_bundles, LayersOfSpaceAreRead) {
  const std::string state =
      short_layer(0xC1, true, 8) + text("") + real(0.5, 8) + real(1, 8) + text("Jet") + number(1, 1) + number(0, 1);
  const std::string bytes = file(text("axis") + bundle(text("Medial axis") + block(state)));
  const std::vector<Bundle> bundles = parse_historical_bundles(bytes, spatial_registry());
  ASSERT_EQ(bundles.size(), 1U);
  ASSERT_EQ(bundles[0].layers.size(), 1U);
  EXPECT_EQ(bundles[0].layers[0].id, "medial-axis");
}

TEST(Historical_bundles, UnknownLayersAreToldIfTheyWereOn) {
  const std::string bytes = file(text("old") + bundle(text("Poisson") + block(whole_layer(true, 4)) + text("SA disks") +
                                                      block(whole_layer(false, 4))));
  const std::vector<Bundle> bundles = parse_historical_bundles(bytes, planar_registry());
  ASSERT_EQ(bundles[0].unknown.notes.size(), 1U);
  EXPECT_EQ(bundles[0].unknown.notes[0], "bundle 'old': there is no layer for 'Poisson'");
}

TEST(Historical_bundles, EveryTruncationIsRefusedOrReadAndNothingBehindTheEnd) {
  const std::string bytes = file(text("a") + bundle(text("Points") + block(whole_layer(true, 4))) + text("b") +
                                 bundle(text("Voronoi") + block(short_layer(0xB1, true, 8))));
  EXPECT_EQ(parse_historical_bundles(bytes, planar_registry()).size(), 2U);
  int read = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::string part = bytes.substr(0, length);
    const std::string reason = refusal_of_bytes(std::string(part));
    if (reason == "nothing was thrown")
      ++read;
    else
      EXPECT_TRUE(reason.starts_with("byte ")) << reason;
  }
  // The frame alone, and the frame with the first bundle.
  EXPECT_EQ(read, 2);
}

TEST(Historical_bundles, RefusalsSayWhere) {
  EXPECT_EQ(refusal_of_bytes("abcd"), "byte 0: expected the mark of a file of bundles 0xB3, found 0x61626364");
  EXPECT_EQ(refusal_of_bytes(file(number(100, 4) + "ab")),
            "byte 12: expected a name of a bundle of 100 bytes, found 2 bytes to the end");
  EXPECT_EQ(refusal_of_bytes(file(text("a") + block(number(0xB1, 4)))),
            "byte 18: expected the mark of a bundle 0xB2, found 0xB1");
}

}  // namespace
}  // namespace mesecina
