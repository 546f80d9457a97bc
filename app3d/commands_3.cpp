// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "app3d/main_window_3.h"
#include "shell/common_commands.h"

namespace mesecina {

namespace {

using Kind = Parameter::Kind;
using Count = Parameter::Count;

}  // namespace

void Main_window_3::make_own_commands() {
  make_commands();
  make_insert_commands();
  make_selection_commands();
  make_view_commands();
}

void Main_window_3::make_insert_commands() {
  const QString group = tr("Insert");
  commands_->add({QStringLiteral("add-point"),
                  tr("Add a point"),
                  tr("Adds a point and selects it"),
                  group,
                  {coordinate_parameter("X"), coordinate_parameter("Y"), coordinate_parameter("Z")},
                  [this](const Arguments& arguments) {
                    editor_->add_point({arguments.number(0), arguments.number(1), arguments.number(2)});
                  }});
  commands_->add(
      {QStringLiteral("add-ball"),
       tr("Add a ball"),
       tr("Adds a ball and selects it"),
       group,
       {coordinate_parameter("X"), coordinate_parameter("Y"), coordinate_parameter("Z"), radius_parameter()},
       [this](const Arguments& arguments) {
         editor_->add_ball({{arguments.number(0), arguments.number(1), arguments.number(2)}, arguments.number(3)});
       }});
  commands_->add(
      {QStringLiteral("open-example"),
       tr("Open example"),
       tr("Replaces the data by that of an example"),
       tr("File"),
       {{QStringLiteral("NAME"), tr("name of an example"), Kind::text, Count::one, [] { return Files_3::examples(); }}},
       [this](const Arguments& arguments) {
         document_.edit_inputs(Files_3::example(arguments.word(0)), tr("Open the example %1").arg(arguments.word(0)));
         fit();
       }});
  for (const Generator_3& generator : generators_3()) {
    const QString id = QStringLiteral("insert-") + QString::fromStdString(generator.id);
    const Actions::Entry* action = actions_->find(id);
    commands_->add(
        {id,
         action->name,
         action->action->statusTip(),
         group,
         {{QStringLiteral("COUNT"), tr("how many; of a mesh, segments around it"), Kind::whole, Count::optional, {}, 1},
          {QStringLiteral("SEED"), tr("of random numbers"), Kind::whole, Count::optional, {}, 0}},
         [this, &generator, name = action->name](const Arguments& arguments) {
           const auto [center, size] = usual_place();
           constexpr double least = 0.05;
           constexpr double greatest = 0.2;
           Generator_order_3 order{generator.usual_count, 1, least * size, greatest * size, center, size};
           order.count = static_cast<std::size_t>(arguments.whole(0, static_cast<int>(order.count)));
           order.seed = static_cast<std::uint64_t>(arguments.whole(1, 1));
           const bool is_first_data = document_.inputs().is_empty();
           document_.edit_inputs(appended_3(document_.inputs(), generator.make(order)), tr("Insert: %1").arg(name));
           if (is_first_data) fit();
         }});
  }
}

void Main_window_3::make_selection_commands() {
  const QString group = tr("Edit");
  commands_->add(selection_command(
      QStringLiteral("select-points"), tr("Select points"), tr("Selects these points and nothing else"),
      [this] {
        const auto points = document_.inputs().get(cloud_input);
        return points ? points->size() : 0;
      },
      [this](std::vector<std::size_t> indices) { editor_->select(Selection_3{std::move(indices)}); }));
  commands_->add(selection_command(
      QStringLiteral("select-balls"), tr("Select balls"), tr("Selects these balls and nothing else"),
      [this] {
        const auto balls = document_.inputs().get(balls_input);
        return balls ? balls->size() : 0;
      },
      [this](std::vector<std::size_t> indices) {
        editor_->select(Selection_3{{}, std::move(indices)});
      }));
  const auto expect_selection = [this](const QString& id) {
    if (editor_->selection().is_empty()) throw Command_error(tr("%1: nothing is selected").arg(id));
  };
  commands_->add({QStringLiteral("move"),
                  tr("Move the selection"),
                  tr("Moves what is selected"),
                  group,
                  {coordinate_parameter("DX"), coordinate_parameter("DY"), coordinate_parameter("DZ")},
                  [this, expect_selection](const Arguments& arguments) {
                    expect_selection(QStringLiteral("move"));
                    editor_->nudge({arguments.number(0), arguments.number(1), arguments.number(2)});
                  }});
  commands_->add({QStringLiteral("resize"),
                  tr("Resize selected balls"),
                  tr("Multiplies the radii of selected balls"),
                  group,
                  {{QStringLiteral("FACTOR"), tr("1 leaves them"), Kind::number, Count::one, {}, 0}},
                  [this, expect_selection](const Arguments& arguments) {
                    expect_selection(QStringLiteral("resize"));
                    document_.edit_inputs(resized(document_.inputs(), editor_->selection(), arguments.number(0)),
                                          tr("Resize balls"));
                  }});
}

void Main_window_3::make_view_commands() {
  commands_->add({QStringLiteral("view"),
                  tr("View"),
                  tr("Sees the scene from elsewhere: fit shows all of the data"),
                  tr("View"),
                  {{QStringLiteral("fit|FILE|TEXT"), tr("fit, or a view file, or its text")}},
                  [this](const Arguments& arguments) { view_text_or_file(arguments.word(0)); }});
  commands_->add({QStringLiteral("open-view"),
                  tr("Open view"),
                  tr("Sees the scene from where a view file says"),
                  tr("File"),
                  {{QStringLiteral("FILE"), tr("a view file")}},
                  [this](const Arguments& arguments) { view_text_or_file(arguments.word(0)); }});
  commands_->add({QStringLiteral("save-view"),
                  tr("Save view"),
                  tr("Writes a view file"),
                  tr("File"),
                  {{QStringLiteral("FILE"), tr("where to")}},
                  [this](const Arguments& arguments) {
                    if (!viewer_) throw Command_error(tr("save-view: nothing is seen without OpenGL"));
                    write_file(arguments.word(0).toStdString(), [&](std::ostream& stream) { stream << view_text(); });
                  }});
  // Of where a flight ends, so that a script need not wait for it.
  commands_->add(picture_command([this] { return (QSizeF(canvas_->size()) * canvas_->devicePixelRatioF()).toSize(); },
                                 [this](const QString& file, const QSize& size, bool is_transparent) {
                                   Scene scene = computation_.scene(background());
                                   scene.transparent_background = is_transparent || is_without_background();
                                   files_->export_picture(file, {std::move(scene), {}, seen_view()}, size);
                                 }));
}

View_3 Main_window_3::seen_view() const {
  if (viewer_) return viewer_->destination();
  View_3 view;
  view.camera = fit_camera(bounding_box(document_.inputs()), canvas_->width(), canvas_->height());
  return view;
}

void Main_window_3::view_text_or_file(const QString& text) {
  if (text == QLatin1String("fit")) {
    fit();
    return;
  }
  std::string view = text.toStdString();
  const bool is_file = !text.trimmed().startsWith(QLatin1Char('{'));
  if (is_file) {
    std::ifstream stream(view);
    if (!stream) throw Command_error(tr("view: expected fit, a view file or its text, found '%1'").arg(text));
    std::ostringstream all;
    all << stream.rdbuf();
    view = all.str();
  }
  try {
    // Without a viewer, too, so that a wrong text is told.
    const View_3 wanted = parse_view_3(view);
    if (viewer_) viewer_->set_view(wanted);
  } catch (const std::invalid_argument& error) {
    throw Command_error(is_file ? tr("%1: %2").arg(text, QString::fromUtf8(error.what()))
                                : tr("view: %1").arg(QString::fromUtf8(error.what())));
  }
}

}  // namespace mesecina
