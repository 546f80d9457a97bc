// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <stdexcept>
#include <string>

#include "core/formats/level_surface.h"
#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

template <class Value>
Volume_3 volume(std::array<std::size_t, 3> counts, const Value& value) {
  Volume_3 result;
  result.counts = counts;
  for (std::size_t z = 0; z < counts[2]; ++z)
    for (std::size_t y = 0; y < counts[1]; ++y)
      for (std::size_t x = 0; x < counts[0]; ++x)
        result.values.push_back(
            static_cast<float>(value(Point_3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)})));
  return result;
}

/// Every edge has one triangle in each direction, and around every vertex there is one fan.
void expect_closed_manifold(const Triangle_mesh_3& mesh) {
  std::map<std::array<int, 2>, int> edges;
  std::map<int, std::map<int, int>> links;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      ++edges[{t[i], t[(i + 1) % 3]}];
      links[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
    }
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge[1], edge[0]}));
  }
  ASSERT_EQ(links.size(), mesh.vertices.size());
  for (const auto& [vertex, link] : links) {
    std::size_t steps = 0;
    int at = link.begin()->first;
    do {
      at = link.at(at);
      ++steps;
    } while (at != link.begin()->first && steps <= link.size());
    EXPECT_EQ(steps, link.size());
  }
}

int euler(const Triangle_mesh_3& mesh) {
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size()) / 2;
}

double volume_of(const Triangle_mesh_3& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  return sum;
}

constexpr std::size_t many = 1'000'000;

TEST(Level_surface, OfASphereIsASphere) {
  const Point_3 center{9.3, 8.8, 9.1};
  Volume_3 ball = volume({20, 19, 21}, [&](const Point_3& p) { return 6 - distance(p, center); });
  ball.origin = {-1, 2, 3};
  ball.spacing = {0.5, 0.5, 0.5};
  const Level_surface_3 found = level_surface(ball, 0, many);
  expect_closed_manifold(found.mesh);
  EXPECT_FALSE(found.meets_border);
  EXPECT_EQ(euler(found.mesh), 2);
  const Point_3 there{center.x / 2 - 1, center.y / 2 + 2, center.z / 2 + 3};
  for (const Point_3& p : found.mesh.vertices) EXPECT_NEAR(distance(p, there), 3, 0.04);
  EXPECT_NEAR(volume_of(found.mesh), 4 * 3.14159265 / 3 * 27, 3);
}

TEST(Level_surface, OfNoiseIsAClosedManifold) {
  std::mt19937 random(7);
  // Few different numbers: many are equal to the level.
  std::uniform_int_distribution<int> number(0, 3);
  for (int round = 0; round < 5; ++round) {
    const Level_surface_3 found =
        level_surface(volume({7, 6, 8}, [&](const Point_3&) { return number(random); }), 2, many);
    expect_closed_manifold(found.mesh);
    EXPECT_TRUE(found.meets_border);
    EXPECT_GT(volume_of(found.mesh), 0) << "oriented outward";
  }
}

TEST(Level_surface, OfASingleNumberIsAroundIt) {
  const Level_surface_3 found = level_surface(volume({1, 1, 1}, [](const Point_3&) { return 1; }), 1, many);
  expect_closed_manifold(found.mesh);
  EXPECT_EQ(euler(found.mesh), 2);
  EXPECT_THAT(level_surface(volume({2, 2, 2}, [](const Point_3&) { return 0; }), 1, many).mesh.triangles, IsEmpty());
  EXPECT_THROW(level_surface(volume({1, 1, 1}, [](const Point_3&) { return 1; }), 1, 5), std::length_error);
}

TEST(Otsu, PartsTwoHeaps) {
  std::vector<float> values;
  for (int i = 0; i < 1000; ++i) values.push_back(static_cast<float>(i % 10) / 10);
  for (int i = 0; i < 300; ++i) values.push_back(static_cast<float>(7 + i % 3));
  EXPECT_GT(otsu_threshold(values), 0.9);
  EXPECT_LT(otsu_threshold(values), 7);
  EXPECT_EQ(otsu_threshold(std::vector<float>{4, 4}), 4);
}

