// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <algorithm>
#include <fstream>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "app3d/main_window_3.h"

namespace mesecina {

namespace {

using Kind = Parameter::Kind;
using Count = Parameter::Count;

QString tr(const char* text) { return QCoreApplication::translate("commands", text); }

Parameter coordinate(const char* name) { return {QLatin1String(name), tr("in units of the data"), Kind::number}; }

std::vector<std::size_t> indices_of(const QStringList& words, std::size_t count, const QString& id) {
  std::vector<std::size_t> indices;
  for (const QString& word : words) {
    const std::size_t index = word.toULongLong();
    if (index >= count)
      throw Command_error(count == 0 ? tr("%1: there are none").arg(id)
                                     : tr("%1: expected numbers up to %2, found %3").arg(id).arg(count - 1).arg(word));
    indices.push_back(index);
  }
  if (words.isEmpty()) {
    indices.resize(count);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
  }
  std::ranges::sort(indices);
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

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
                  {coordinate("X"), coordinate("Y"), coordinate("Z")},
                  [this](const Arguments& arguments) {
                    editor_->add_point({arguments.number(0), arguments.number(1), arguments.number(2)});
                  }});
  commands_->add(
      {QStringLiteral("add-ball"),
       tr("Add a ball"),
       tr("Adds a ball and selects it"),
       group,
       {coordinate("X"),
        coordinate("Y"),
        coordinate("Z"),
        {QStringLiteral("RADIUS"), tr("in units of the data"), Kind::number, Count::one, {}, 0}},
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
  const auto add_choice = [&](const char* id, const QString& name, const QString& help,
                              std::function<Selection_3(const QStringList&)> choose) {
    commands_->add(
        {QLatin1String(id),
         name,
         help,
         group,
         {{QStringLiteral("N"), tr("numbers, counted from 0; all if there is none"), Kind::whole, Count::any, {}, 0}},
         [this, choose = std::move(choose)](const Arguments& arguments) {
           editor_->select(choose(arguments.all(0)));
         }});
  };
  add_choice("select-points", tr("Select points"), tr("Selects these points and nothing else"),
             [this](const QStringList& words) {
               const auto points = document_.inputs().get(cloud_input);
               return Selection_3{indices_of(words, points ? points->size() : 0, QStringLiteral("select-points"))};
             });
  add_choice("select-balls", tr("Select balls"), tr("Selects these balls and nothing else"),
             [this](const QStringList& words) {
               const auto balls = document_.inputs().get(balls_input);
               return Selection_3{{}, indices_of(words, balls ? balls->size() : 0, QStringLiteral("select-balls"))};
             });
  const auto expect_selection = [this](const QString& id) {
    if (editor_->selection().is_empty()) throw Command_error(tr("%1: nothing is selected").arg(id));
  };
  commands_->add({QStringLiteral("move"),
                  tr("Move the selection"),
                  tr("Moves what is selected"),
                  group,
                  {coordinate("DX"), coordinate("DY"), coordinate("DZ")},
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
  commands_->add(
      {QStringLiteral("export-picture"),
       tr("Export a picture"),
       tr("Writes what is in view, by the extension"),
       tr("File"),
       {{QStringLiteral("FILE"), tr("where to")},
        {QStringLiteral("WxH"), tr("in pixels; that of the canvas if there is none"), Kind::size, Count::optional},
        {QStringLiteral("transparent"), tr("without a background"), Kind::flag}},
       [this](const Arguments& arguments) {
         const QSize usual = (QSizeF(canvas_->size()) * canvas_->devicePixelRatioF()).toSize();
         const auto [width, height] = arguments.has(1) ? arguments.size(1) : std::pair(usual.width(), usual.height());
         Scene scene = computation_.scene(background());
         scene.transparent_background = arguments.has(2);
         files_->export_picture(arguments.word(0), {std::move(scene), {}, seen_view()}, QSize(width, height));
       },
       true});
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
