// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/popovers_2.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/formats/number.h"
#include "layers/number_field.h"
#include "shell/popover_fields.h"

namespace mesecina {

Box generator_box(const Inputs& inputs, const Canvas_2& canvas) {
  Box box;
  if (inputs.is_empty()) {
    constexpr double side = 100;
    box.add(Point_2{0, 0});
    box.add(Point_2{side, side});
    return box;
  }
  constexpr double share = 0.4;
  const View_2& view = canvas.view();
  const double half_width = share * canvas.width() / view.scale;
  const double half_height = share * canvas.height() / view.scale;
  box.add(Point_2{view.center.x - half_width, view.center.y - half_height});
  box.add(Point_2{view.center.x + half_width, view.center.y + half_height});
  return box;
}

Generator_order_2 usual_order(const Generator_2& generator, const Inputs& inputs, const Canvas_2& canvas) {
  Generator_order_2 order;
  order.inputs = inputs;
  order.box = generator_box(inputs, canvas);
  order.count = generator.usual_count;
  const double side = std::min(order.box.upper.x - order.box.lower.x, order.box.upper.y - order.box.lower.y);
  constexpr int digits = 2;
  order.least_radius = rounded_to(0.02 * side, digits);
  order.greatest_radius = rounded_to(0.08 * side, digits);
  order.relative_radius = 0.6;
  return order;
}

Popover* open_generator_popover(const Generator_2& generator, Editor_2& editor, QWidget* over) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("generators", text); };
  const auto order =
      std::make_shared<Generator_order_2>(usual_order(generator, editor.document().inputs(), editor.canvas()));
  if (generated(generator, *order).is_empty()) {
    Q_EMIT editor.failed(QObject::tr("%1: there is nothing to start from; draw or open an outline or points first.")
                             .arg(translated(generator.label)));
    return nullptr;
  }
  auto* popover = new Popover(translated(generator.label), over);
  const auto is_inserting = std::make_shared<bool>(false);
  const QString key = new_merge_key(QStringLiteral("generate"));
  const bool is_first_data = order->inputs.is_empty();
  const auto insert = [&editor, &generator, order, is_inserting, key, translated, is_first_data] {
    *is_inserting = true;
    editor.document().edit_inputs(appended(order->inputs, generated(generator, *order)),
                                  QObject::tr("Insert: %1").arg(translated(generator.label)), key);
    *is_inserting = false;
    if (is_first_data) editor.canvas().fit(bounding_box(editor.document().inputs()));
  };
  auto* tip = new QLabel(translated(generator.tip), popover);
  tip->setWordWrap(true);
  tip->setMinimumWidth(popover->fontMetrics().height() * 13);
  popover->form()->addRow(tip);
  if (generator.has_count) {
    constexpr int most_points = 1000000;
    const bool makes_disks = generator.radii != Radii_2::none;
    auto* count = make_count_field(1, most_points, int(order->count), popover,
                                   makes_disks ? QObject::tr("Number of disks") : QObject::tr("Number of points"));
    QObject::connect(count, &QSpinBox::valueChanged, popover, [order, insert](int value) {
      order->count = static_cast<std::size_t>(value);
      insert();
    });
    popover->form()->addRow(makes_disks ? QObject::tr("Disks") : QObject::tr("Points"), count);
  }
  const auto add_number = [&](const QString& label, const QString& name, const QString& explanation, double maximum,
                              double Generator_order_2::*member) {
    auto* field = new Number_field(popover);
    field->set_bounds(0, maximum);
    field->show_value((*order).*member);
    field->setAccessibleName(name);
    field->setToolTip(explanation);
    QObject::connect(field, &Number_field::edited, popover,
                     [order, insert, member](const std::optional<double>& value) {
                       (*order).*member = value.value_or(0);
                       insert();
                     });
    popover->form()->addRow(label, field);
  };
  constexpr double no_maximum = std::numeric_limits<double>::max();
  if (generator.radii == Radii_2::between) {
    const QString explanation = QObject::tr("In units of the data; every radius in between is as likely");
    add_number(QObject::tr("Least radius"), QObject::tr("Least radius"), explanation, no_maximum,
               &Generator_order_2::least_radius);
    add_number(QObject::tr("Greatest radius"), QObject::tr("Greatest radius"), explanation, no_maximum,
               &Generator_order_2::greatest_radius);
  } else if (generator.radii == Radii_2::relative) {
    add_number(QObject::tr("Radius / step"), QObject::tr("Relative radius"),
               QObject::tr("Radius divided by the distance of neighbouring centers; at 0.5 they touch"), no_maximum,
               &Generator_order_2::relative_radius);
  }
  if (generator.has_amount) {
    add_number(QObject::tr("Noise"), QObject::tr("Amount of noise"),
               QObject::tr("Standard deviation, as a fraction of the diagonal"), 1, &Generator_order_2::amount);
  }
  if (generator.has_seed) {
    constexpr int most_seeds = 999999;
    auto* seed = make_count_field(0, most_seeds, int(order->seed), popover, QObject::tr("Seed"));
    seed->setStepType(QAbstractSpinBox::DefaultStepType);
    seed->setToolTip(QObject::tr("The same seed gives the same again"));
    QObject::connect(seed, &QSpinBox::valueChanged, popover, [order, insert](int value) {
      order->seed = static_cast<std::uint64_t>(value);
      insert();
    });
    popover->form()->addRow(QObject::tr("Seed"), seed);
  }
  insert();
  QObject::connect(&editor.document(), &Document::changed, popover,
                   [popover, is_inserting](const Document_change& change) {
                     if (change.inputs && !*is_inserting) popover->dismiss();
                   });
  popover->open();
  return popover;
}

