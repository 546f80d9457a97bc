// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/log_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTreeWidget>

#include "layers/panel_paint.h"

namespace mesecina {

namespace {

QString level_text(Message_bar::Kind kind) {
  switch (kind) {
    case Message_bar::Kind::error:
      return Log_panel::tr("error");
    case Message_bar::Kind::warning:
      return Log_panel::tr("warning");
    default:
      return Log_panel::tr("note");
  }
}

QString line_of(const Log_panel::Entry& entry) {
  return QStringList{entry.time.toString(Qt::ISODate), level_text(entry.kind), entry.source, entry.text}.join(
      QLatin1Char('\t'));
}

bool leads_somewhere(const Log_panel::Entry& entry) {
  return !entry.places.empty() || !entry.layer.isEmpty() || !path_in(entry.text).isEmpty();
}

}  // namespace

QString path_in(const QString& text) {
  static const QRegularExpression between(QStringLiteral("[\\s\"']+"));
  for (QString word : text.split(between, Qt::SkipEmptyParts)) {
    // "FILE:LINE: what is wrong"
    while (!word.isEmpty() && word.startsWith(QLatin1Char('/'))) {
      if (QFileInfo::exists(word)) return word;
      const qsizetype colon = word.lastIndexOf(QLatin1Char(':'));
      word = colon < 0 ? QString() : word.left(colon);
    }
  }
  return {};
}

Log_panel::Log_panel(QWidget* parent) : QWidget(parent), level_(new QComboBox(this)), list_(new QTreeWidget(this)) {
  level_->setAccessibleName(tr("Least level"));
  level_->setToolTip(tr("What is shown"));
  level_->addItem(tr("Everything"), static_cast<int>(Message_bar::Kind::note));
  level_->addItem(tr("Warnings and errors"), static_cast<int>(Message_bar::Kind::warning));
  level_->addItem(tr("Errors"), static_cast<int>(Message_bar::Kind::error));
  list_->setAccessibleName(tr("Log"));
  list_->setToolTip(
      tr("Double click or Enter: show the place and select what is there, select the layer, or open the folder of the "
         "file"));
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setHeaderLabels({tr("Time"), tr("Level"), tr("From"), tr("Message")});
  list_->header()->setStretchLastSection(true);
  auto* row = new QHBoxLayout;
  row->addWidget(level_);
  row->addStretch(1);
  const auto add_button = [&](const QString& text, const QString& tip, auto run) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(tip);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, run);
  };
  add_button(tr("Copy"), tr("Copy what is shown"), [this] { QApplication::clipboard()->setText(text()); });
  add_button(tr("Save…"), tr("Write what is shown into a text file"), [this] { Q_EMIT save_requested(); });
  add_button(tr("Clear"), tr("Forget every message"), [this] { clear(); });
  auto* column = new QVBoxLayout(this);
  column->addLayout(row);
  column->addWidget(list_, 1);
  connect(level_, &QComboBox::activated, this, &Log_panel::fill);
  connect(list_, &QTreeWidget::itemActivated, this,
          [this](QTreeWidgetItem* item) { jump(item->data(0, Qt::UserRole).toInt()); });
}

void Log_panel::add(const Entry& entry) {
  entries_.push_back(entry);
  if (entries_.size() > most_entries) {
    entries_.erase(entries_.begin(), entries_.begin() + most_entries / 2);
    fill();
  } else if (is_shown(entry)) {
    show_entry(entries_.size() - 1);
  }
}

QString Log_panel::text() const {
  QString text;
  for (const Entry& entry : entries_)
    if (is_shown(entry)) text += line_of(entry) + QLatin1Char('\n');
  return text;
}

bool Log_panel::is_shown(const Entry& entry) const {
  return static_cast<int>(entry.kind) >= level_->currentData().toInt();
}

void Log_panel::show_entry(std::size_t number) {
  const Entry& entry = entries_[number];
  auto* item = new QTreeWidgetItem(
      list_, {entry.time.toString(QStringLiteral("HH:mm:ss")), level_text(entry.kind), entry.source, entry.text});
  item->setData(0, Qt::UserRole, static_cast<int>(number));
  item->setToolTip(3, entry.text);
  if (leads_somewhere(entry)) item->setForeground(2, palette().color(QPalette::Link));
  if (entry.kind == Message_bar::Kind::error) item->setForeground(1, failure_color(palette()));
  if (entry.kind == Message_bar::Kind::warning) item->setForeground(1, warning_color(palette()));
  list_->scrollToItem(item);
}

void Log_panel::fill() {
  list_->clear();
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (is_shown(entries_[i])) show_entry(i);
}

void Log_panel::clear() {
  entries_.clear();
  fill();
}

void Log_panel::jump(int entry) {
  // What is shown may say more.
  const Entry chosen = entries_.at(static_cast<std::size_t>(entry));
  if (!chosen.places.empty()) Q_EMIT places_chosen(chosen.places);
  if (!chosen.layer.isEmpty()) {
    Q_EMIT layer_chosen(chosen.layer);
  } else if (const QString path = path_in(chosen.text); !path.isEmpty()) {
    Q_EMIT file_chosen(path);
  }
}

}  // namespace mesecina
