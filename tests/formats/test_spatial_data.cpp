// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/formats/format.h"

namespace mesecina {
namespace {

class Spatial_data : public testing::Test {
 protected:
  void SetUp() override {
    const char* data = std::getenv("MESECINA_DATA");
    if (!data || !*data) GTEST_SKIP() << "set MESECINA_DATA to a folder with real shapes in its subfolder 3d";
    folder_ = std::filesystem::path(data) / "3d";
  }
  std::filesystem::path folder_;
};

TEST_F(Spatial_data, EveryFileOfAKnownExtensionIsRead) {
  const Formats formats = spatial_formats();
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (!formats.reader_for(entry.path())) continue;
    SCOPED_TRACE(entry.path());
    File_contents contents;
    ASSERT_NO_THROW(contents = read_file(formats, entry.path()));
    EXPECT_EQ(contents.inputs.ids().size(), 1u);
    ++count;
  }
  EXPECT_GE(count, 20u);
}

TEST_F(Spatial_data, HasTheNumbersItIsKnownToHave) {
  const Formats formats = spatial_formats();
  const auto triangles = [&](const char* name) {
    return read_file(formats, folder_ / name).inputs.get(mesh_input)->triangles.size();
  };
  EXPECT_EQ(triangles("elephant.off"), 5558u);
  EXPECT_EQ(triangles("armadillo.obj"), 29170u);
  EXPECT_EQ(triangles("tray_bottom.stl"), 4520u);
  EXPECT_EQ(triangles("bad_conrod_misoriented.stl"), 6442u);
  // Closed and of genus 23 only if its equal points were welded.
  const auto tray = read_file(formats, folder_ / "tray_bottom.stl").inputs.get(mesh_input);
  EXPECT_EQ(static_cast<int>(tray->vertices.size()) - 4520 / 2, 2 - 2 * 23);
  EXPECT_EQ(read_file(formats, folder_ / "points_kitten.xyz").inputs.get(cloud_input)->size(), 5210u);
  // Closed: as many edges as one and a half times the triangles.
  const auto skull = read_file(formats, folder_ / "image_skull_2.9.inr").inputs.get(mesh_input);
  EXPECT_GT(skull->triangles.size(), 20000u);
  EXPECT_EQ(skull->triangles.size() % 2, 0u);
  const auto atoms = read_file(formats, folder_ / "balls_caffeine.cin").inputs.get(balls_input);
  EXPECT_EQ(atoms->size(), 23u);
  EXPECT_DOUBLE_EQ(atoms->at(0).radius, std::sqrt(0.46875));
}

}  // namespace
}  // namespace mesecina