Popover* open_coordinates_popover(Editor_2& editor, QWidget* over) {
  const auto position = [&editor]() -> std::optional<Point_2> {
    const auto all = positions(editor.document().inputs(), editor.selection());
    return all.empty() ? std::nullopt : std::optional(all.front());
  };
  if (!position()) return nullptr;
  auto* popover = new Popover(QObject::tr("Exact coordinates"), over);
  auto* x = new QLineEdit(popover);
  auto* y = new QLineEdit(popover);
  x->setAccessibleName(QStringLiteral("x"));
  y->setAccessibleName(QStringLiteral("y"));
  auto* radius = new QLineEdit(popover);
  radius->setAccessibleName(QObject::tr("Radius"));
  for (QLineEdit* field : {x, y, radius})
    field->setToolTip(QObject::tr("In units of the data, with a decimal point; Enter takes it over"));
  /// The disk that is edited: the first selected one when no point or vertex is selected before it.
  const auto disk_index = [&editor]() -> std::optional<std::size_t> {
    const Selection_2 known = restricted(editor.selection(), editor.document().inputs());
    const bool is_disk_first = known.points.empty() && known.vertices.empty() && !known.disks.empty();
    return is_disk_first ? std::optional(known.disks.front()) : std::nullopt;
  };
  popover->form()->addRow(QStringLiteral("x"), x);
  popover->form()->addRow(QStringLiteral("y"), y);
  popover->form()->addRow(QObject::tr("radius"), radius);
  const auto show = [&editor, popover, x, y, radius, position, disk_index] {
    const auto disk = disk_index();
    popover->form()->setRowVisible(radius, disk.has_value());
    if (disk) {
      const auto disks = editor.document().inputs().get(disks_input);
      radius->setText(QString::fromStdString(format_number((*disks)[*disk].radius)));
    }
    const auto p = position();
    x->setEnabled(p.has_value());
    y->setEnabled(p.has_value());
    if (!p) return;
    x->setText(QString::fromStdString(format_number(p->x)));
    y->setText(QString::fromStdString(format_number(p->y)));
  };
  show();
  const QString key = new_merge_key(QStringLiteral("coordinates"));
  const auto place = [&editor, x, y, radius, show, position, disk_index, key] {
    const auto number_in = [](const QLineEdit* line) { return parse_number(line->text().trimmed().toStdString()); };
    const auto px = number_in(x);
    const auto py = number_in(y);
    const auto disk = disk_index();
    const auto r = disk ? number_in(radius) : 0.0;
    const bool is_good = px && py && std::isfinite(*px) && std::isfinite(*py);
    if (!r || !std::isfinite(*r) || *r < 0) {
      Q_EMIT editor.failed(QObject::tr("Expected a radius of at least 0, found \"%1\".").arg(radius->text()));
      show();
    } else if (!is_good) {
      Q_EMIT editor.failed(
          QObject::tr("Expected two numbers such as 1.5, found \"%1\" and \"%2\".").arg(x->text(), y->text()));
      show();
    } else if (disk) {
      editor.change_disk(*disk, {{*px, *py}, *r}, key);
    } else if (position()) {
      editor.place({*px, *py}, key);
    }
  };
  for (QLineEdit* line : {x, y, radius}) QObject::connect(line, &QLineEdit::editingFinished, popover, place);
  QObject::connect(&editor.document(), &Document::changed, popover, show);
  QObject::connect(&editor, &Editor_2::selection_changed, popover, show);
  popover->open();
  return popover;
}

Popover* open_layers_popover(const Formats& formats, QWidget* over,
                             std::function<void(const std::vector<std::string>&)> write) {
  auto* popover = new Popover(QObject::tr("Export visible layers"), over);
  std::vector<QCheckBox*> boxes;
  for (const Layer_writer& writer : formats.layer_writers) {
    auto* box = new QCheckBox(QString::fromStdString(writer.name), popover);
    box->setToolTip(QString::fromStdString(writer.help));
    box->setChecked(boxes.empty());
    popover->form()->addRow(box);
    boxes.push_back(box);
  }
  auto* save = new QPushButton(QObject::tr("Into folder…"), popover);
  popover->column()->addWidget(save);
  popover->set_default(save);
  QObject::connect(save, &QPushButton::clicked, popover, [popover, boxes, write = std::move(write)] {
    std::vector<std::string> chosen;
    for (const QCheckBox* box : boxes)
      if (box->isChecked()) chosen.push_back(box->text().toStdString());
    if (!chosen.empty()) write(chosen);
    popover->dismiss();
  });
  popover->open();
  return popover;
}

}  // namespace mesecina
