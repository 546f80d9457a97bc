// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/input_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "core/formats/durable_file.h"
#include "core/formats/format.h"
#include "core/formats/input_json.h"

namespace mesecina {
namespace {

using testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();

Inputs one_of_each() {
  Image image{2, 3, {}, {-1.5, 0.1}, 0.3};
  for (int i = 0; i < 24; ++i) image.rgba.push_back(static_cast<std::uint8_t>(11 * i));
  return Inputs()
      .with(points_input, std::vector<Point_2>{{0.1, -0.0}, {infinity, 5e-324}})
      .with(disks_input, std::vector<Disk_2>{{{1, 2}, 1.0 / 3}})
      .with(outline_input, Outline_2{{{{0, 0}, {1, 0}, {0, 1}}, {}, {{0.1, 7}}}})
      .with(image_input, image)
      .with(mesh_input, Triangle_mesh_3{{{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}, {2, 1, 0}}})
      .with(balls_input, std::vector<Ball_3>{{{0.1, 0.2, 0.3}, 1e-5}})
      .with(cloud_input, std::vector<Point_3>{})
      .with(Input_key<std::vector<Point_2>>{"landmarks"}, std::vector<Point_2>{{3, 4}});
}

std::string bytes_of(const Inputs& inputs, std::string_view id) {
  std::ostringstream stream;
  write_input_bytes(stream, inputs, id);
  return stream.str();
}

std::string message_of(std::string_view bytes) {
  try {
    with_input_bytes({}, "x", bytes);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Input_bytes, every_type_reads_back_to_the_last_bit) {
  const Inputs inputs = one_of_each();
  for (const std::string& id : inputs.ids()) {
    const std::string bytes = bytes_of(inputs, id);
    EXPECT_TRUE(is_input_bytes(bytes)) << id;
    const Inputs back = with_input_bytes(Inputs(), id, bytes);
    EXPECT_EQ(bytes_of(back, id), bytes) << id;
    // JSON tells all numbers apart, and knows the type.
    std::string json;
    std::string json_back;
    append_input_json(json, inputs, id);
    append_input_json(json_back, back, id);
    EXPECT_EQ(json, json_back) << id;
  }
  EXPECT_FALSE(is_input_bytes("[1, 2]"));
  EXPECT_THROW(bytes_of(Inputs().with(Input_key<int>{"strange"}, 3), "strange"), std::invalid_argument);
}

TEST(Input_bytes, no_damaged_byte_is_taken) {
  const Inputs inputs = one_of_each();
  for (const char* id : {"points", "outline", "mesh", "image"}) {
    const std::string bytes = bytes_of(inputs, id);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      std::string changed = bytes;
      changed[i] = static_cast<char>(changed[i] ^ 4);
      EXPECT_NE(message_of(changed), "none") << id << ' ' << i;
      EXPECT_NE(message_of(bytes.substr(0, i)), "none") << id << ' ' << i;
    }
    EXPECT_NE(message_of(bytes + "."), "none");
  }
  EXPECT_THAT(message_of("mesecina-input 1 points\n\1\2\3\4...."), HasSubstr("another byte order"));
  EXPECT_THAT(message_of("mesecina-input 2 points\n"), HasSubstr("damaged"));
}

TEST(Input_bytes, corners_that_are_no_vertices_are_refused) {
  for (const int corner : {-1, 3}) {
    const Triangle_mesh_3 mesh{{{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}}, {{0, 1, corner}}};
    EXPECT_THAT(message_of(bytes_of(Inputs().with(mesh_input, mesh), "mesh")), HasSubstr("a corner that is no vertex"));
  }
}

TEST(Input_bytes, pixels_that_do_not_fill_the_picture_are_refused) {
  const Image image{2, 2, {1, 2, 3, 4}, {}, 1};
  EXPECT_THAT(message_of(bytes_of(Inputs().with(image_input, image), "image")), HasSubstr("number of pixels"));
}

TEST(Durable_file, is_whole_or_as_it_was) {
  std::string name = (std::filesystem::temp_directory_path() / "mesecina-durable-XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(name.data());
  const auto file = folder / "file";
  write_file_durably(file, [](std::ostream& stream) { stream << "first"; });
  const auto fail = [](std::ostream& stream) {
    stream << "half";
    throw std::runtime_error("no");
  };
  EXPECT_THROW(write_file_durably(file, fail), std::runtime_error);
  std::ifstream stream(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "first");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  EXPECT_THROW(write_file_durably(folder / "none" / "file", [](std::ostream&) {}), File_error);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace mesecina
