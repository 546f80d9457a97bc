// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/statistics_panel.h"

#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>
#include <ostream>
#include <utility>

#include "core/formats/format.h"

namespace mesecina {

namespace {

constexpr std::chrono::milliseconds one_gesture{500};

QString words_for(const Run_record& run) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(run.time.time_since_epoch()).count();
  return Statistics_panel::tr("%1: %2, %3")
      .arg(run.number)
      .arg(QString::fromStdString(run.what),
           QDateTime::fromSecsSinceEpoch(seconds).toString(QStringLiteral("HH:mm:ss")));
}

QString cell_text(const Compared_row& row, std::size_t run) {
  const std::optional<Run_row>& cell = row.runs[run];
  if (!cell) return QStringLiteral("–");
  if (!cell->number) return QString::fromStdString(cell->text);
  constexpr int digits = 6;
  constexpr double mega = 1e6;
  if (row.section == "Memory") return Statistics_panel::tr("%1 MB").arg(*cell->number / mega, 0, 'f', 1);
  const bool is_whole = *cell->number == static_cast<double>(static_cast<std::int64_t>(*cell->number));
  return is_whole ? QString::number(static_cast<qlonglong>(*cell->number))
                  : QString::number(*cell->number, 'g', digits);
}

}  // namespace

Statistics_panel::Statistics_panel(QWidget* parent)
    : QWidget(parent), shown_(new QComboBox(this)), compared_(new QComboBox(this)), table_(new QTreeWidget(this)) {
  shown_->setAccessibleName(tr("Run"));
  shown_->setToolTip(tr("The computation that the table is about; the newest is followed"));
  compared_->setAccessibleName(tr("Compare with"));
  compared_->setToolTip(tr("Another computation beside it"));
  table_->setAccessibleName(tr("Statistics"));
  table_->setToolTip(tr("Counts, topology, errors reached, seconds and memory of computations"));
  table_->setAlternatingRowColors(true);
  table_->setUniformRowHeights(true);
  auto* to_file = new QPushButton(tr("Export…"), this);
  to_file->setToolTip(tr("Write every run into a table (CSV) or as JSON"));
  auto* choices = new QHBoxLayout;
  choices->addWidget(new QLabel(tr("Run"), this));
  choices->addWidget(shown_, 1);
  choices->addWidget(new QLabel(tr("beside"), this));
  choices->addWidget(compared_, 1);
  choices->addWidget(to_file);
  auto* column = new QVBoxLayout(this);
  column->addLayout(choices);
  column->addWidget(table_, 1);
  for (QComboBox* box : {shown_, compared_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(box, &QComboBox::activated, this, &Statistics_panel::fill_table);
  }
  connect(to_file, &QPushButton::clicked, this, &Statistics_panel::export_requested);
  fill_choices();
}

void Statistics_panel::add(Run_record record, std::vector<Scene_layer> layers) {
  const bool is_same_gesture =
      !runs_.empty() && runs_.back().what == record.what && record.time - runs_.back().time < one_gesture;
  if (is_same_gesture) runs_.pop_back();
  record.number = is_same_gesture ? next_number_ - 1 : next_number_++;
  runs_.push_back(std::move(record));
  if (runs_.size() > most_runs) runs_.erase(runs_.begin());
  layers_ = std::move(layers);
  if (!isVisible()) return;
  fill_choices();
  find_topology();
}

void Statistics_panel::write(const QString& path) const {
  const bool is_json = path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
  write_file(path.toStdString(), [&](std::ostream& stream) { stream << (is_json ? to_json(runs_) : to_csv(runs_)); });
}

void Statistics_panel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  fill_choices();
  find_topology();
}

void Statistics_panel::fill_choices() {
  // Whoever looks at the newest goes on to look at the newest.
  const bool is_newest = shown_->currentIndex() <= 0;
  const QVariant shown = shown_->currentData();
  const QVariant compared = compared_->currentData();
  shown_->clear();
  compared_->clear();
  compared_->addItem(tr("no other"), 0);
  for (auto run = runs_.rbegin(); run != runs_.rend(); ++run) {
    shown_->addItem(words_for(*run), run->number);
    compared_->addItem(words_for(*run), run->number);
  }
  if (!is_newest) shown_->setCurrentIndex(std::max(0, shown_->findData(shown)));
  compared_->setCurrentIndex(std::max(0, compared_->findData(compared)));
  fill_table();
}

void Statistics_panel::fill_table() {
  std::vector<Run_record> chosen;
  QStringList titles{tr("What")};
  for (const QComboBox* box : {shown_, compared_}) {
    const auto run = std::ranges::find(runs_, box->currentData().toInt(), &Run_record::number);
    if (run == runs_.end()) continue;
    chosen.push_back(*run);
    titles << tr("Run %1").arg(run->number);
  }
  table_->clear();
  table_->setColumnCount(static_cast<int>(titles.size()));
  table_->setHeaderLabels(titles);
  QTreeWidgetItem* section = nullptr;
  for (const Compared_row& row : compared_rows(chosen)) {
    const QString title = QString::fromStdString(row.section);
    if (!section || section->text(0) != title) {
      section = new QTreeWidgetItem(table_, {title});
      section->setExpanded(true);
    }
    QStringList cells{QString::fromStdString(row.name)};
    for (std::size_t i = 0; i < chosen.size(); ++i) cells << cell_text(row, i);
    auto* line = new QTreeWidgetItem(section, cells);
    for (int i = 1; i < line->columnCount(); ++i) line->setToolTip(i, line->text(i));
  }
  table_->header()->setSectionResizeMode(QHeaderView::Interactive);
  table_->resizeColumnToContents(0);
}

void Statistics_panel::find_topology() {
  if (layers_.empty() || runs_.empty() || jobs_.is_busy()) return;
  const auto find = [this, run = runs_.back().number, layers = std::exchange(layers_, {})]() -> std::function<void()> {
    std::map<std::string, Topology> found;
    for (const Scene_layer& layer : layers) {
      if (!layer.primitives || !layer.primitives->is_complex) continue;
      const auto known = topology(layer.cut ? apply_cut(*layer.primitives, *layer.cut) : *layer.primitives);
      if (known) found[layer.id] = *known;
    }
    return [this, run, found] { take_topology(run, found); };
  };
  jobs_.run(tr("Topology"), find);
}

void Statistics_panel::take_topology(int run, const std::map<std::string, Topology>& found) {
  const auto record = std::ranges::find(runs_, run, &Run_record::number);
  if (record == runs_.end()) return;
  for (Layer_record& layer : record->layers)
    if (const auto known = found.find(layer.id); known != found.end()) layer.topology = known->second;
  fill_table();
  find_topology();
}

}  // namespace mesecina
