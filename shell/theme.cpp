// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/theme.h"

#include <QApplication>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>
#include <memory>

#include "layers/panel_paint.h"

namespace mesecina {

namespace {

struct Tones {
  QRgb window, base, alternate, button, text, faint, disabled, mid, dark, light, highlight, highlighted_text, link, tip,
      tip_text;
};

constexpr Tones light_tones{0xfff4f5f7, 0xffffffff, 0xfff1f3f6, 0xfffafbfc, 0xff1d2129,
                            0xff6b7280, 0xff9aa1ab, 0xffc9ced6, 0xff9fa6b1, 0xffffffff,
                            0xff2f6fde, 0xffffffff, 0xff1f5fd0, 0xff23272f, 0xfff4f5f7};
constexpr Tones dark_tones{0xff24272d, 0xff1b1d22, 0xff212429, 0xff30343c, 0xffe4e7ec,
                           0xff98a0ad, 0xff6b727e, 0xff454a54, 0xff15171b, 0xff4a505b,
                           0xff3f7ee8, 0xffffffff, 0xff7fb0ff, 0xff3a3f48, 0xfff0f2f5};

QPalette palette_of(const Tones& tones) {
  QPalette palette;
  const auto set = [&](QPalette::ColorRole role, QRgb tone) { palette.setColor(role, QColor::fromRgb(tone)); };
  set(QPalette::Window, tones.window);
  set(QPalette::WindowText, tones.text);
  set(QPalette::Base, tones.base);
  set(QPalette::AlternateBase, tones.alternate);
  set(QPalette::Text, tones.text);
  set(QPalette::PlaceholderText, tones.faint);
  set(QPalette::Button, tones.button);
  set(QPalette::ButtonText, tones.text);
  set(QPalette::BrightText, 0xffff5050);
  set(QPalette::Light, tones.light);
  set(QPalette::Midlight, tones.mid);
  set(QPalette::Mid, tones.mid);
  set(QPalette::Dark, tones.dark);
  set(QPalette::Shadow, 0xff000000);
  set(QPalette::Highlight, tones.highlight);
  set(QPalette::HighlightedText, tones.highlighted_text);
  set(QPalette::Link, tones.link);
  set(QPalette::LinkVisited, tones.link);
  set(QPalette::ToolTipBase, tones.tip);
  set(QPalette::ToolTipText, tones.tip_text);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, QColor::fromRgb(tones.disabled));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor::fromRgb(tones.mid));
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, QColor::fromRgb(tones.disabled));
  return palette;
}

/// Fusion takes the frames of boxes to check from the window's colour, made darker: in a dark window they are not seen.
class Framed_boxes : public QProxyStyle {
 public:
  Framed_boxes() : QProxyStyle(QStringLiteral("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) return;
    QColor frame = option->palette.color(QPalette::PlaceholderText);
    constexpr double faint = 0.7;
    frame.setAlphaF(faint);
    const QPen before = painter->pen();
    painter->setPen(frame);
    painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    painter->setPen(before);
  }
};

}  // namespace

Theme_switch::Theme_switch() : system_style_(QApplication::style()->name()), system_palette_(QApplication::palette()) {}

void Theme_switch::apply(Theme theme) {
  theme_ = theme;
  if (theme == Theme::system) {
    QApplication::setStyle(system_style_);
  } else {
    QApplication::setStyle(std::make_unique<Framed_boxes>().release());  // which owns it
  }
  QApplication::setPalette(theme == Theme::light  ? palette_of(light_tones)
                           : theme == Theme::dark ? palette_of(dark_tones)
                                                  : system_palette_);
}

}  // namespace mesecina
