// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/picture_formats.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QImage>
#include <QImageReader>
#include <QPainter>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <mutex>
#include <ostream>

#include "layers/painter_canvas.h"
#include "layers/pdf_writer.h"
#include "layers/png_check.h"
#include "layers/silhouette.h"
#include "layers/svg_writer.h"
#include "layers/video_writer.h"

namespace mesecina {
namespace {

constexpr std::int64_t most_pixels = 100'000'000;

/// Started when first asked for.
class Lazy_application {
 public:
  void start() {
    const std::lock_guard lock(mutex_);
    if (!application_) application_ = std::make_unique<Picture_application>();
  }

 private:
  std::mutex mutex_;
  std::unique_ptr<Picture_application> application_;
};

std::string size_text(std::int64_t width, std::int64_t height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

}  // namespace

void check_picture_size(const std::filesystem::path& file, int width, int height) {
  if (width <= 0 || height <= 0)
    throw File_error(file, 0, "expected a picture of at least 1 x 1 pixels, found " + size_text(width, height));
  if (std::int64_t{width} * height > most_pixels)
    throw File_error(file, 0,
                     "expected at most 100 megapixels, found " + size_text(width, height) + "; choose a smaller size");
}

std::string png_bytes(const QImage& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG")) return {};
  return bytes.toStdString();
}

namespace {

QString to_qt(const std::filesystem::path& file) { return QString::fromStdU16String(file.u16string()); }

Image to_image(QImage picture) {
  picture.convertTo(QImage::Format_RGBA8888);
  Image image;
  image.width = picture.width();
  image.height = picture.height();
  const std::size_t row_bytes = std::size_t{4} * static_cast<std::size_t>(image.width);
  image.rgba.resize(row_bytes * static_cast<std::size_t>(image.height));
  for (int row = 0; row < image.height; ++row)
    std::memcpy(image.rgba.data() + row_bytes * static_cast<std::size_t>(row), picture.constScanLine(row), row_bytes);
  return image;
}

File_contents read_image(const std::filesystem::path& file) {
  check_png(file);
  QImageReader reader(to_qt(file));
  reader.setDecideFormatFromContent(true);
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  if (std::int64_t{size.width()} * size.height() > most_pixels)
    throw File_error(file, 0,
                     "expected at most 100 megapixels, found " + size_text(size.width(), size.height()) +
                         "; make the image smaller");
  // Megabytes; Qt's own limit is less than what is promised here.
  QImageReader::setAllocationLimit(1024);
  QImage picture = reader.read();
  if (picture.isNull())
    throw File_error(file, 0, "expected an image, found none: " + reader.errorString().toStdString());
  Image image = to_image(std::move(picture));
  File_contents contents;
  Outline_2 outline = silhouette(image);
  if (outline.rings.empty()) {
    contents.warnings.push_back("image has no pixel darker than 50 %: no outline was made of it");
  } else {
    contents.inputs = contents.inputs.with(outline_input, std::move(outline));
  }
  contents.inputs = contents.inputs.with(image_input, std::move(image));
  return contents;
}

void write_svg_file(const std::filesystem::path& file, const Scene& scene, const View_2& view, int width, int height) {
  check_picture_size(file, width, height);
  write_file(file, [&](std::ostream& out) { write_svg(out, scene, view, width, height, encode_png); });
}

void write_png_file(const std::filesystem::path& file, const Scene& scene, const View_2& view, int width, int height) {
  check_picture_size(file, width, height);
  const std::string bytes = png_bytes(paint_picture(scene, view, width, height));
  if (bytes.empty()) throw File_error(file, 0, "no memory for a picture of " + size_text(width, height));
  write_file(file, [&](std::ostream& out) { out << bytes; });
}

void write_pdf_file(const std::filesystem::path& file, const Scene& scene, const View_2& view, int width, int height) {
  check_picture_size(file, width, height);
  const std::string bytes = pdf_bytes(scene, view, width, height);
  write_file(file, [&](std::ostream& out) { out << bytes; });
}

}  // namespace

struct Picture_application::Arguments {
  std::string program = "mesecina";
  std::string option = "-platform";
  std::string platform = "offscreen";
  std::array<char*, 4> values{program.data(), option.data(), platform.data(), nullptr};
  int count = 3;
};

Picture_application::Picture_application() {
  if (QCoreApplication::instance()) return;
  // Drawing needs no runtime directory; that there is none is normal without a session, and nothing the user can mend.
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& message) {
    if (!message.startsWith(QLatin1String("QStandardPaths:"))) std::cerr << message.toStdString() << std::endl;
  });
  arguments_ = std::make_unique<Arguments>();
  if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
    arguments_->count = 1;
    arguments_->values[1] = nullptr;
  }
  application_ = std::make_unique<QGuiApplication>(arguments_->count, arguments_->values.data());
}

Picture_application::~Picture_application() {
  if (application_) qInstallMessageHandler(nullptr);
}

QImage paint_picture(const Scene& scene, const View_2& view, int width, int height) {
  QImage picture(width, height, QImage::Format_ARGB32_Premultiplied);
  if (picture.isNull()) return picture;
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  paint_scene(painter, scene, view, width, height);
  paint_color_bars(painter, scene, width, height);
  painter.end();
  if (!scene.transparent_background) picture.convertTo(QImage::Format_RGB32);
  return picture;
}

std::string encode_png(const Image& image) {
  return png_bytes(
      QImage(image.rgba.data(), image.width, image.height, qsizetype{4} * image.width, QImage::Format_RGBA8888));
}

void add_picture_formats(Formats& formats) {
  const auto application = std::make_shared<Lazy_application>();
  formats.picture_writers.push_back(
      {"svg", "svg", "SVG 1.1 with one named layer per layer, true circles and arcs", write_svg_file});
  formats.picture_writers.push_back(
      {"png", "png", "PNG picture, antialiased",
       [application](const std::filesystem::path& file, const Scene& scene, const View_2& view, int width, int height) {
         application->start();
         write_png_file(file, scene, view, width, height);
       }});
  formats.picture_writers.push_back(
      {"pdf", "pdf", "PDF with lines and curves, 96 pixels to the inch",
       [application](const std::filesystem::path& file, const Scene& scene, const View_2& view, int width, int height) {
         application->start();
         write_pdf_file(file, scene, view, width, height);
       }});
  formats.make_film = [application](const Film_request& request) {
    return make_video(request, [application](const Film_frame& frame, int width, int height) {
      application->start();
      return paint_picture(frame.scene, frame.view, width, height);
    });
  };
  formats.readers.push_back({"silhouettes in images", {"png", "gif", "bmp", "jpg", "jpeg"}, read_image});
}

}  // namespace mesecina
