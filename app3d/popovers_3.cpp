// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/popovers_3.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app3d/files_3.h"
#include "core/formats/number.h"
#include "layers/number_field.h"
#include "shell/popover_fields.h"

namespace mesecina {

namespace {

QString text(const char* source) { return QCoreApplication::translate("popovers", source); }

constexpr std::array<double Point_3::*, 3> coordinates{&Point_3::x, &Point_3::y, &Point_3::z};
constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

/// A field that shows a number and tells when the user gave another.
Number_field* make_number(QWidget* parent, const QString& name, double value, const std::function<void(double)>& take) {
  auto* field = new Number_field(parent);
  field->setAccessibleName(name);
  field->setToolTip(name);
  field->show_value(value);
  QObject::connect(field, &Number_field::edited, parent, [take](const std::optional<double>& number) {
    if (number) take(*number);
  });
  return field;
}

/// Widgets side by side under one label.
void add_row(Popover& popover, const QString& label, const std::vector<QWidget*>& widgets) {
  auto* row = new QHBoxLayout;
  for (QWidget* widget : widgets) row->addWidget(widget);
  popover.form()->addRow(label, row);
}

/// Dismisses the popover when something else than itself, which sets the flag meanwhile, changes the inputs.
void dismiss_with_changes(Popover* popover, const Document& document, const std::shared_ptr<bool>& is_own) {
  QObject::connect(&document, &Document::changed, popover, [popover, is_own](const Document_change& change) {
    if (change.inputs && !*is_own) popover->dismiss();
  });
}

}  // namespace

Popover* open_generator_popover_3(const Generator_3& generator, Editor_3& editor, const Point_3& center, double size,
                                  QWidget* over) {
  const QString label = QCoreApplication::translate("generators", generator.label);
  constexpr int digits = 2;
  const auto order = std::make_shared<Generator_order_3>();
  *order = {generator.usual_count, 1, rounded_to(0.05 * size, digits), rounded_to(0.2 * size, digits), center, size};
  const Inputs start = editor.document().inputs();
  auto* popover = new Popover(label, over);
  const auto is_own = std::make_shared<bool>(false);
  const auto insert = [&editor, &generator, order, is_own, start, label,
                       key = new_merge_key(QStringLiteral("generate"))] {
    *is_own = true;
    editor.document().edit_inputs(appended_3(start, generator.make(*order)), text("Insert: %1").arg(label), key);
    *is_own = false;
  };
  auto* tip = new QLabel(QCoreApplication::translate("generators", generator.tip), popover);
  tip->setWordWrap(true);
  tip->setMinimumWidth(popover->fontMetrics().height() * 13);
  popover->form()->addRow(tip);
  if (generator.usual_count > 0) {
    constexpr int most = 1000000;
    constexpr int most_segments = 1000;
    const bool is_mesh = generator.product == Product_3::mesh;
    const QString name = is_mesh                                 ? text("Segments")
                         : generator.product == Product_3::balls ? text("Balls")
                                                                 : text("Points");
    auto* count = make_count_field(is_mesh ? 3 : 1, is_mesh ? most_segments : most,
                                   static_cast<int>(generator.usual_count), popover, name);
    QObject::connect(count, &QSpinBox::valueChanged, popover, [order, insert](int value) {
      order->count = static_cast<std::size_t>(value);
      insert();
    });
    popover->form()->addRow(name, count);
  }
  const auto add_number = [&](const QString& name, double Generator_order_3::*member) {
    Number_field* field = make_number(popover, name, (*order).*member, [order, insert, member](double value) {
      (*order).*member = value;
      insert();
    });
    field->set_bounds(0, std::numeric_limits<double>::max());
    popover->form()->addRow(name, field);
  };
  if (generator.has_radii) {
    add_number(text("Least radius"), &Generator_order_3::least_radius);
    add_number(text("Greatest radius"), &Generator_order_3::greatest_radius);
  }
  if (generator.has_seed) {
    constexpr int most_seeds = 999999;
    auto* seed = make_count_field(0, most_seeds, 1, popover, text("Seed"));
    seed->setStepType(QAbstractSpinBox::DefaultStepType);
    seed->setToolTip(text("The same seed gives the same again"));
    QObject::connect(seed, &QSpinBox::valueChanged, popover, [order, insert](int value) {
      order->seed = static_cast<std::uint64_t>(value);
      insert();
    });
    popover->form()->addRow(text("Seed"), seed);
  }
  insert();
  dismiss_with_changes(popover, editor.document(), is_own);
  popover->open();
  return popover;
}

namespace {

/// A point as a ball without radius.
struct Selected_one {
  bool is_ball = false;
  std::size_t index = 0;
  Ball_3 value;
};

std::optional<Selected_one> first_selected(const Editor_3& editor) {
  const Inputs& inputs = editor.document().inputs();
  const Selection_3 known = restricted(editor.selection(), inputs);
  if (!known.points.empty())
    return Selected_one{false, known.points.front(), {(*inputs.get(cloud_input))[known.points.front()], 0}};
  if (!known.balls.empty())
    return Selected_one{true, known.balls.front(), (*inputs.get(balls_input))[known.balls.front()]};
  return std::nullopt;
}

}  // namespace

Popover* open_coordinates_popover_3(Editor_3& editor, QWidget* over) {
  if (!first_selected(editor)) return nullptr;
  auto* popover = new Popover(text("Exact coordinates"), over);
  // Lines of text show every digit.
  std::array<QLineEdit*, 4> lines{};
  const std::array<QString, 4> names{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z"), text("radius")};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i] = new QLineEdit(popover);
    lines[i]->setAccessibleName(names[i]);
    popover->form()->addRow(names[i], lines[i]);
  }
  const auto number = [](Ball_3& ball, std::size_t i) -> double& {
    return i < coordinates.size() ? ball.center.*coordinates[i] : ball.radius;
  };
  const auto show = [&editor, popover, lines, number] {
    auto one = first_selected(editor);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lines[i]->setEnabled(one.has_value());
      if (one) lines[i]->setText(QString::fromStdString(format_number(number(one->value, i))));
    }
    popover->form()->setRowVisible(lines.back(), one && one->is_ball);
  };
  const auto take = [&editor, lines, number, show, key = new_merge_key(QStringLiteral("coordinates"))](std::size_t i) {
    auto one = first_selected(editor);
    if (!one) return;
    const std::string written = lines[i]->text().trimmed().toStdString();
    const auto typed = parse_number(written);
    const bool is_radius = i == coordinates.size();
    if (!typed || !std::isfinite(*typed) || (is_radius && *typed < 0)) {
      const QString expected = is_radius ? text("a radius of at least 0") : text("a number such as 1.5");
      Q_EMIT editor.failed(text("Expected %1, found \"%2\".").arg(expected, lines[i]->text()));
      show();
      return;
    }
    number(one->value, i) = *typed;
    if (one->is_ball) {
      editor.change_ball(one->index, one->value, key);
    } else {
      editor.change_point(one->index, one->value.center, key);
    }
  };
  show();
  for (std::size_t i = 0; i < lines.size(); ++i)
    QObject::connect(lines[i], &QLineEdit::editingFinished, popover, [take, i] { take(i); });
  QObject::connect(&editor.document(), &Document::changed, popover, show);
  QObject::connect(&editor, &Editor_3::selection_changed, popover, show);
  popover->open();
  return popover;
}

