// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/actions.h"

#include <QMenu>
#include <QToolBar>
#include <QWidget>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "shell/preferences.h"

namespace mesecina {

namespace {

constexpr QLatin1String keys_key("keys");

}  // namespace

QString plain_text(QString menu_text) {
  menu_text.remove(QLatin1Char('&'));
  if (menu_text.endsWith(QStringLiteral("…"))) menu_text.chop(1);
  return menu_text;
}

Actions::Actions(QString program, QWidget* window) : QObject(window), program_(std::move(program)), window_(window) {
  const QVariantMap known = Preferences(program_).value(keys_key).toMap();
  for (auto it = known.begin(); it != known.end(); ++it)
    own_keys_[it.key()] = QKeySequence::listFromString(it.value().toString(), QKeySequence::PortableText);
}

QAction* Actions::add(const QString& group, const Spec& spec, std::function<void()> run) {
  if (find(spec.id)) throw std::logic_error("action id is taken: " + spec.id.toStdString());
  auto* action = new QAction(spec.icon, spec.text, this);
  action->setObjectName(spec.id);
  action->setCheckable(spec.is_checkable);
  action->setStatusTip(spec.tip);
  action->setWhatsThis(spec.tip);
  if (spec.scope) {
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    spec.scope->addAction(action);
  } else {
    window_->addAction(action);
  }
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  entries_.push_back({group, action, plain_text(spec.text), spec.shortcuts});
  apply_keys(entries_.back());
  return action;
}

const Actions::Entry* Actions::find(const QString& id) const {
  const auto it = std::ranges::find(entries_, id, [](const Entry& entry) { return entry.action->objectName(); });
  return it == entries_.end() ? nullptr : &*it;
}

void Actions::apply_keys(const Entry& entry) {
  const auto own = own_keys_.find(entry.action->objectName());
  entry.action->setShortcuts(own == own_keys_.end() ? entry.usual_keys : own->second);
  const QString keys = entry.action->shortcut().toString(QKeySequence::NativeText);
  const QString tip = entry.action->statusTip();
  entry.action->setToolTip(keys.isEmpty() ? tr("%1\n%2").arg(entry.name, tip)
                                          : tr("%1 (%2)\n%3").arg(entry.name, keys, tip));
}

void Actions::store_keys() const {
  QVariantMap known;
  for (const auto& [id, keys] : own_keys_) known[id] = QKeySequence::listToString(keys, QKeySequence::PortableText);
  Preferences(program_).set_value(keys_key, known);
}

void Actions::set_keys(const QString& id, const QList<QKeySequence>& keys) {
  const Entry* entry = find(id);
  if (!entry) throw std::out_of_range("unknown action: " + id.toStdString());
  if (keys == entry->usual_keys) {
    own_keys_.erase(id);
  } else {
    own_keys_[id] = keys;
  }
  apply_keys(*entry);
  store_keys();
  Q_EMIT keys_changed(id);
}

void Actions::reset_keys(const QString& id) {
  if (const Entry* entry = find(id)) set_keys(id, entry->usual_keys);
}

void Actions::reset_all_keys() {
  own_keys_.clear();
  store_keys();
  for (const Entry& entry : entries_) {
    apply_keys(entry);
    Q_EMIT keys_changed(entry.action->objectName());
  }
}

const Actions::Entry* Actions::holder_of(const QKeySequence& keys, const QString& except) const {
  if (keys.isEmpty()) return nullptr;
  const auto clashes = [&](const QKeySequence& other) {
    // Qt takes no keys for the beginning of all.
    if (other.isEmpty()) return false;
    return keys.matches(other) != QKeySequence::NoMatch || other.matches(keys) != QKeySequence::NoMatch;
  };
  const auto it = std::ranges::find_if(entries_, [&](const Entry& entry) {
    return entry.action->objectName() != except && std::ranges::any_of(entry.action->shortcuts(), clashes);
  });
  return it == entries_.end() ? nullptr : &*it;
}

QAction* Actions::operator[](const QString& id) const {
  if (const Entry* entry = find(id)) return entry->action;
  throw std::out_of_range("unknown action: " + id.toStdString());
}

void Actions::add_to(QMenu* menu, const QStringList& ids) const {
  for (const QString& id : ids) {
    if (id == QLatin1String("-")) {
      menu->addSeparator();
    } else {
      menu->addAction((*this)[id]);
    }
  }
}

void Actions::add_to(QToolBar* tool_bar, const QStringList& ids) const {
  for (const QString& id : ids) {
    if (id == QLatin1String("-")) {
      tool_bar->addSeparator();
      continue;
    }
    QAction* action = (*this)[id];
    tool_bar->addAction(action);
    tool_bar->widgetForAction(action)->setAccessibleName(plain_text(action->text()));
  }
}

QStringList Actions::faults() const {
  QStringList faults;
  std::map<QString, QString> owners;
  for (const auto& [group, action, name, usual_keys] : entries_) {
    const QString id = action->objectName();
    if (id.isEmpty()) faults << tr("an action has no id");
    if (name.isEmpty()) faults << tr("%1 has no text").arg(id);
    if (action->statusTip().isEmpty()) faults << tr("%1 has no tip").arg(id);
    if (group.isEmpty()) faults << tr("%1 is in no group").arg(id);
    for (const QKeySequence& keys : action->shortcuts()) {
      if (!action->toolTip().contains(action->shortcut().toString(QKeySequence::NativeText)))
        faults << tr("the tip of %1 does not name its key").arg(id);
      const auto [owner, is_new] = owners.emplace(keys.toString(), id);
      if (!is_new) faults << tr("%1 and %2 both claim %3").arg(owner->second, id, keys.toString());
    }
  }
  return faults;
}

}  // namespace mesecina
