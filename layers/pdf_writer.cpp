// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/pdf_writer.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <algorithm>

#include "layers/painter_canvas.h"

namespace mesecina {
namespace {

/// Blanks the date of creation, which Qt always writes; every other byte stays at its place, as the file's table of
/// contents needs it.
void remove_date(QByteArray& pdf) {
  const qsizetype begin = pdf.indexOf("/CreationDate (");
  if (begin < 0) return;
  const qsizetype end = pdf.indexOf(')', begin);
  if (end < 0) return;
  std::fill(pdf.begin() + begin, pdf.begin() + end + 1, ' ');
}

}  // namespace

std::string pdf_bytes(const Scene& scene, const View_2& view, int width, int height) {
  return pdf_page(width, height, [&](QPainter& painter) {
    paint_scene(painter, scene, view, width, height);
    paint_color_bars(painter, scene, width, height);
  });
}

std::string pdf_page(int width, int height, const std::function<void(QPainter&)>& paint) {
  constexpr double points_per_pixel = 0.75;
  constexpr int resolution = 1200;
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setCreator(QStringLiteral("Mesecina"));
  writer.setResolution(resolution);
  writer.setPageSize(QPageSize(QSizeF(width * points_per_pixel, height * points_per_pixel), QPageSize::Point, QString(),
                               QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF());
  QPainter painter(&writer);
  painter.scale(resolution / 96.0, resolution / 96.0);
  paint(painter);
  painter.end();
  remove_date(bytes);
  return bytes.toStdString();
}

}  // namespace mesecina
