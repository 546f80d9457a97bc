// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <string>

#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

struct Sample {
  const char* name;
  std::string text;
};

std::vector<Sample> samples() {
  return {
      {"a.xy", "# points\nx y\n1 2\n3.5 -4e-1\n5 6\n"},
      {"a.csv", "x,y,r\n1,2,3\r\n4,5,.25\r\n"},
      {"a.xyz", "1 2 0\n3 4 0\n5 6 0\n"},
      {"a.poff", "POFF 3 0 0\n1 2\n3 4\n5 6\n"},
      {"a.wpoff", "WPOFF 2 0 0\n1 2 3\n4 5 6\n"},
      {"a.wkt",
       "SRID=4326;MULTIPOLYGON(((0 0,9 0,9 9,0 9,0 0),(1 1,1 3,3 3,1 1)))\nPOINT Z(1 2 3)\n"
       "GEOMETRYCOLLECTION(LINESTRING(0 0,1 0,1 1,0 0),MULTIPOINT((1 2),(3 4)))\n"},
      {"a.svg",
       "<?xml version='1.0'?><!DOCTYPE svg [<!ENTITY a 'b'>]>\n<svg viewBox='0 0 9 9'><!-- c --><g "
       "transform='rotate(30 1 "
       "2) matrix(1 0 0 1 5 5)' style='fill:red'><path d='M1 1h2.5.5v3C1 2 3 4 5 6s1 2 3 4q1 1 2 2t3 3A3 2 15 "
       "1 0 2 2z m1-1l5 5 5-6z'/></g><rect x='1' y='2' width='3mm' height='4' rx='1'/><circle cx='4' cy='4' "
       "r='2'/><ellipse rx='3' ry='1'/><polygon points='0,0 1,0 1,1&#32;'/></svg>\n"},
      {"a.geojson",
       "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"geometry\":{\"type\":\"Polygon\","
       "\"coordinates\":[[[0,0],[9,0,1],[9,9],[0,0]],[[1,1],[1,2.5],[2,2e0],[1,1]]]}},\n{\"type\":\"Feature\","
       "\"geometry\":{\"type\":\"MultiPoint\",\"coordinates\":[[1,2],[3,4]]}}]}\n"},
  };
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutated(std::string text) {
    for (std::size_t edits = 1 + below(4); edits > 0; --edits) edit(text);
    return text;
  }

 private:
  std::size_t below(std::size_t bound) { return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random_); }

  void edit(std::string& text) {
    using namespace std::string_literals;
    static const std::array insertions = {"1e999"s,
                                          "-"s,
                                          "nan"s,
                                          "inf"s,
                                          "1e308"s,
                                          "-1e308"s,
                                          "1e-320"s,
                                          "("s,
                                          ")"s,
                                          "[[[["s,
                                          "]"s,
                                          ","s,
                                          ";"s,
                                          "\""s,
                                          "'"s,
                                          "<"s,
                                          ">"s,
                                          "</g>"s,
                                          "<g>"s,
                                          "&"s,
                                          "EMPTY"s,
                                          "M"s,
                                          "A1"s,
                                          "z"s,
                                          "\n"s,
                                          "\r\n"s,
                                          "\0"s,
                                          "\xFF\xFE"s,
                                          "99999999999999999999"s,
                                          "#"s,
                                          "//"s,
                                          "<!--"s,
                                          "{"s,
                                          "}"s};
    const std::size_t place = below(text.size() + 1);
    const std::size_t length = std::min(text.size() - place, below(10));
    switch (below(6)) {
      case 0:
        text.insert(place, insertions[below(insertions.size())]);
        break;
      case 1:
        text.erase(place, length);
        break;
      case 2:
        text.insert(below(text.size() + 1), text.substr(place, below(60)));
        break;
      case 3:
        if (place < text.size()) text[place] = static_cast<char>(below(256));
        break;
      case 4:
        if (place < text.size()) text[place] = static_cast<char>('0' + below(10));
        break;
      default:
        if (below(4) == 0) text.resize(place);
    }
  }

  std::mt19937 random_;
};

void expect_finite(const Inputs& inputs) {
  const auto is_finite = [](const Point_2& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  if (const auto points = inputs.get(points_input)) {
    EXPECT_TRUE(std::ranges::all_of(*points, is_finite));
  }
  if (const auto disks = inputs.get(disks_input)) {
    EXPECT_TRUE(std::ranges::all_of(*disks, [&](const Disk_2& disk) {
      return is_finite(disk.center) && std::isfinite(disk.radius) && disk.radius >= 0;
    }));
  }
  if (const auto outline = inputs.get(outline_input)) {
    for (const Ring_2& ring : outline->rings) {
      EXPECT_GE(ring.size(), 3u);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        EXPECT_TRUE(is_finite(ring[i]));
        EXPECT_NE(ring[i], ring[(i + 1) % ring.size()]);
      }
    }
  }
}

TEST(Mutated_files, GiveContentsOrAnError) {
  const Temporary_folder folder;
  unsigned seed = 0;
  for (const Sample& sample : samples()) {
    ASSERT_EQ(folder.error(sample.name, sample.text), "");
    Mutator mutator(++seed);
    std::size_t read = 0;
    std::size_t refused = 0;
    for (int round = 0; round < 1000; ++round) {
      const std::string text = mutator.mutated(sample.text);
      SCOPED_TRACE(testing::Message() << sample.name << " " << round << ":\n" << text);
      const auto begin = std::chrono::steady_clock::now();
      try {
        const File_contents contents = folder.read(sample.name, text);
        EXPECT_FALSE(contents.inputs.is_empty());
        expect_finite(contents.inputs);
        ++read;
      } catch (const File_error& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(": expected "), std::string::npos) << message;
        EXPECT_NE(message.find("found "), std::string::npos) << message;
        EXPECT_NE(message.find("; "), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_LT(message.size(), 400u) << message;
        ++refused;
      }
      EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
      if (HasFailure()) return;
    }
    EXPECT_GT(read, 20u) << sample.name;
    EXPECT_GT(refused, 20u) << sample.name;
  }
}

}  // namespace
}  // namespace mesecina
