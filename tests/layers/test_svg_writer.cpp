// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <QXmlStreamReader>
#include <cmath>
#include <map>
#include <random>
#include <sstream>

#include "core/formats/number.h"
#include "layers/painter_canvas.h"
#include "layers/picture_formats.h"
#include "layers/svg_writer.h"
#include "tests/layers/example_scene.h"

namespace mesecina {
namespace {

using test::layer_of;
using test::pixel_view;
using test::scene_of;

std::string svg_of(const Scene& scene, const View_2& view, int width, int height) {
  std::ostringstream out;
  write_svg(out, scene, view, width, height, encode_png);
  return out.str();
}

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
};

/// All elements in order; fails the test when the text is not well-formed.
std::vector<Element> parse(const std::string& svg) {
  QXmlStreamReader reader(QByteArray::fromStdString(svg));
  std::vector<Element> elements;
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    Element element{reader.name().toString().toStdString(), {}};
    for (const QXmlStreamAttribute& attribute : reader.attributes())
      element.attributes[attribute.qualifiedName().toString().toStdString()] =
          attribute.value().toString().toStdString();
    elements.push_back(std::move(element));
  }
  EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
  return elements;
}

std::vector<Element> named(const std::vector<Element>& elements, const std::string& name) {
  std::vector<Element> result;
  for (const Element& element : elements)
    if (element.name == name) result.push_back(element);
  return result;
}

std::vector<double> numbers_in(const std::string& path) {
  std::vector<double> numbers;
  std::string word;
  for (const char c : path + " ") {
    if (std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == 'e' || c == '+') {
      word += c;
      continue;
    }
    if (!word.empty()) numbers.push_back(parse_number(word).value());
    word.clear();
  }
  return numbers;
}

TEST(Svg_writer, coordinates_have_full_precision) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Primitive_set set;
  for (int i = 0; i < 40; ++i) set.vertices.push_back({coordinate(random), coordinate(random), 0});
  for (int i = 0; i < 20; ++i) set.segments.push_back({2 * i, 2 * i + 1});
  set.balls = {{0, 0.1}, {1, 1.0 / 3}};
  const View_2 view{{0.1, -0.2}, 321.7};
  const auto elements = parse(svg_of(scene_of(layer_of(set)), view, 800, 600));
  const auto paths = named(elements, "path");
  ASSERT_EQ(paths.size(), 1U) << "segments of one colour are one path";
  const auto numbers = numbers_in(paths.back().attributes.at("d"));
  ASSERT_EQ(numbers.size(), 80U);
  for (std::size_t i = 0; i < 40; ++i) {
    const Point_2 pixel = view.to_pixel({set.vertices[i].x, set.vertices[i].y}, 800, 600);
    EXPECT_EQ(numbers[2 * i], pixel.x);
    EXPECT_EQ(numbers[2 * i + 1], pixel.y);
  }
  const auto circles = named(elements, "circle");
  ASSERT_EQ(circles.size(), 2U);
  EXPECT_EQ(parse_number(circles[1].attributes.at("r")), 321.7 * (1.0 / 3));
}

TEST(Svg_writer, layers_have_their_names_and_hidden_ones_are_left_out) {
  Primitive_set set;
  set.vertices = {{10, 10, 0}};
  set.points = {0};
  Scene scene;
  scene.layers = {layer_of(set, "samples"), layer_of(set, "hidden"), layer_of(set, "odd name"),
                  layer_of(set, "samples")};
  scene.layers[0].label = "Crust <\"1\" & 2>";
  scene.layers[1].style.visible = false;
  const auto elements = parse(svg_of(scene, pixel_view(100, 100), 100, 100));
  std::vector<std::string> labels;
  std::vector<std::string> ids;
  for (const Element& group : named(elements, "g")) {
    if (!group.attributes.count("inkscape:groupmode")) continue;
    EXPECT_EQ(group.attributes.at("inkscape:groupmode"), "layer");
    labels.push_back(group.attributes.at("inkscape:label"));
    ids.push_back(group.attributes.at("id"));
  }
  EXPECT_EQ(labels, (std::vector<std::string>{"Crust <\"1\" & 2>", "odd name", "samples"}));
  EXPECT_EQ(ids, (std::vector<std::string>{"layer-samples", "layer-odd_name", "layer-samples-2"}));
}

TEST(Svg_writer, arcs_are_true_arcs) {
  Primitive_set set;
  set.vertices = {{130, 50, 0}, {100, 80, 0}};
  set.arcs = {{{100, 50}, 30, 0, 1, true}, {{100, 50}, 30, 0, 1, false}};
  const std::string svg = svg_of(scene_of(layer_of(set)), pixel_view(200, 100), 200, 100);
  EXPECT_NE(svg.find("M130 50A30 30 0 0 0 100 20"), std::string::npos) << svg;
  EXPECT_NE(svg.find("M130 50A30 30 0 1 1 100 20"), std::string::npos) << svg;
}

