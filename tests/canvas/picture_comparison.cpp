// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_comparison.h"

#include <QCoreApplication>
#include <QDir>
#include <algorithm>
#include <array>

namespace mesecina {

namespace {

std::array<int, 3> channels(const QImage& image, int x, int y) {
  const QRgb pixel = image.pixel(x, y);
  return {qRed(pixel), qGreen(pixel), qBlue(pixel)};
}

/// How far the pixel lies outside of the range of the other picture's pixels around it.
int excess(const QImage& image, const QImage& other, int x, int y) {
  std::array<int, 3> low{255, 255, 255};
  std::array<int, 3> high{0, 0, 0};
  for (int v = std::max(0, y - 1); v <= std::min(other.height() - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(other.width() - 1, x + 1); ++u) {
      const auto around = channels(other, u, v);
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], around[i]);
        high[i] = std::max(high[i], around[i]);
      }
    }
  }
  const auto own = channels(image, x, y);
  int result = 0;
  for (int i = 0; i < 3; ++i) result = std::max({result, low[i] - own[i], own[i] - high[i]});
  return result;
}

}  // namespace

testing::AssertionResult same_picture(const QImage& out, const QImage& expected, const std::string& name, int tolerance,
                                      double allowed) {
  if (out.size() != expected.size()) {
    return testing::AssertionFailure() << name << " is " << out.width() << "x" << out.height() << ", expected "
                                       << expected.width() << "x" << expected.height();
  }
  QImage difference(out.size(), QImage::Format_Grayscale8);
  std::size_t wrong = 0;
  int worst = 0;
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) {
      const int here = std::max(excess(out, expected, x, y), excess(expected, out, x, y));
      worst = std::max(worst, here);
      if (here > tolerance) ++wrong;
      difference.scanLine(y)[x] = static_cast<uchar>(here > tolerance ? 255 - here / 2 : here);
    }
  }
  const double part = static_cast<double>(wrong) / (static_cast<double>(out.width()) * out.height());
  const bool keep = qEnvironmentVariableIsSet("MESECINA_KEEP_PICTURES");
  const QString stem = QDir(QCoreApplication::applicationDirPath()).filePath(QString::fromStdString(name));
  if (part > allowed || keep) {
    out.save(stem + ".out.png");
    expected.save(stem + ".expected.png");
    difference.save(stem + ".diff.png");
  }
  if (part <= allowed) return testing::AssertionSuccess();
  return testing::AssertionFailure() << wrong << " pixels (" << 100 * part << " %) of " << name
                                     << " differ, the worst by " << worst << "; see " << stem.toStdString()
                                     << ".diff.png";
}

}  // namespace mesecina
