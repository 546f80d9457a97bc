// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Numbers as bytes, of either order.
class Bytes {
 public:
  explicit Bytes(bool is_big_endian) : is_big_endian_(is_big_endian) {}

  template <class... Number>
  Bytes& add(Number... numbers) {
    (add_one(numbers), ...);
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  template <class Number>
  void add_one(Number number) {
    std::array<char, sizeof number> bytes;
    std::memcpy(bytes.data(), &number, sizeof number);
    if (is_big_endian_) std::ranges::reverse(bytes);  // this test is only for little-endian machines
    text_.append(bytes.data(), bytes.size());
  }

  bool is_big_endian_;
  std::string text_;
};

std::string binary_header(bool is_big_endian, const std::string& rest) {
  return std::string("ply\nformat binary_") + (is_big_endian ? "big" : "little") + "_endian 1.0\n" + rest +
         "end_header\n";
}

const Triangle_mesh_3 two_triangles{{{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}}, {{0, 1, 2}, {0, 2, 3}}};

class Ply_reader_test : public testing::Test {
 protected:
  void expect_square(const std::string& text) const {
    const File_contents contents = folder_.read("a.ply", text);
    ASSERT_EQ(contents.inputs.ids(), std::vector<std::string>{"mesh"});
    EXPECT_EQ(*contents.inputs.get(mesh_input), two_triangles);
    EXPECT_THAT(contents.warnings, IsEmpty());
  }
  void expect_error(const std::string& text, int line, std::string_view expected, std::string_view found) const {
    std::string start = "a.ply";
    if (line != 0) start.append(":").append(std::to_string(line));
    start += ": expected ";
    EXPECT_THAT(folder_.error("a.ply", text), AllOf(StartsWith(start), HasSubstr(std::string(expected)),
                                                    HasSubstr(std::string(", found ").append(found)), HasSubstr("; ")));
  }