/// A file with the numbers of a ball of the radius 4, in the middle of 11 x 11 x 11 of them, that is 100 inside.
std::string inr(const std::string& type, std::size_t bytes, bool is_big_endian, const std::string& dimensions = {}) {
  std::string text = "#INRIMAGE-4#{\n" +
                     (dimensions.empty() ? std::string("XDIM=11\nYDIM=11\nZDIM=11\n") : dimensions) +
                     "VDIM=1\nTYPE=" + type + "\nPIXSIZE=" + std::to_string(8 * bytes) +
                     " bits\nSCALE=2**0\nCPU=" + (is_big_endian ? "sun" : "decm") + "\nVX=2\nVY=2\nVZ=2\n";
  text.resize(252, '\n');
  text += "##}\n";
  for (int i = 0; i < 11 * 11 * 11; ++i) {
    const double x = i % 11 - 5;
    const double y = i / 11 % 11 - 5;
    const double z = i / 121 - 5;
    const bool is_inside = x * x + y * y + z * z <= 16;
    const double value = is_inside ? 100 : type == "unsigned fixed" ? 3 : -20;
    std::uint64_t bits = type != "float" ? static_cast<std::uint64_t>(static_cast<std::int64_t>(value))
                         : bytes == 8    ? std::bit_cast<std::uint64_t>(value)
                                         : std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (std::size_t b = 0; b < bytes; ++b)
      text += static_cast<char>(bits >> 8 * (is_big_endian ? bytes - 1 - b : b) & 0xFFU);
  }
  return text;
}

TEST(Inr, EveryTypeOfNumbersGivesTheSurface) {
  const Temporary_folder folder(spatial_formats());
  for (const auto& [type, bytes] : {std::pair{"float", 4U},
                                    {"float", 8U},
                                    {"unsigned fixed", 1U},
                                    {"unsigned fixed", 2U},
                                    {"signed fixed", 1U},
                                    {"signed fixed", 2U},
                                    {"signed fixed", 4U}}) {
    for (const bool is_big_endian : {false, true}) {
      SCOPED_TRACE(std::string(type) + " " + std::to_string(bytes) + (is_big_endian ? " big" : " little"));
      const File_contents contents = folder.read("a.inr", inr(type, bytes, is_big_endian));
      const auto mesh = contents.inputs.get(mesh_input);
      ASSERT_NE(mesh, nullptr);
      expect_closed_manifold(*mesh);
      EXPECT_EQ(euler(*mesh), 2);
      for (const Point_3& p : mesh->vertices) {
        EXPECT_GT(distance(p, {10, 10, 10}), 6.5);
        EXPECT_LT(distance(p, {10, 10, 10}), 10);
      }
      ASSERT_THAT(contents.warnings, SizeIs(1));
      EXPECT_THAT(contents.warnings[0], HasSubstr("to 100, reach "));
    }
  }
}

TEST(Inr, SaysWhatIsWrong) {
  const Temporary_folder folder(spatial_formats());
  const std::string good = inr("float", 4, false);
  const auto error = [&](const std::string& text) { return folder.error("a.inr", text); };
  EXPECT_THAT(error("hello"), HasSubstr("expected '#INRIMAGE-4#{' at its start, found 'hello'"));
  EXPECT_THAT(error(good.substr(0, 200)), HasSubstr("the file is cut off"));
  EXPECT_THAT(error(good.substr(0, good.size() - 1)), HasSubstr("expected 1331 numbers of 4 bytes"));
  EXPECT_THAT(error(inr("packed", 4, false)), HasSubstr("expected TYPE=float"));
  EXPECT_THAT(error(inr("float", 2, false)), HasSubstr("expected PIXSIZE=32 or 64 bits"));
  EXPECT_THAT(error(inr("float", 4, false, "XDIM=11\nYDIM=11\n")), HasSubstr("expected ZDIM in the header"));
  EXPECT_THAT(error(inr("float", 4, false, "XDIM=0\nYDIM=11\nZDIM=11\n")), HasSubstr("as XDIM, found '0'"));
  EXPECT_THAT(error(inr("float", 4, false, "XDIM=60000\nYDIM=60000\nZDIM=60000\n")), HasSubstr("numbers of 4 bytes"));
  EXPECT_THAT(error(good.substr(0, 256) + std::string(4 * 1331, '\0')), HasSubstr("found 0 everywhere"));
  EXPECT_THAT(error(good.substr(0, 256) + std::string(4 * 1331, '\xFF')), HasSubstr("expected finite numbers"));
}

}  // namespace
}  // namespace mesecina
