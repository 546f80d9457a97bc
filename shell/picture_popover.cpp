// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/picture_popover.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <utility>

#include "shell/popover_fields.h"

namespace mesecina {

Popover* open_picture_popover(const Picture_wish& start, const QString& formats, QWidget* over,
                              std::function<void(const Picture_wish&)> save,
                              std::function<void(const Picture_wish&)> copy) {
  auto* popover = new Popover(QObject::tr("Export picture"), over);
  constexpr int most_pixels = 32000;
  auto* width = make_count_field(1, most_pixels, start.size.width(), popover, QObject::tr("Width of the picture"));
  auto* height = make_count_field(1, most_pixels, start.size.height(), popover, QObject::tr("Height of the picture"));
  for (QSpinBox* box : {width, height}) box->setSuffix(QObject::tr(" px"));
  auto* is_transparent = new QCheckBox(QObject::tr("Transparent background"), popover);
  is_transparent->setChecked(start.is_transparent);
  auto* copy_button = new QPushButton(QObject::tr("Copy"), popover);
  copy_button->setToolTip(QObject::tr("Put the picture on the clipboard"));
  auto* save_button = new QPushButton(QObject::tr("Save as…"), popover);
  save_button->setToolTip(QObject::tr("%1, by the name of the file").arg(formats));
  popover->form()->addRow(QObject::tr("Width"), width);
  popover->form()->addRow(QObject::tr("Height"), height);
  popover->form()->addRow(is_transparent);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(copy_button);
  buttons->addWidget(save_button);
  popover->column()->addLayout(buttons);
  popover->set_default(save_button);
  const auto wish = [=] { return Picture_wish{QSize(width->value(), height->value()), is_transparent->isChecked()}; };
  QObject::connect(save_button, &QPushButton::clicked, popover, [=, save = std::move(save)] {
    save(wish());
    popover->dismiss();
  });
  QObject::connect(copy_button, &QPushButton::clicked, popover, [=, copy = std::move(copy)] {
    copy(wish());
    popover->dismiss();
  });
  popover->open();
  return popover;
}

}  // namespace mesecina