  Temporary_folder folder_{spatial_formats()};
};

TEST_F(Ply_reader_test, Text) {
  expect_square(
      "ply\nformat ascii 1.0\ncomment made by hand\nobj_info x\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0.5\n1 0 0.5\n1 1 "
      "0.5\n"
      "0 1 0.5\n3 0 1 2\n3 0 2 3\n");
  // Other types and orders, faces first, a polygon, further properties and lists.
  expect_square(
      "ply\r\nformat ascii 1.0\r\nelement face 1\r\nproperty uchar flag\r\nproperty list int short vertex_index\r\n"
      "property list uchar float texcoord\r\nelement vertex 4\r\nproperty list uchar uchar tags\r\nproperty double "
      "z\r\n"
      "property int8 y\r\nproperty uint16 x\r\nproperty float quality\r\nend_header\r\n7 4 0 1 2 3 2 0.5 0.5\r\n"
      "0 .5 0 0 nan\r\n2 1 2 .5 0 1 inf\r\n1 9 .5 1 1 0\r\n0 .5 1 0 0\r\n");
}

TEST_F(Ply_reader_test, Binary) {
  for (const bool big : {false, true}) {
    std::string text = binary_header(big,
                                     "element vertex 4\nproperty float x\nproperty double y\nproperty uchar red\n"
                                     "property float z\nelement face 1\nproperty list uchar uint vertex_indices\n");
    Bytes bytes(big);
    for (const Point_3& p : two_triangles.vertices)
      bytes.add(static_cast<float>(p.x), p.y, std::uint8_t{255}, static_cast<float>(p.z));
    bytes.add(std::uint8_t{4}, std::uint32_t{0}, std::uint32_t{1}, std::uint32_t{2}, std::uint32_t{3});
    expect_square(text + bytes.text());
    expect_square(text + bytes.text() + "\r\n");
    EXPECT_THAT(folder_.read("a.ply", text + bytes.text() + "?").warnings,
                ElementsAre("what follows the last element of the header is not read"));
    // Cut off at any byte, it is refused.
    for (std::size_t size = 1; size < bytes.text().size(); ++size)
      expect_error(text + bytes.text().substr(0, size), 0, " bytes in row ", "");
  }
}

TEST_F(Ply_reader_test, BinaryOfEveryType) {
  for (const bool big : {false, true}) {
    const std::string header =
        binary_header(big,
                      "element vertex 1\nproperty char a\nproperty short x\nproperty ushort b\nproperty int "
                      "y\nproperty list ushort short "
                      "c\nproperty uint z\nproperty uint8 d\nproperty int16 e\nproperty float64 radius\n");
    Bytes bytes(big);
    bytes.add(std::int8_t{-1}, std::int16_t{-300}, std::uint16_t{60000}, std::int32_t{-70000}, std::uint16_t{2},
              std::int16_t{1}, std::int16_t{2}, std::uint32_t{4000000000U}, std::uint8_t{200}, std::int16_t{-5}, 0.25);
    const auto balls = folder_.read("a.ply", header + bytes.text()).inputs.get(balls_input);
    ASSERT_TRUE(balls);
    EXPECT_THAT(*balls, ElementsAre(Ball_3{{-300, -70000, 4e9}, 0.25}));
  }
}

TEST_F(Ply_reader_test, WithoutFaces) {
  const std::string start =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
  const auto cloud = folder_.read("a.ply", start + "end_header\n1 2 3\n4 5 6\n");
  EXPECT_EQ(cloud.inputs.ids(), std::vector<std::string>{"cloud"});
  EXPECT_THAT(*cloud.inputs.get(cloud_input), ElementsAre(Point_3{1, 2, 3}, Point_3{4, 5, 6}));
  const auto balls = folder_.read("a.ply", start + "property float radius\nend_header\n1 2 3 0\n4 5 6 7\n");
  EXPECT_EQ(balls.inputs.ids(), std::vector<std::string>{"balls"});
  EXPECT_THAT(*balls.inputs.get(balls_input), ElementsAre(Ball_3{{1, 2, 3}, 0}, Ball_3{{4, 5, 6}, 7}));
  const auto edges =
      folder_.read("a.ply", start +
                                "property float radius\nelement edge 1\nproperty int vertex1\nproperty int "
                                "vertex2\nelement face 0\nproperty list uchar int vertex_indices\n"
                                "end_header\n1 2 3 0\n4 5 6 7\n0 1\n");
  EXPECT_EQ(edges.inputs.ids(), std::vector<std::string>{"balls"});
  EXPECT_THAT(edges.warnings, ElementsAre("1 row of 'edge' are not read"));
}

TEST_F(Ply_reader_test, RadiiOfAMeshAreLeftOutWithAWarning) {
  const auto contents = folder_.read(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float "
      "radius\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n");
  EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{"mesh"});
  EXPECT_THAT(contents.warnings, ElementsAre("radii of vertices are not read, as there are faces"));
}

TEST_F(Ply_reader_test, HeaderErrors) {
  expect_error("plyx\n", 1, "'ply' in the first line", "'plyx'");
  expect_error("ply\nformat ascii 2.0\nend_header\n", 2, "'format ascii 1.0'", "'format ascii 2.0'");
  expect_error("ply\nend_header\n", 2, "a line 'format ...'", "'end_header'");
  expect_error("ply\nformat ascii 1.0\nelement vertex -1\n", 3, "'element NAME COUNT'", "'element vertex -1'");
  expect_error("ply\nformat ascii 1.0\nproperty float x\n", 3, "'element NAME COUNT' before", "'property float x'");
  expect_error("ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n", 4, "a type of PLY", "'real'");
  expect_error("ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar x\n", 4, "'property TYPE NAME'",
               "'property list uchar x'");
  expect_error("ply\nformat ascii 1.0\nvertex 1\n", 3, "format, element, property", "'vertex 1'");
  expect_error("ply\nformat ascii 1.0\nelement vertex 1\n", 3, "a header that ends with 'end_header'", "no such line");
  expect_error("ply\nformat ascii 1.0\nend_header\n", 0, "an element 'vertex'", "a header without");
  expect_error("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n", 0, "x, y and z", "a header");
}

