// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "layers/picture_formats.h"
#include "tests/layers/example_scene.h"

namespace mesecina {
namespace {

namespace fs = std::filesystem;

/// A directory of its own for each test.
class Picture_formats : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = fs::temp_directory_path() /
                 (std::string("mesecina_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
                  std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()));
    fs::create_directories(directory_);
    add_picture_formats(formats_);
  }
  void TearDown() override { fs::remove_all(directory_); }

  std::string write(const std::string& format, const std::string& name, const Scene& scene, int width, int height) {
    const Picture_writer* writer = formats_.find_picture_writer(format);
    if (!writer) throw std::runtime_error("no writer for " + format);
    writer->write(directory_ / name, scene, test::pixel_view(width, height), width, height);
    std::ifstream in(directory_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  File_contents read(const std::string& name) {
    const Reader* reader = formats_.reader_for(directory_ / name);
    if (!reader) throw std::runtime_error("no reader for " + name);
    return reader->read(directory_ / name);
  }

  fs::path directory_;
  Formats formats_;
};

Scene valued_scene() {
  Primitive_set set;
  set.vertices = {{50, 50, 0}, {150, 90, 0}, {250, 50, 0}};
  set.points = {0, 1, 2};
  set.balls = {{1, 30}};
  set.values.push_back({"radius", "units", {1, 2, 3, 4}});
  Scene_layer layer = test::layer_of(std::move(set), "balls");
  layer.style.value = "radius";
  return test::scene_of(std::move(layer));
}

TEST_F(Picture_formats, only_pictures_with_text_start_an_application) {
  ASSERT_EQ(QCoreApplication::instance(), nullptr);
  EXPECT_FALSE(write("svg", "a.svg", valued_scene(), 300, 200).empty());
  EXPECT_EQ(QCoreApplication::instance(), nullptr);
  write("png", "a.png", valued_scene(), 300, 200);
  EXPECT_NE(QCoreApplication::instance(), nullptr);
  formats_ = {};
  EXPECT_EQ(QCoreApplication::instance(), nullptr);
}

TEST_F(Picture_formats, png_has_the_size_and_transparency_asked_for) {
  Scene scene = valued_scene();
  write("png", "a.png", scene, 300, 200);
  const QImage opaque(QString::fromStdString((directory_ / "a.png").string()));
  EXPECT_EQ(opaque.size(), QSize(300, 200));
  EXPECT_FALSE(opaque.hasAlphaChannel());
  EXPECT_EQ(opaque.pixelColor(2, 2), QColor(Qt::white));
  scene.transparent_background = true;
  write("png", "b.png", scene, 300, 200);
  const QImage transparent(QString::fromStdString((directory_ / "b.png").string()));
  EXPECT_EQ(transparent.pixelColor(2, 2).alpha(), 0);
  EXPECT_EQ(transparent.pixelColor(150, 110).alpha(), 255) << "the middle point";
}

TEST_F(Picture_formats, every_picture_has_the_same_bytes_at_another_time) {
  const auto all = [&] {
    std::string bytes;
    for (const char* format : {"svg", "png", "pdf"})
      bytes += write(format, std::string("a.") + format, valued_scene(), 300, 200);
    return bytes;
  };
  const std::string first = all();
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  EXPECT_TRUE(first == all());
}

TEST_F(Picture_formats, pdf_has_one_page_of_the_size_in_points) {
  const std::string bytes = write("pdf", "a.pdf", valued_scene(), 400, 300);
  EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
  EXPECT_NE(bytes.find("/MediaBox [0 0 300.000000 225.000000]"), std::string::npos);
  EXPECT_EQ(bytes.find("CreationDate"), std::string::npos);
  EXPECT_EQ(bytes.find("/Subtype /Image"), std::string::npos) << "lines and areas stay such";
}

TEST_F(Picture_formats, sizes_that_make_no_picture_are_refused) {
  EXPECT_THROW(write("png", "a.png", valued_scene(), 0, 200), File_error);
  try {
    write("png", "a.png", valued_scene(), 20000, 20000);
    FAIL();
  } catch (const File_error& error) {
    EXPECT_NE(std::string(error.what()).find("100 megapixels"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::exists(directory_ / "a.png"));
}

TEST_F(Picture_formats, images_are_read_with_their_outline) {
  QImage picture(60, 40, QImage::Format_ARGB32);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::black);
  painter.setPen(Qt::NoPen);
  painter.drawEllipse(QPointF(25, 12), 8, 8);
  painter.end();
  for (const char* name : {"a.png", "a.bmp", "A.PNG"}) {
    if (std::string(name) == "a.bmp") {
      QImage opaque(picture.size(), QImage::Format_RGB32);
      opaque.fill(Qt::white);
      QPainter(&opaque).drawImage(0, 0, picture);
      picture = opaque;
    }
    ASSERT_TRUE(picture.save(QString::fromStdString((directory_ / name).string())));
    const File_contents contents = read(name);
    EXPECT_TRUE(contents.warnings.empty());
    const auto image = contents.inputs.get(image_input);
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, 60);
    EXPECT_EQ(image->height, 40);
    EXPECT_EQ(image->rgba.size(), 60U * 40 * 4);
    const auto outline = contents.inputs.get(outline_input);
    ASSERT_TRUE(outline);
    ASSERT_EQ(outline->rings.size(), 1U);
    for (const Point_2& p : outline->rings[0]) EXPECT_NEAR(distance(p, {25, 28}), 8, 0.15) << name;
  }
}

TEST_F(Picture_formats, a_light_image_gives_a_warning) {
  QImage picture(8, 8, QImage::Format_RGB32);
  picture.fill(QColor(200, 200, 200));
  picture.save(QString::fromStdString((directory_ / "a.png").string()));
  const File_contents contents = read("a.png");
  EXPECT_FALSE(contents.inputs.get(outline_input));
  EXPECT_TRUE(contents.inputs.get(image_input));
  ASSERT_EQ(contents.warnings.size(), 1U);
  EXPECT_NE(contents.warnings[0].find("no pixel darker than 50 %"), std::string::npos);
}

TEST_F(Picture_formats, what_is_no_image_is_refused_with_the_file) {
  std::ofstream(directory_ / "a.png") << "this is text";
  try {
    read("a.png");
    FAIL();
  } catch (const File_error& error) {
    EXPECT_NE(std::string(error.what()).find("a.png"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("found none"), std::string::npos) << error.what();
  }
}

TEST_F(Picture_formats, huge_images_are_refused_before_they_are_read) {
  // A bitmap's header alone says how large it is.
  std::string header(54, '\0');
  const auto put = [&](std::size_t at, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) header[at + static_cast<std::size_t>(i)] = static_cast<char>(value >> 8 * i & 255);
  };
  header[0] = 'B';
  header[1] = 'M';
  put(10, 54, 4);
  put(14, 40, 4);
  put(18, 20000, 4);
  put(22, 10000, 4);
  put(26, 1, 2);
  put(28, 24, 2);
  std::ofstream(directory_ / "a.bmp", std::ios::binary) << header;
  try {
    read("a.bmp");
    FAIL();
  } catch (const File_error& error) {
    EXPECT_NE(std::string(error.what()).find("20000 x 10000"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace mesecina
