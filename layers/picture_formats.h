// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/formats/format.h"

class QGuiApplication;
class QImage;

namespace mesecina {

/// Makes text in pictures possible where no window system is: starts a QGuiApplication on the "offscreen" platform (or
/// that of QT_QPA_PLATFORM) unless there is an application already. Costs about 50 ms then. Construct and destroy it in
/// the main thread.
class Picture_application {
 public:
  Picture_application();
  ~Picture_application();
  Picture_application(const Picture_application&) = delete;
  Picture_application& operator=(const Picture_application&) = delete;

 private:
  struct Arguments;
  std::unique_ptr<Arguments> arguments_;
  std::unique_ptr<QGuiApplication> application_;
};

/// Adds the picture writers svg, png and pdf and the reader of images, which gives the image and the outline of its
/// dark silhouette; and films. PNG, PDF and films start a Picture_application at first use, kept as long as the
/// formats; SVG and reading need none. Any thread may write and film.
void add_picture_formats(Formats& formats);

/// What the png writer writes: antialiased, with colour bars, transparent where the scene asks for it. A
/// QGuiApplication must exist when the scene has colour bars. A null image when there is no memory for it.
QImage paint_picture(const Scene& scene, const View_2& view, int width, int height);

/// Throws File_error for a picture without pixels or of more than 100 megapixels.
void check_picture_size(const std::filesystem::path& file, int width, int height);

/// PNG bytes of the picture; empty when it is null.
std::string png_bytes(const QImage& picture);

/// PNG bytes of the image.
std::string encode_png(const Image& image);

}  // namespace mesecina
