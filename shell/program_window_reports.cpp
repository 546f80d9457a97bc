// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDesktopServices>
#include <QDockWidget>
#include <QFileInfo>
#include <QUrl>
#include <algorithm>
#include <ostream>
#include <utility>

#include "core/batch/statistics.h"
#include "shell/evolution_track.h"
#include "shell/program_window.h"

namespace mesecina {

void Program_window::build_reports() {
  statistics_ = new Statistics_panel(this);
  log_ = new Log_panel(this);
  statistics_dock_ =
      add_dock(QStringLiteral("statistics-dock"), tr("Statistics"), statistics_, Qt::BottomDockWidgetArea);
  log_dock_ = add_dock(QStringLiteral("log-dock"), tr("Log"), log_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(statistics_dock_, log_dock_);
  statistics_dock_->hide();
  log_dock_->hide();
  const auto write = [this](const QString& title, const QString& name, const QString& filters,
                            const std::function<void(const QString&)>& save) {
    const QString path = common_files_->choose_for_writing(title, name, filters);
    if (path.isEmpty()) return;
    try {
      save(path);
    } catch (const std::exception& error) {
      messages_->add(Message_bar::Kind::error, QString::fromUtf8(error.what()));
    }
  };
  connect(statistics_, &Statistics_panel::export_requested, this, [this, write] {
    write(tr("Export statistics"), common_files_->stem() + QStringLiteral(".stats"), tr("Table (*.csv);;JSON (*.json)"),
          [this](const QString& path) { statistics_->write(path); });
  });
  connect(log_, &Log_panel::save_requested, this, [this, write] {
    write(tr("Save the log"), common_files_->stem() + QStringLiteral(".log"), tr("Text (*.txt)"),
          [this](const QString& path) {
            write_file(path.toStdString(), [&](std::ostream& stream) { stream << log_->text().toStdString(); });
          });
  });
  connect(log_, &Log_panel::places_chosen, this, &Program_window::show_places);
  connect(log_, &Log_panel::layer_chosen, this, [this](const QString& layer) {
    layers_dock_->show();
    layer_panel_->select({layer});
  });
  connect(log_, &Log_panel::file_chosen, this, [](const QString& path) {
    const QFileInfo info(path);
    QDesktopServices::openUrl(QUrl::fromLocalFile(info.isDir() ? path : info.absolutePath()));
  });
  connect(messages_, &Message_bar::added, this, [this](Message_bar::Kind kind, const QString& line) {
    log_->add({kind, tr("Window"), line, {}});
  });
  connect(&computation_, &Computation::reported, this, &Program_window::record_run);
  connect(&computation_, &Computation::layer_changed, this,
          [this](const QString& layer) { log_layer(layer.toStdString()); });
  const auto add_toggle = [this](const char* id, const QString& text, const QString& tip, const QKeySequence& key,
                                 QDockWidget* dock) {
    actions_->add(tr("View"), {QLatin1String(id), text, tip, {key}}, [dock] {
      dock->setVisible(!dock->isVisible());
      if (dock->isVisible()) dock->raise();
    });
  };
  add_toggle("show-statistics", tr("S&tatistics"), tr("Show or hide what computations have cost and found out"),
             QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_T), statistics_dock_);
  add_toggle("show-log", tr("Lo&g"), tr("Show or hide everything the program has said"),
             QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_L), log_dock_);
}

/// What is computed: the last thing that was done, or, where an evolution is gone through, the place in it.
QString Program_window::name_of_run() {
  const Track_pointer& track = document_.track();
  const QString done = document_.history().undoText();
  if (!track) return done.isEmpty() ? tr("Start") : done;
  const std::size_t position = document_.position();
  if (position == 0) return tr("Before the first step");
  const std::string& id = track->places[position].evolution;
  const Evolution_spec* evolution = registry_->find_evolution(id);
  return tr("%1: step %2 of %3")
      .arg(QString::fromStdString(evolution ? evolution->label : id))
      .arg(position)
      .arg(track->step_count());
}

void Program_window::record_run(const Worker::Report& report) {
  Run_record record;
  record.what = name_of_run().toStdString();
  record.time = std::chrono::system_clock::now();
  record.seconds = report.seconds;
  record.memory = present_memory();
  record.counts = count_inputs(document_.inputs());
  record.stages = report.stages;
  record.measures = report.measures;
  record.notes = report.notes;
  std::vector<Scene_layer> pictures;
  const Layer_list& layers = document_.layers();
  for (auto entry = layers.rbegin(); entry != layers.rend(); ++entry) {
    const Layer_spec* spec = registry_->find_layer(entry->id);
    if (!entry->style.visible || !spec) continue;
    const auto primitives = computation_.primitives(entry->id);
    const Layer_status status = computation_.status(entry->id);
    Layer_record layer{entry->id, spec->label, 0, 0, {}, status.reason.toStdString()};
    if (primitives) {
      layer.elements = primitives->element_count();
      layer.vertices = primitives->vertices.size();
      pictures.push_back({entry->id, spec->label, primitives, registry_->cut(*spec, document_.settings()), {}});
    }
    for (const QString& warning : status.warnings)
      if (std::ranges::find(record.warnings, warning.toStdString()) == record.warnings.end())
        record.warnings.push_back(warning.toStdString());
    record.layers.push_back(std::move(layer));
  }
  statistics_->add(std::move(record), std::move(pictures));
}

void Program_window::log_layer(const std::string& layer) {
  const Layer_status status = computation_.status(layer);
  const bool is_done = status.state == Layer_status::State::current || status.state == Layer_status::State::failed;
  // That there is no input of the kind a layer is about is no failure.
  if (!is_done || (!status.reason.isEmpty() && !is_worth_a_note(status.reason))) return;
  const QStringList texts = status.reason.isEmpty() ? status.warnings : QStringList(status.reason);
  if (std::exchange(logged_[layer], texts) == texts || texts.isEmpty()) return;
  // Layers that rest on one structure warn of the same.
  const auto is_said_of_others = [&](const QString& text) {
    return std::ranges::any_of(logged_,
                               [&](const auto& said) { return said.first != layer && said.second.contains(text); });
  };
  const Layer_spec* spec = registry_->find_layer(layer);
  const QString source = QString::fromStdString(spec ? spec->label : layer);
  const QString id = QString::fromStdString(layer);
  if (!status.reason.isEmpty()) log_->add({Message_bar::Kind::error, source, status.reason, id});
  for (qsizetype i = 0; status.reason.isEmpty() && i < status.warnings.size(); ++i)
    if (!is_said_of_others(status.warnings[i]))
      log_->add(
          {Message_bar::Kind::warning, source, status.warnings[i], id, status.places.at(static_cast<std::size_t>(i))});
}

}  // namespace mesecina
