// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QRectF>
#include <QString>
#include <functional>

#include "core/style.h"

class QPainter;

namespace mesecina {

// The glyphs of the layer panel, drawn in a given colour to fill a square, crisp at any scale.

QColor to_qcolor(const Color& color);
Color from_qcolor(const QColor& color);
/// `first` and `second` mixed; all `second` at fraction 1.
QColor mix(const QColor& first, const QColor& second, double fraction);
/// Text that steps back behind the ordinary one, in this palette.
QColor subdued_text(const QPalette& palette);
/// Signal colours that stand out from the palette's base, light or dark.
QColor failure_color(const QPalette& palette);
QColor warning_color(const QPalette& palette);

void paint_eye(QPainter& painter, const QRectF& square, const QColor& color, bool is_open);
/// Triangle that points down when expanded, else to the right.
void paint_arrow(QPainter& painter, const QRectF& square, const QColor& color, bool is_expanded);
/// Three dots beside each other: more is behind them.
void paint_more(QPainter& painter, const QRectF& square, const QColor& color);
/// Ring of dots of which one leads; `phase` counts steps of an eighth of a turn.
void paint_spinner(QPainter& painter, const QRectF& square, const QColor& color, int phase);
void paint_clock(QPainter& painter, const QRectF& square, const QColor& color);
/// Filled circle with a cross cut out.
void paint_failure(QPainter& painter, const QRectF& square, const QColor& color, const QColor& mark);
/// Filled triangle with an exclamation mark cut out.
void paint_warning(QPainter& painter, const QRectF& square, const QColor& color, const QColor& mark);

/// A colour map from left to right; nothing for an unknown name.
void paint_gradient(QPainter& painter, const QRectF& rectangle, const std::string& color_map, bool is_reversed);
/// The colour of a layer or its colour map, framed, to be seen on any background.
void paint_swatch(QPainter& painter, const QRectF& rectangle, const Style& style, const QPalette& palette);

/// The ground of a widget that lies over others, framed.
void paint_plate(QPainter& painter, const QRectF& rectangle, const QPalette& palette);

/// An icon drawn anew at each size and scale in the application palette's text colour.
QIcon painted_icon(std::function<void(QPainter&, const QRectF&, const QColor&)> paint);
QIcon color_map_icon(const std::string& color_map, bool is_reversed);

/// 12 345 with narrow no-break spaces.
QString grouped_count(std::size_t count);
/// At most `digits` significant digits in the C locale.
QString short_number(double value, int digits = 4);

}  // namespace mesecina