TEST(Svg_writer, areas_bounded_by_arcs_are_one_path_of_true_arcs) {
  Primitive_set set;
  set.vertices = {{130, 50, 0}, {100, 80, 0}, {70, 50, 0}, {150, 50, 0}, {190, 50, 0}};
  set.arcs = {{{100, 50}, 30, 0, 1, true},
              {{100, 50}, 30, 0, 1, false},
              {{60, 50}, 10, 2, 2, true},
              {{170, 50}, 20, 3, 4, true}};
  Scene_layer layer = layer_of(set);
  layer.style.filled = true;
  layer.style.color = {1, 2, 3};
  layer.style.opacity = 0.25;
  const auto paths = named(parse(svg_of(scene_of(layer), pixel_view(200, 100), 200, 100)), "path");
  ASSERT_GE(paths.size(), 1U);
  const auto& region = paths[0].attributes;
  EXPECT_EQ(region.at("fill-rule"), "evenodd");
  EXPECT_EQ(region.at("fill"), "#010203");
  EXPECT_EQ(region.at("fill-opacity"), "0.25");
  EXPECT_EQ(region.at("d"),
            "M130 50A30 30 0 0 0 100 20A30 30 0 1 0 130 50Z"
            "M70 50A10 10 0 0 0 50 50A10 10 0 0 0 70 50Z")
      << "the open arc bounds nothing";
  EXPECT_EQ(paths.size(), 4U) << "three arcs with ends are drawn as lines, the circle as itself";
  layer.style.filled = false;
  for (const auto& path : named(parse(svg_of(scene_of(layer), pixel_view(200, 100), 200, 100)), "path"))
    EXPECT_FALSE(path.attributes.count("fill-rule"));
}

TEST(Svg_writer, translucent_disks_are_one_area) {
  Primitive_set set;
  set.vertices = {{80, 50, 0}, {120, 50, 0}};
  set.balls = {{0, 30}, {1, 30}};
  Scene_layer layer = layer_of(set);
  layer.style.filled = true;
  const auto count = [&](const std::string& name) {
    return named(parse(svg_of(scene_of(layer), pixel_view(200, 100), 200, 100)), name).size();
  };
  EXPECT_EQ(count("circle"), 2U);
  layer.style.opacity = 0.5;
  EXPECT_EQ(count("circle"), 0U);
  ASSERT_EQ(count("path"), 1U);
  const auto path = named(parse(svg_of(scene_of(layer), pixel_view(200, 100), 200, 100)), "path")[0].attributes;
  EXPECT_EQ(path.at("fill-rule"), "nonzero");
  EXPECT_EQ(path.at("fill-opacity"), "0.5");
}

TEST(Svg_writer, rays_end_near_the_page_and_huge_circles_cross_it) {
  Primitive_set set;
  set.vertices = {{50, 50, 0}, {50, 50 - 1e12, 0}};
  set.rays = {{0, {0.6, 0.8, 0}}};
  set.balls = {{1, 1e12}};
  const auto elements = parse(svg_of(scene_of(layer_of(set)), pixel_view(100, 100), 100, 100));
  EXPECT_TRUE(named(elements, "circle").empty());
  for (const Element& path : named(elements, "path"))
    for (const double number : numbers_in(path.attributes.at("d"))) EXPECT_LT(std::abs(number), 200);
}

TEST(Svg_writer, colors_by_value_with_a_bar) {
  Primitive_set set;
  set.vertices = {{10, 10, 0}, {20, 20, 0}, {30, 10, 0}};
  set.segments = {{0, 1}, {1, 2}};
  set.values.push_back({"angle", "degrees", {0, 90}});
  Scene_layer layer = layer_of(set, "axis");
  layer.style.value = "angle";
  layer.style.color_map = "gray";
  const auto elements = parse(svg_of(scene_of(layer), pixel_view(400, 300), 400, 300));
  const auto paths = named(elements, "path");
  ASSERT_GE(paths.size(), 2U);
  EXPECT_EQ(paths[0].attributes.at("stroke"), "#000000");
  EXPECT_EQ(paths[1].attributes.at("stroke"), "#ffffff");
  EXPECT_EQ(named(elements, "linearGradient").size(), 1U);
  EXPECT_GE(named(elements, "text").size(), 4U);
}

TEST(Svg_writer, transparent_background_has_no_rectangle) {
  Scene scene;
  const auto count = [&] { return named(parse(svg_of(scene, pixel_view(10, 10), 10, 10)), "rect").size(); };
  EXPECT_EQ(count(), 2U) << "clip and background";
  scene.transparent_background = true;
  EXPECT_EQ(count(), 1U);
}

