// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QSpinBox;
class QWidget;

namespace mesecina {

/// A field for whole numbers whose steps grow with the number; what is typed counts when it is complete. `name` is for
/// those who do not see the field.
QSpinBox* make_count_field(int minimum, int maximum, int value, QWidget* parent, const QString& name);

/// Makes what is done in one popover a step of undo of its own.
QString new_merge_key(const QString& kind);

/// To so many significant digits.
double rounded_to(double value, int digits);

}  // namespace mesecina
