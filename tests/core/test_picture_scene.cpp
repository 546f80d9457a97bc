// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/picture_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/formats/packed_bytes.h"

namespace mesecina {
namespace {

using testing::HasSubstr;

/// Of one white pixel.
const std::string png =
    from_base64("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR4nGP4////fwAJ+wP9KobjigAAAABJRU5ErkJggg==");
const std::string svg = "<?xml version=\"1.0\"?>\n<svg width=\"3\">\n<g/></svg>\n";
const std::string pdf = "%PDF-1.4\n1 0 obj\n<<>>\nendobj\nxref\n0 1\ntrailer\n<<>>\nstartxref\n29 \n%%EOF\n";

std::string long_scene() {
  std::string scene = "{\"numbers\": [";
  for (int i = 0; i < 5000; ++i) scene += std::to_string(i * 7919 % 5003) + ",";
  return scene + "0]}";
}

TEST(Packed_bytes_test, read_back) {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(from_base64(to_base64(bytes)), bytes);
    EXPECT_EQ(inflated(deflated(bytes), 1000), bytes);
    bytes += static_cast<char>(i * 37);
  }
  EXPECT_EQ(to_base64("Man"), "TWFu");
  EXPECT_EQ(to_base64("Ma"), "TWE=");
  EXPECT_EQ(to_base64("M"), "TQ==");
}

TEST(Packed_bytes_test, anything_else_is_refused) {
  EXPECT_THROW(from_base64("abc"), std::invalid_argument);
  EXPECT_THROW(from_base64("ab!="), std::invalid_argument);
  EXPECT_THROW(from_base64("a=bc"), std::invalid_argument);
  EXPECT_THROW(inflated("no stream", 100), std::invalid_argument);
  const std::string stream = deflated(std::string(1000, 'x'));
  EXPECT_THROW(inflated(stream.substr(0, stream.size() - 5), 1000), std::invalid_argument);
  EXPECT_THROW(inflated(stream, 999), std::invalid_argument);
  EXPECT_EQ(inflated(stream, 1000).size(), 1000u);
}

TEST(Picture_scene_test, scenes_come_back) {
  for (const std::string& picture : {png, svg, pdf}) {
    for (const std::string& scene : {std::string("{}"), long_scene()}) {
      const std::string with_scene = picture_with_scene(picture, scene);
      EXPECT_EQ(scene_of_picture(with_scene), scene);
      EXPECT_FALSE(scene_of_picture(picture));
    }
  }
  EXPECT_FALSE(scene_of_picture("GIF89a"));
  EXPECT_FALSE(scene_of_picture(""));
  EXPECT_THROW(picture_with_scene("GIF89a", "{}"), std::invalid_argument);
}

TEST(Picture_scene_test, pdf_says_where_its_table_is) {
  const std::string with_scene = picture_with_scene(pdf, long_scene());
  const std::size_t start = with_scene.find("startxref\n") + 10;
  EXPECT_EQ(with_scene.substr(std::stoul(with_scene.substr(start)), 4), "xref");
  EXPECT_TRUE(with_scene.starts_with(pdf.substr(0, 29)));
  std::size_t line = 0;
  for (std::size_t end; (end = with_scene.find('\n', line)) != std::string::npos; line = end + 1)
    EXPECT_LE(end - line, 255u);
}

TEST(Picture_scene_test, damaged_scenes_are_told) {
  std::string with_scene = picture_with_scene(svg, long_scene());
  with_scene.erase(with_scene.find("</metadata>") - 40, 40);
  EXPECT_THROW(scene_of_picture(with_scene), std::invalid_argument);
  const std::string cut = picture_with_scene(png, long_scene()).substr(0, 300);
  EXPECT_FALSE(scene_of_picture(cut));
}

}  // namespace
}  // namespace mesecina