TEST_F(Ply_reader_test, TextErrors) {
  const auto file = [](const std::string& vertices, const std::string& faces) {
    return "ply\nformat ascii 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nproperty float radius\nelement face " + faces;
  };
  const std::string list = "\nproperty list uchar int vertex_indices\nend_header\n";
  expect_error(file("2", "0") + list + "0 0 0 0\n", 11, "2 rows of 'vertex'", "1");
  expect_error(file("99999999999", "0") + list + "0 0 0 0\n", 0, "fewer than 2^31 vertices", "a header");
  expect_error(file("2000000000", "0") + list + "0 0 0 0\n", 11, "2000000000 rows of 'vertex'", "1");
  expect_error(file("1", "0") + list + "0 0 nan 0\n", 11, "a finite number for z", "'nan'");
  expect_error(file("1", "0") + list + "0 0 0 -1\n", 11, "a radius of at least 0", "-1");
  expect_error(file("1", "0") + list + "0 0 0 1 5\n", 11, "the end of the line", "'5'");
  expect_error(file("1", "1") + list + "0 0 0 0\n3 0 0 1\n", 12, "a vertex number from 0 to 0", "1");
  expect_error(file("1", "1") + list + "0 0 0 0\n3 0 0 -1\n", 12, "a vertex number from 0 to 0", "-1");
  expect_error(file("1", "1") + list + "0 0 0 0\n3 0 0 0.5\n", 12, "a vertex number from 0 to 0", "0.5");
  expect_error(file("1", "1") + list + "0 0 0 0\n-3 0 0 0\n", 12, "an integer of at least 0 for the length", "-3");
  expect_error(file("1", "1") + list + "0 0 0 0\n1e300 0 0 0\n", 12, "an integer of at least 0 for the length",
               "1e+300");
  expect_error(file("1", "1") + "\nproperty int a\nend_header\n0 0 0 0\n3\n", 0, "'list vertex_indices' of 'face'",
               "a");
}

TEST_F(Ply_reader_test, BinaryErrors) {
  for (const bool big : {false, true}) {
    const std::string vertices = "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string header = binary_header(big, vertices + "element face 1\nproperty list int int vertex_indices\n");
    const std::string vertex = Bytes(big).add(0.0F, 0.0F, 0.0F).text();
    const auto with_face = [&](auto... numbers) { return header + vertex + Bytes(big).add(numbers...).text(); };
    expect_error(with_face(std::int32_t{-3}, 0, 0, 0), 0, "an integer of at least 0 for the length of a list in row 1",
                 "-3");
    expect_error(with_face(std::int32_t{2'000'000'000}, 0, 0, 0), 0, "1 number of 4 bytes in row 1 of 'face'",
                 "0 bytes");
    expect_error(with_face(std::int32_t{3}, 0, 0, 1), 0, "a vertex number from 0 to 0 in row 1 of 'face'", "1");
    expect_error(with_face(std::int32_t{3}, 0, 0, -7), 0, "a vertex number from 0 to 0 in row 1 of 'face'", "-7");
    expect_error(header + Bytes(big).add(0.0F, std::numeric_limits<float>::infinity(), 0.0F).text(), 0,
                 "a finite number for y in row 1 of 'vertex'", "inf");
    const std::string skipped = binary_header(big, vertices + "element strip 1\nproperty list uint double a\n");
    expect_error(skipped + vertex + Bytes(big).add(std::uint32_t{4'000'000'000U}, 1.0).text(), 0,
                 "4000000000 numbers of 8 bytes", "8 bytes");
    // An element without properties has no bytes, however many there are of it.
    EXPECT_TRUE(folder_.read("a.ply", binary_header(big, vertices + "element none 9000000000000000000\n") + vertex)
                    .inputs.get(cloud_input));
  }
}

}  // namespace
}  // namespace mesecina
