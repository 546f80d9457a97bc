// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/popover_fields.h"

#include <QSpinBox>
#include <QUuid>

namespace mesecina {

QSpinBox* make_count_field(int minimum, int maximum, int value, QWidget* parent, const QString& name) {
  auto* field = new QSpinBox(parent);
  field->setRange(minimum, maximum);
  field->setValue(value);
  field->setKeyboardTracking(false);
  field->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  field->setAccessibleName(name);
  return field;
}

QString new_merge_key(const QString& kind) { return kind + QUuid::createUuid().toString(); }

double rounded_to(double value, int digits) { return QString::number(value, 'g', digits).toDouble(); }

}  // namespace mesecina
