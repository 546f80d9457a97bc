// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shortcut_editor.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "shell/fuzzy.h"

namespace mesecina {

namespace {

enum Column { name_column, keys_column, usual_column };
constexpr int id_role = Qt::UserRole;

QString text_of(const QList<QKeySequence>& keys) {
  return QKeySequence::listToString(keys, QKeySequence::NativeText).replace(QStringLiteral("; "), QStringLiteral(", "));
}

QPushButton* make_button(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setToolTip(tip);
  // Enter ends the recording of keys and must do nothing else.
  button->setAutoDefault(false);
  return button;
}

}  // namespace

Shortcut_editor::Shortcut_editor(Actions& actions, QWidget* parent) : QDialog(parent), actions_(actions) {
  setObjectName(QStringLiteral("shortcut-editor"));
  setWindowTitle(tr("Keyboard shortcuts"));
  setAttribute(Qt::WA_DeleteOnClose);
  setModal(false);
  auto* column = new QVBoxLayout(this);
  build_search();
  build_list();
  column->addWidget(list_, 1);
  build_chosen();
  connect(&actions_, &Actions::keys_changed, this, &Shortcut_editor::show_keys);
  const int em = fontMetrics().height();
  constexpr int wide = 40;
  constexpr int high = 32;
  resize(wide * em, high * em);
  if (parent) resize(size().boundedTo(parent->size()));
  fill();
  show_chosen();
}

void Shortcut_editor::build_search() {
  search_ = new QLineEdit(this);
  search_->setPlaceholderText(tr("Search by name"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search by name"));
  search_->setToolTip(tr("Some letters of what an action is called or does"));
  search_keys_ = new QKeySequenceEdit(this);
  search_keys_->setAccessibleName(tr("Search by key"));
  search_keys_->setToolTip(tr("Press a key to see what it does"));
  search_keys_->findChild<QLineEdit*>()->setPlaceholderText(tr("Search by key: press it"));
  search_keys_->setClearButtonEnabled(true);
  auto* row = new QHBoxLayout;
  row->addWidget(search_, 1);
  row->addWidget(search_keys_, 1);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
  const auto look = [this] { filter(search_->text(), search_keys_->keySequence()); };
  connect(search_, &QLineEdit::textChanged, this, look);
  connect(search_keys_, &QKeySequenceEdit::keySequenceChanged, this, look);
}

void Shortcut_editor::build_list() {
  list_ = new QTreeWidget(this);
  list_->setColumnCount(3);
  list_->setHeaderLabels({tr("Action"), tr("Keys"), tr("Usual keys")});
  list_->setAccessibleName(tr("Actions and their keys"));
  list_->setToolTip(tr("Choose an action, then record its keys below"));
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setAlternatingRowColors(true);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(name_column, QHeaderView::Stretch);
  for (const Column column : {keys_column, usual_column})
    list_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  connect(list_, &QTreeWidget::currentItemChanged, this, &Shortcut_editor::show_chosen);
  connect(list_, &QTreeWidget::itemActivated, this, [this] { keys_->setFocus(); });
}

void Shortcut_editor::build_chosen() {
  chosen_name_ = new QLabel(this);
  chosen_name_->setTextFormat(Qt::PlainText);
  keys_ = new QKeySequenceEdit(this);
  keys_->setAccessibleName(tr("New keys"));
  keys_->setToolTip(tr("Press the keys that the chosen action should have"));
  keys_->findChild<QLineEdit*>()->setPlaceholderText(tr("Press new keys"));
  clear_ = make_button(tr("No &keys"), tr("Take the keys of the chosen action away"), this);
  reset_ = make_button(tr("&Usual keys"), tr("Give the chosen action its usual keys"), this);
  reset_all_ = make_button(tr("All &usual keys"), tr("Give every action its usual keys"), this);
  auto* row = new QHBoxLayout;
  row->addWidget(chosen_name_, 1);
  row->addWidget(keys_, 1);
  row->addWidget(clear_);
  row->addWidget(reset_);
  conflict_ = new QWidget(this);
  conflict_text_ = new QLabel(conflict_);
  conflict_text_->setWordWrap(true);
  conflict_text_->setTextFormat(Qt::PlainText);
  QPushButton* take = make_button(tr("&Take them over"), tr("The other action loses these keys"), conflict_);
  QPushButton* keep = make_button(tr("&Leave them there"), tr("Nothing changes"), conflict_);
  auto* conflict_row = new QHBoxLayout(conflict_);
  conflict_row->setContentsMargins(0, 0, 0, 0);
  conflict_row->addWidget(conflict_text_, 1);
  conflict_row->addWidget(take);
  conflict_row->addWidget(keep);
  conflict_->hide();
  QPushButton* close_button = make_button(tr("&Close"), tr("What was changed is kept"), this);
  auto* last_row = new QHBoxLayout;
  last_row->addWidget(reset_all_);
  last_row->addStretch(1);
  last_row->addWidget(close_button);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addLayout(row);
  column->addWidget(conflict_);
  column->addLayout(last_row);
  connect(keys_, &QKeySequenceEdit::editingFinished, this, [this] {
    if (!keys_->keySequence().isEmpty()) assign(keys_->keySequence());
  });
  connect(clear_, &QPushButton::clicked, this, [this] { set_keys(chosen(), {}); });
  connect(reset_, &QPushButton::clicked, this, [this] {
    const Actions::Entry* entry = actions_.find(chosen());
    if (!entry) return;
    for (const QKeySequence& keys : entry->usual_keys) {
      if (!actions_.holder_of(keys, chosen())) continue;
      assign(keys);
      return;
    }
    actions_.reset_keys(chosen());
    show_chosen();
  });
  connect(reset_all_, &QPushButton::clicked, this, [this] {
    actions_.reset_all_keys();
    show_chosen();
  });
  connect(take, &QPushButton::clicked, this, &Shortcut_editor::take_over);
  connect(keep, &QPushButton::clicked, this, &Shortcut_editor::dismiss_question);
  connect(close_button, &QPushButton::clicked, this, &QWidget::close);
}

void Shortcut_editor::fill() {
  for (const Actions::Entry& entry : actions_.entries()) {
    auto* row = new QTreeWidgetItem(list_);
    row->setText(name_column, QStringLiteral("%1: %2").arg(entry.group, entry.name));
    row->setToolTip(name_column, entry.action->statusTip());
    row->setData(name_column, id_role, entry.action->objectName());
    row->setText(usual_column, text_of(entry.usual_keys));
    rows_.push_back(row);
    show_keys(entry.action->objectName());
  }
  list_->setCurrentItem(rows_.empty() ? nullptr : rows_.front());
}

void Shortcut_editor::show_keys(const QString& id) {
  const auto it = std::ranges::find(
      rows_, id, [](const QTreeWidgetItem* row) { return row->data(name_column, id_role).toString(); });
  if (it == rows_.end()) return;
  (*it)->setText(keys_column, text_of(actions_[id]->shortcuts()));
  QFont font = list_->font();
  font.setBold(actions_.has_own_keys(id));
  (*it)->setFont(keys_column, font);
}

QString Shortcut_editor::chosen() const {
  const QTreeWidgetItem* row = list_->currentItem();
  return row ? row->data(name_column, id_role).toString() : QString();
}

void Shortcut_editor::choose(const QString& id) {
  for (QTreeWidgetItem* row : rows_)
    if (row->data(name_column, id_role).toString() == id) list_->setCurrentItem(row);
}

void Shortcut_editor::show_chosen() {
  dismiss_question();
  const Actions::Entry* entry = actions_.find(chosen());
  chosen_name_->setText(entry ? entry->name : tr("No action is chosen"));
  keys_->clear();
  for (QWidget* part : {static_cast<QWidget*>(keys_), static_cast<QWidget*>(clear_), static_cast<QWidget*>(reset_)})
    part->setEnabled(entry != nullptr);
}

void Shortcut_editor::filter(const QString& words, const QKeySequence& keys) {
  const auto has_keys = [&](const QAction* action) {
    return std::ranges::any_of(action->shortcuts(),
                               [&](const QKeySequence& own) { return keys.matches(own) != QKeySequence::NoMatch; });
  };
  QTreeWidgetItem* first = nullptr;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Actions::Entry& entry = actions_.entries()[i];
    const bool is_named = fuzzy_score(words, entry.name, entry.action->objectName(),
                                      entry.group + QLatin1Char(' ') + entry.action->statusTip()) > 0;
    const bool is_shown = is_named && (keys.isEmpty() || has_keys(entry.action));
    rows_[i]->setHidden(!is_shown);
    if (is_shown && !first) first = rows_[i];
  }
  if (!list_->currentItem() || list_->currentItem()->isHidden()) list_->setCurrentItem(first);
}

QStringList Shortcut_editor::listed() const {
  QStringList ids;
  for (const QTreeWidgetItem* row : rows_)
    if (!row->isHidden()) ids << row->data(name_column, id_role).toString();
  return ids;
}

void Shortcut_editor::set_keys(const QString& id, const QKeySequence& keys) {
  if (id.isEmpty()) return;
  actions_.set_keys(id, keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys});
  show_chosen();
}

void Shortcut_editor::assign(const QKeySequence& keys) {
  const QString id = chosen();
  if (id.isEmpty() || keys.isEmpty()) return;
  const Actions::Entry* holder = actions_.holder_of(keys, id);
  if (!holder) {
    set_keys(id, keys);
    return;
  }
  wanted_ = keys;
  conflict_text_->setText(
      tr("%1 belongs to “%2: %3”.").arg(keys.toString(QKeySequence::NativeText), holder->group, holder->name));
  conflict_->show();
}

QString Shortcut_editor::question() const { return conflict_->isHidden() ? QString() : conflict_text_->text(); }

void Shortcut_editor::take_over() {
  if (conflict_->isHidden()) return;
  const QString id = chosen();
  while (const Actions::Entry* holder = actions_.holder_of(wanted_, id)) {
    QList<QKeySequence> left = holder->action->shortcuts();
    left.removeIf([this](const QKeySequence& keys) {
      return keys.matches(wanted_) != QKeySequence::NoMatch || wanted_.matches(keys) != QKeySequence::NoMatch;
    });
    actions_.set_keys(holder->action->objectName(), left);
  }
  set_keys(id, wanted_);
}

void Shortcut_editor::dismiss_question() {
  conflict_->hide();
  keys_->clear();
}

}  // namespace mesecina