Popover* open_transform_popover_3(Editor_3& editor, QWidget* over) {
  const Inputs start = editor.document().inputs();
  const Box box = bounding_box(start);
  if (box.is_empty()) {
    Q_EMIT editor.failed(text("There is nothing to transform yet."));
    return nullptr;
  }
  auto* popover = new Popover(text("Transform"), over);
  const auto transform = std::make_shared<Transform_3>();
  const Point_3 middle = midpoint(box.lower, box.upper);
  transform->pivot = middle;
  const auto is_own = std::make_shared<bool>(false);
  const auto apply = [&editor, start, transform, is_own, key = new_merge_key(QStringLiteral("transform"))] {
    *is_own = true;
    editor.transform(start, *transform, key);
    *is_own = false;
  };
  std::vector<Number_field*> shifts;
  std::vector<QWidget*> turns;
  std::vector<QWidget*> mirrors;
  std::vector<std::function<void()>> shows;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const QString axis = QLatin1String(axis_names[i]);
    shifts.push_back(make_number(popover, text("Move along %1").arg(axis), 0, [transform, apply, i](double number) {
      transform->shift.*coordinates[i] = number;
      apply();
    }));
    auto* turn =
        make_number(popover, text("Turn about %1, in degrees").arg(axis), 0, [transform, apply, i](double number) {
          transform->degrees[i] = number;
          apply();
        });
    turn->set_suffix(QStringLiteral("°"));
    turn->show_value(0);
    constexpr double step = 5;
    turn->set_step(step);
    turns.push_back(turn);
    auto* mirror = new QCheckBox(axis, popover);
    mirror->setToolTip(text("Left and right along %1 change places").arg(axis));
    mirror->setAccessibleName(text("Mirror along %1").arg(axis));
    QObject::connect(mirror, &QCheckBox::toggled, popover, [transform, apply, i](bool is_mirrored) {
      transform->mirrored[i] = is_mirrored;
      apply();
    });
    mirrors.push_back(mirror);
    shows.push_back([transform, i, shift = shifts.back(), turn, mirror] {
      shift->show_value(transform->shift.*coordinates[i]);
      turn->show_value(transform->degrees[i]);
      mirror->setChecked(transform->mirrored[i]);
    });
  }
  Number_field* scale = make_number(popover, text("Times as large"), 1, [transform, apply](double number) {
    if (!(number > 0)) return;
    transform->scale = number;
    apply();
  });
  scale->set_bounds(std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
  shows.push_back([transform, scale] { scale->show_value(transform->scale); });
  auto* about = new QComboBox(popover);
  about->addItems({text("the middle"), text("the origin")});
  about->setAccessibleName(text("Turn, scale and mirror about"));
  about->setToolTip(text("What stays in place while the data is turned, scaled and mirrored"));
  QObject::connect(about, &QComboBox::currentIndexChanged, popover, [transform, apply, middle](int index) {
    transform->pivot = index == 0 ? middle : Point_3{};
    apply();
  });
  std::vector<QWidget*> headings;
  for (const char* axis : axis_names) {
    auto* heading = new QLabel(QLatin1String(axis), popover);
    heading->setAlignment(Qt::AlignCenter);
    headings.push_back(heading);
  }
  add_row(*popover, {}, headings);
  add_row(*popover, text("Move"), {shifts.begin(), shifts.end()});
  add_row(*popover, text("Turn"), turns);
  popover->form()->addRow(text("Scale"), scale);
  add_row(*popover, text("Mirror"), mirrors);
  popover->form()->addRow(text("About"), about);
  auto* buttons = new QHBoxLayout;
  const auto add_button = [&](const QString& name, const QString& tip,
                              const std::function<Transform_3(const Inputs&, Transform_3)>& change) {
    auto* button = new QPushButton(name, popover);
    button->setToolTip(tip);
    button->setAutoDefault(false);
    QObject::connect(button, &QPushButton::clicked, popover, [start, transform, apply, shows, change] {
      *transform = change(start, *transform);
      for (const auto& show : shows) show();
      apply();
    });
    buttons->addWidget(button);
  };
  add_button(text("Center"), text("Move the middle of the box around the data to the origin"), centered);
  add_button(text("Normalize"), text("Center, and scale the diagonal of the box to 1"), normalized);
  add_button(text("Reset"), text("As it was"), [](const Inputs&, const Transform_3& now) {
    Transform_3 still;
    still.pivot = now.pivot;
    return still;
  });
  popover->column()->addLayout(buttons);
  dismiss_with_changes(popover, editor.document(), is_own);
  popover->open();
  return popover;
}

}  // namespace mesecina
