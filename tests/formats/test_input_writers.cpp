// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const Input_writer& find_writer(const Formats& formats, std::string_view name) {
  return *std::ranges::find(formats.input_writers, name, &Input_writer::name);
}

class Input_writers : public testing::Test {
 protected:
  std::string text(std::string_view format, const Inputs& inputs) const {
    std::ostringstream stream;
    find_writer(formats_, format).write(stream, inputs);
    return stream.str();
  }
  File_contents round_trip(std::string_view format, const Inputs& inputs) const {
    return folder_.read("a." + find_writer(formats_, format).extension, text(format, inputs));
  }

  Formats formats_ = planar_formats();
  Temporary_folder folder_;
};

std::vector<double> awkward_numbers() {
  std::vector<double> numbers = {0, -0.0, 0.1, 1. / 3, 1e300, -1e300, 5e-324, 123456789.123456789, 1e-10, 1e22};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1000, 1000);
  while (numbers.size() < 1000) numbers.push_back(uniform(random));
  return numbers;
}

TEST_F(Input_writers, PointsAndDisksComeBackExactly) {
  const std::vector<double> numbers = awkward_numbers();
  std::vector<Point_2> points;
  std::vector<Disk_2> disks;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Point_2 p{numbers[i], numbers[numbers.size() - 1 - i]};
    points.push_back(p);
    disks.push_back({p, std::abs(numbers[(i * 7) % numbers.size()])});
  }
  const Inputs inputs = Inputs().with(points_input, points).with(disks_input, disks);
  for (const char* format : {"xy", "poff"}) {
    const File_contents contents = round_trip(format, inputs);
    EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{"points"});
    EXPECT_EQ(*contents.inputs.get(points_input), points) << format;
    EXPECT_TRUE(contents.warnings.empty());
  }
  for (const char* format : {"wpoff", "csv"}) {
    const File_contents contents = round_trip(format, inputs);
    EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{"disks"});
    EXPECT_EQ(*contents.inputs.get(disks_input), disks) << format;
    EXPECT_TRUE(contents.warnings.empty());
  }
}

TEST_F(Input_writers, EmptyInputsComeBack) {
  const Inputs inputs = Inputs()
                            .with(points_input, std::vector<Point_2>())
                            .with(disks_input, std::vector<Disk_2>())
                            .with(outline_input, Outline_2());
  for (const Input_writer& writer : formats_.input_writers) {
    const File_contents contents = round_trip(writer.name, inputs);
    EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{writer.input_id}) << writer.name;
    EXPECT_EQ(text(writer.name, Inputs()), text(writer.name, inputs));
  }
}

TEST_F(Input_writers, Texts) {
  const Inputs inputs =
      Inputs().with(points_input, std::vector<Point_2>{{1, 2.5}}).with(disks_input, std::vector<Disk_2>{{{1, 2.5}, 3}});
  EXPECT_EQ(text("xy", inputs), "1 2.5\n");
  EXPECT_EQ(text("poff", inputs), "POFF 1 0 0\n1 2.5\n");
  EXPECT_EQ(text("wpoff", inputs), "WPOFF 1 0 0\n1 2.5 3\n");
  EXPECT_EQ(text("csv", inputs), "x,y,r\n1,2.5,3\n");
}

TEST_F(Input_writers, NestedRingsArePolygonsWithHoles) {
  const Outline_2 outline{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{1, 1}, {1, 3}, {3, 3}}, {{20, 0}, {21, 0}, {21, 1}}}};
  const Inputs inputs = Inputs().with(outline_input, outline);
  EXPECT_EQ(text("wkt", inputs), "MULTIPOLYGON (((0 0,9 0,9 9,0 9,0 0),(1 1,1 3,3 3,1 1)),((20 0,21 0,21 1,20 0)))\n");
  EXPECT_EQ(text("geojson", inputs),
            R"({"type":"MultiPolygon","coordinates":[[[[0,0],[9,0],[9,9],[0,9],[0,0]],[[1,1],[1,3],[3,3],[1,1]]],)"
            "[[[20,0],[21,0],[21,1],[20,0]]]]}\n");
  const Inputs one = Inputs().with(outline_input, Outline_2{{outline.rings[0], outline.rings[1]}});
  EXPECT_EQ(text("wkt", one), "POLYGON ((0 0,9 0,9 9,0 9,0 0),(1 1,1 3,3 3,1 1))\n");
}

TEST_F(Input_writers, OutlinesComeBackExactly) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 50; ++round) {
    Outline_2 outline;
    for (int island = 0; island < 5; ++island) {
      const Point_2 center{20. * island + uniform(random), uniform(random)};
      for (int depth = 0; depth < 1 + round % 4; ++depth) {
        Ring_2 ring;
        const int count = 8 + round;
        const double turn = uniform(random);
        for (int i = 0; i < count; ++i) {
          const double angle = turn + i * 2 * std::numbers::pi / count;
          const double radius = std::pow(0.4, depth) * (4 + 0.5 * uniform(random));
          ring.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
        }
        if (uniform(random) > 0) std::ranges::reverse(ring);
        outline.rings.push_back(ring);
      }
    }
    for (const char* format : {"wkt", "geojson"}) {
      const File_contents contents = round_trip(format, Inputs().with(outline_input, outline));
      EXPECT_TRUE(contents.warnings.empty()) << contents.warnings.front();
      EXPECT_EQ(*contents.inputs.get(outline_input), outline) << format;
    }
  }
}

TEST_F(Input_writers, HolesFollowTheirOuterRing) {
  const Ring_2 hole = {{1, 1}, {1, 3}, {3, 3}};
  const Ring_2 island = {{20, 0}, {21, 0}, {21, 1}};
  const Ring_2 outer = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const Inputs inputs = Inputs().with(outline_input, Outline_2{{hole, island, outer}});
  for (const char* format : {"wkt", "geojson"})
    EXPECT_THAT(round_trip(format, inputs).inputs.get(outline_input)->rings, ElementsAre(island, outer, hole));
}

TEST_F(Input_writers, CrossingRingsComeBackExactly) {
  const Outline_2 outline{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {{0, 0}, {9, 0}, {9, 9}}, {{5, 1}, {12, 1}, {8, 2}}}};
  for (const char* format : {"wkt", "geojson"}) {
    const File_contents contents = round_trip(format, Inputs().with(outline_input, outline));
    EXPECT_EQ(*contents.inputs.get(outline_input), outline) << format;
    EXPECT_THAT(contents.warnings, ElementsAre(StartsWith("outline crosses itself"))) << format;
  }
  EXPECT_THAT(text("wkt", Inputs().with(outline_input, outline)), HasSubstr("\nPOLYGON ((0 0,9 0,9 9,0 0))\n"));
}

}  // namespace
}  // namespace mesecina