/// Every kind of primitive at several places, sizes and opacities.
Scene rich_scene() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(20, 380);
  std::uniform_real_distribution<double> y(20, 280);
  Scene scene;
  for (int kind = 0; kind < 9; ++kind) {
    Primitive_set set;
    for (int i = 0; i < 12; ++i) set.vertices.push_back({x(random), y(random), 0});
    if (kind == 0) {
      set.balls = {{5, 2e4}};
    } else if (kind == 1) {
      set.balls = {{0, 40}, {1, 30}, {2, 70}};
    } else if (kind == 2) {
      set.polygon_vertices = {0, 1, 2, 3, 4, 5, 6};
      set.polygon_offsets = {0, 3, 7};
    } else if (kind == 3) {
      set.triangles = {{0, 1, 2}, {3, 4, 5}};
    } else if (kind == 4) {
      for (int i = 0; i < 6; ++i) {
        const double angle = i;
        set.vertices.push_back({200 + 60 * std::cos(angle), 150 + 60 * std::sin(angle), 0});
      }
      set.arcs = {{{200, 150}, 60, 12, 13, true}, {{200, 150}, 60, 14, 16, false}};
      set.rays = {{0, {0.6, 0.8, 0}}, {1, {-1, 0, 0}}};
    } else if (kind == 8) {
      set.vertices = {{40, 40, 0}, {100, 40, 0}, {70, 60, 0}};
      set.arcs = {{{70, 40}, 30, 0, 1, true},
                  {{70, 80}, 50, 0, 1, true},
                  {{70, 50}, 10, 2, 2, true},
                  {{70, 40 + 1e6}, 1e6, 0, 1, true},
                  {{70, 25}, std::sqrt(1125.0), 0, 1, true}};
    } else if (kind == 5) {
      set.segments = {{0, 1}, {2, 3}, {4, 5}};
    } else if (kind == 6) {
      set.points = {0, 1, 2, 3, 4, 5, 6, 7};
    } else {
      set.balls = {{3, 25}, {4, 1e5}};
    }
    Scene_layer layer = layer_of(set, "layer" + std::to_string(kind));
    layer.style.filled = kind < 4 || kind == 8;
    layer.style.opacity = kind % 2 == 1 ? 0.6 : 1;
    layer.style.line_width = 1 + kind / 3.0;
    layer.style.color = {static_cast<std::uint8_t>(30 * kind), 90, static_cast<std::uint8_t>(220 - 25 * kind)};
    scene.layers.push_back(std::move(layer));
  }
  return scene;
}

TEST(Svg_writer, looks_like_the_painted_picture) {
  const Scene scene = rich_scene();
  const View_2 view = pixel_view(400, 300);
  const QImage painted = paint_picture(scene, view, 400, 300);
  QSvgRenderer renderer(QByteArray::fromStdString(svg_of(scene, view, 400, 300)));
  ASSERT_TRUE(renderer.isValid());
  QImage rendered(400, 300, QImage::Format_RGB32);
  rendered.fill(Qt::white);
  QPainter painter(&rendered);
  painter.setRenderHint(QPainter::Antialiasing);
  renderer.render(&painter);
  painter.end();
  int different = 0;
  double sum = 0;
  for (int row = 0; row < 300; ++row) {
    for (int column = 0; column < 400; ++column) {
      const QColor a = painted.pixelColor(column, row);
      const QColor b = rendered.pixelColor(column, row);
      const int difference =
          std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
      different += difference > 40;
      sum += difference;
    }
  }
  EXPECT_LT(different, 120) << "of 120000 pixels";
  EXPECT_LT(sum / 120000, 0.5);
}

TEST(Svg_writer, images_are_embedded) {
  Primitive_set set;
  auto image = std::make_shared<Image>();
  image->width = 2;
  image->height = 1;
  image->rgba = {10, 20, 30, 255, 40, 50, 60, 70};
  image->lower_left = {5, 7};
  image->pixel_size = 20;
  set.image = image;
  const auto images = named(parse(svg_of(scene_of(layer_of(set)), pixel_view(100, 80), 100, 80)), "image");
  ASSERT_EQ(images.size(), 1U);
  EXPECT_EQ(images[0].attributes.at("x"), "5");
  EXPECT_EQ(images[0].attributes.at("y"), "53");
  EXPECT_EQ(images[0].attributes.at("width"), "40");
  EXPECT_EQ(images[0].attributes.at("height"), "20");
  const std::string prefix = "data:image/png;base64,";
  const std::string data = images[0].attributes.at("xlink:href");
  ASSERT_EQ(data.substr(0, prefix.size()), prefix);
  const QImage decoded =
      QImage::fromData(QByteArray::fromBase64(QByteArray::fromStdString(data.substr(prefix.size()))), "PNG");
  ASSERT_EQ(decoded.size(), QSize(2, 1));
  EXPECT_EQ(decoded.pixel(0, 0), qRgba(10, 20, 30, 255));
  EXPECT_EQ(decoded.pixel(1, 0), qRgba(40, 50, 60, 70));
}

TEST(Svg_writer, same_bytes_every_time) {
  const Scene scene = rich_scene();
  EXPECT_EQ(svg_of(scene, pixel_view(400, 300), 400, 300), svg_of(rich_scene(), pixel_view(400, 300), 400, 300));
}

}  // namespace
}  // namespace mesecina
