// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "app2d/main_window_2.h"
#include "app2d/popovers_2.h"
#include "core/formats/number.h"
#include "shell/common_commands.h"

namespace mesecina {

namespace {

using Kind = Parameter::Kind;
using Count = Parameter::Count;

QString tr(const char* text) { return QCoreApplication::translate("commands", text); }

/// Vertices from x and y one after the other. Throws Command_error for another number of them than pairs of three or
/// more.
Ring_2 ring_of(const QStringList& numbers) {
  constexpr qsizetype least = 6;
  if (numbers.size() < least || numbers.size() % 2 != 0)
    throw Command_error(
        tr("add-outline: expected x and y of three vertices or more, found %1 numbers").arg(numbers.size()));
  Ring_2 ring;
  for (qsizetype i = 0; i < numbers.size(); i += 2)
    ring.push_back({*parse_number(numbers[i].toStdString()), *parse_number(numbers[i + 1].toStdString())});
  return ring;
}

void expect_selection(const Editor_2& editor, const QString& id) {
  if (editor.selection().is_empty()) throw Command_error(tr("%1: nothing is selected").arg(id));
}

}  // namespace

void Main_window_2::make_own_commands() {
  make_commands();
  make_insert_commands();
  make_selection_commands();
  make_view_commands();
}

void Main_window_2::make_insert_commands() {
  const QString group = tr("Insert");
  commands_->add({QStringLiteral("add-point"),
                  tr("Add a point"),
                  tr("Adds a point and selects it"),
                  group,
                  {coordinate_parameter("X"), coordinate_parameter("Y")},
                  [this](const Arguments& arguments) {
                    editor_->add_point({arguments.number(0), arguments.number(1)});
                  }});
  commands_->add({QStringLiteral("add-disk"),
                  tr("Add a disk"),
                  tr("Adds a disk and selects it"),
                  group,
                  {coordinate_parameter("X"), coordinate_parameter("Y"), radius_parameter()},
                  [this](const Arguments& arguments) {
                    editor_->add_disk({{arguments.number(0), arguments.number(1)}, arguments.number(2)});
                  }});
  commands_->add({QStringLiteral("add-outline"),
                  tr("Add an outline"),
                  tr("Adds a closed polygon"),
                  group,
                  {{QStringLiteral("X Y"), tr("its vertices"), Kind::number, Count::some}},
                  [this](const Arguments& arguments) { editor_->add_ring(ring_of(arguments.all(0))); }});
  commands_->add({QStringLiteral("open-example"),
                  tr("Open example"),
                  tr("Replaces the data by that of an example"),
                  tr("File"),
                  {{QStringLiteral("NAME"), tr("file name of an example"), Kind::text, Count::one,
                    [] { return Files_2::examples(); }}},
                  [this](const Arguments& arguments) { files_->open_example(arguments.word(0)); }});
  for (const Generator_2& generator : generators_2()) {
    const QString id = QStringLiteral("insert-") + QString::fromStdString(generator.id);
    const Actions::Entry* action = actions_->find(id);
    commands_->add({id,
                    action->name,
                    action->action->statusTip(),
                    group,
                    {{QStringLiteral("COUNT"), tr("how many"), Kind::whole, Count::optional, {}, 1},
                     {QStringLiteral("SEED"), tr("of random numbers"), Kind::whole, Count::optional, {}, 0}},
                    [this, &generator, name = action->name](const Arguments& arguments) {
                      Generator_order_2 order = usual_order(generator, document_.inputs(), *canvas_);
                      order.count = static_cast<std::size_t>(arguments.whole(0, static_cast<int>(order.count)));
                      order.seed = static_cast<std::uint64_t>(arguments.whole(1, static_cast<int>(order.seed)));
                      const bool is_first_data = order.inputs.is_empty();
                      const Inputs made = generated(generator, order);
                      if (made.is_empty()) throw Command_error(tr("%1: there is nothing to start from").arg(name));
                      document_.edit_inputs(appended(order.inputs, made), tr("Insert: %1").arg(name));
                      if (is_first_data) canvas_->fit(bounding_box(document_.inputs()));
                    }});
  }
}

void Main_window_2::make_selection_commands() {
  const QString group = tr("Edit");
  commands_->add(selection_command(
      QStringLiteral("select-points"), tr("Select points"), tr("Selects these points and nothing else"),
      [this] {
        const auto points = document_.inputs().get(points_input);
        return points ? points->size() : 0;
      },
      [this](std::vector<std::size_t> indices) { editor_->select(Selection_2{std::move(indices)}); }));
  commands_->add(selection_command(
      QStringLiteral("select-disks"), tr("Select disks"), tr("Selects these disks and nothing else"),
      [this] {
        const auto disks = document_.inputs().get(disks_input);
        return disks ? disks->size() : 0;
      },
      [this](std::vector<std::size_t> indices) {
        editor_->select(Selection_2{{}, {}, std::move(indices)});
      }));
  commands_->add({QStringLiteral("move"),
                  tr("Move the selection"),
                  tr("Moves what is selected"),
                  group,
                  {coordinate_parameter("DX"), coordinate_parameter("DY")},
                  [this](const Arguments& arguments) {
                    expect_selection(*editor_, QStringLiteral("move"));
                    editor_->nudge(arguments.number(0), arguments.number(1));
                  }});
  commands_->add({QStringLiteral("place"),
                  tr("Place the selection"),
                  tr("Moves the first selected point, vertex or center to a place"),
                  group,
                  {coordinate_parameter("X"), coordinate_parameter("Y")},
                  [this](const Arguments& arguments) {
                    expect_selection(*editor_, QStringLiteral("place"));
                    editor_->place({arguments.number(0), arguments.number(1)}, {});
                  }});
  commands_->add({QStringLiteral("resize"),
                  tr("Resize selected disks"),
                  tr("Multiplies the radii of selected disks"),
                  group,
                  {{QStringLiteral("FACTOR"), tr("1 leaves them"), Kind::number, Count::one, {}, 0}},
                  [this](const Arguments& arguments) {
                    expect_selection(*editor_, QStringLiteral("resize"));
                    document_.edit_inputs(resized(document_.inputs(), editor_->selection(), arguments.number(0)),
                                          tr("Resize disks"));
                  }});
}

void Main_window_2::make_view_commands() {
  const QString group = tr("View");
  commands_->add(
      {QStringLiteral("view"),
       tr("View"),
       tr("Shows another part of the plane: fit shows all of the data"),
       group,
       {{QStringLiteral("fit|XMIN XMAX YMIN YMAX"), tr("fit, or what should be seen"), Kind::text, Count::some}},
       [this](const Arguments& arguments) { view_box(arguments.all(0)); }});
  commands_->add(picture_command([this] { return canvas_->size() * canvas_->devicePixelRatioF(); },
                                 [this](const QString& file, const QSize& size, bool is_transparent) {
                                   Film_frame frame = picture_frame(size, canvas_->size());
                                   frame.scene.transparent_background = is_transparent || is_without_background();
                                   files_->export_picture(file, std::move(frame), size);
                                 }));
}

void Main_window_2::view_box(const QStringList& words) {
  if (words == QStringList{QStringLiteral("fit")}) {
    canvas_->fit(bounding_box(document_.inputs()));
    return;
  }
  std::vector<double> sides;
  for (const QString& word : words)
    if (const auto number = parse_number(word.toStdString())) sides.push_back(*number);
  constexpr qsizetype four = 4;
  if (words.size() != four || sides.size() != four || !(sides[1] > sides[0]) || !(sides[3] > sides[2]))
    throw Command_error(tr("view: expected fit or XMIN XMAX YMIN YMAX, found '%1'").arg(words.join(QLatin1Char(' '))));
  canvas_->set_view({{(sides[0] + sides[1]) / 2, (sides[2] + sides[3]) / 2},
                     std::min(canvas_->width() / (sides[1] - sides[0]), canvas_->height() / (sides[3] - sides[2]))});
}

}  // namespace mesecina
