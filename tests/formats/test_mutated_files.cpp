// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ctime>
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

/// A PLY file of a tetrahedron, binary, with the bytes of each number reversed if `is_big_endian`.
std::string binary_ply(bool is_big_endian) {
  std::string text = "ply\nformat binary_";
  text += is_big_endian ? "big" : "little";
  text +=
      "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty double z\nelement face 4\n"
      "property uchar red\nproperty list uchar int vertex_indices\nend_header\n";
  const auto append = [&](auto number) {
    std::array<char, sizeof number> bytes;
    std::memcpy(bytes.data(), &number, sizeof number);
    if (is_big_endian) std::ranges::reverse(bytes);
    text.append(bytes.data(), bytes.size());
  };
  for (int vertex = 0; vertex < 4; ++vertex) {
    append(vertex == 1 ? 1.5F : 0.0F);
    append(vertex == 2 ? 1.5F : 0.0F);
    append(vertex == 3 ? 1.5 : 0.0);
  }
  for (int face = 0; face < 4; ++face) {
    append(std::uint8_t{200});
    append(std::uint8_t{3});
    for (int corner = 0; corner < 3; ++corner) append(std::int32_t{corner < face ? corner : corner + 1});
  }
  return text;
}

/// A binary STL file of two triangles.
std::string binary_stl() {
  std::string text = "solid";
  text.resize(80);
  text.append("\2\0\0\0", 4);
  for (int facet = 0; facet < 2; ++facet) {
    std::array<float, 12> numbers{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    numbers[11] = static_cast<float>(facet);
    std::array<char, sizeof numbers> bytes;
    std::memcpy(bytes.data(), numbers.data(), sizeof numbers);
    text.append(bytes.data(), bytes.size());
    text.append(2, '\0');
  }
  return text;
}

std::vector<Sample> samples_in_space() {
  return {
      {"a.off", "OFF\n# mesh\n5 3 0\n0 0 0\n1.5 0 0\n0 1 0\n1 1e-2 0\n0 0 1\n3 0 1 2\n4 0 1 4 2 255 0 0\n2 0 1\n"},
      {"b.off", "COFF 3 0 0\n1 2 3 255 0 0 255\n3 4 5 0 0 0 0\n5 6 7 1 1 1 1\n"},
      {"a.obj",
       "mtllib a\nv 0 0 0\nv 1 0 0 1\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvt 0 0\nf 1//1 2//1 3//1\nf -1/1 -2/1 -3/1\n"
       "f 1 2 \\\n 3 4\nl 1 2\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
       "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\nelement edge 1\nproperty int "
       "vertex1\nproperty int vertex2\nend_header\n0 0 0 255\n1 0 0 0\n0 1 0 0\n0 0 1 1\n3 0 1 2\n4 0 1 2 3\n0 1\n"},
      {"b.ply",
       "ply\nformat ascii 1.0\nelement vertex 2\nproperty double radius\nproperty double z\nproperty double y\n"
       "property double x\nend_header\n0.5 1 2 3\n1 4 5 6\n"},
      {"c.ply", binary_ply(false)},
      {"d.ply", binary_ply(true)},
      {"a.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nfacet "
       "normal 0 0 1\nouter loop\nvertex 0 1 0\nvertex 1 0 0\nvertex 1 1.5e0 0\nendloop\nendfacet\nendsolid a\n"},
      {"b.stl", binary_stl()},
      {"a.xyz", "# points\n1 2 3 0 0 1\n3.5 -4e-1 2 0 1 0\n5 6 7 1 0 0\n"},
      {"a.pwn", "3\n1 2 3\n3 4 5\n5 6 7\n0 0 1\n0 1 0\n1 0 0\n"},
      {"a.csv", "x,y,z,r\n1,2,3,4\r\n4,5,6,.25\r\n"},
      {"a.cin", "1 2 3 4\n3 4 5 0.25\n"},
      {"a.woff", "WOFF 2 0 0\n1 2 3 4\n4 5 6 7\n"},
      {"a.moff", "MOFF 4 1 1.5\n1 2 3 4\n4 5 6 7\n7 8 9 1\n1 1 1 1\n4 0 1 2 3 60 0.5 1 2 3\n"},
      {"a.ma", "4 3 1\nv 0 0 0 1\nv 1 0 0 .5\nv 0 1 0 .25\nv 0 0 1 1\ne 0 1\ne 1 2\ne 0 2\nf 0 1 2\n"},
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
  const auto is_finite_in_space = [](const Point_3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (const auto cloud = inputs.get(cloud_input)) {
    EXPECT_TRUE(std::ranges::all_of(*cloud, is_finite_in_space));
  }
  if (const auto balls = inputs.get(balls_input)) {
    EXPECT_TRUE(std::ranges::all_of(*balls, [&](const Ball_3& ball) {
      return is_finite_in_space(ball.center) && std::isfinite(ball.radius) && ball.radius >= 0;
    }));
  }
  if (const auto mesh = inputs.get(mesh_input)) {
    EXPECT_TRUE(std::ranges::all_of(mesh->vertices, is_finite_in_space));
    EXPECT_FALSE(mesh->triangles.empty());
    for (const auto& triangle : mesh->triangles) {
      for (const int vertex : triangle) {
        EXPECT_GE(vertex, 0);
        EXPECT_LT(vertex, static_cast<int>(mesh->vertices.size()));
      }
    }
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

void expect_contents_or_errors(const Formats& formats, const std::vector<Sample>& all) {
  const Temporary_folder folder(formats);
  unsigned seed = 0;
  for (const Sample& sample : all) {
    ASSERT_EQ(folder.error(sample.name, sample.text), "");
    Mutator mutator(++seed);
    std::size_t read = 0;
    std::size_t refused = 0;
    for (int round = 0; round < 1000; ++round) {
      const std::string text = mutator.mutated(sample.text);
      SCOPED_TRACE(testing::Message() << sample.name << " " << round << ":\n" << text);
      const auto begin = std::clock();
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
      EXPECT_LT(std::clock() - begin, 2 * CLOCKS_PER_SEC);
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(read, 20u) << sample.name;
    EXPECT_GT(refused, 20u) << sample.name;
  }
}

TEST(Mutated_files, GiveContentsOrAnError) { expect_contents_or_errors(planar_formats(), samples()); }

TEST(Mutated_files, OfSpaceGiveContentsOrAnError) { expect_contents_or_errors(spatial_formats(), samples_in_space()); }

}  // namespace
}  // namespace mesecina
