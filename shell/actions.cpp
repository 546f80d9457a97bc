// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/actions.h"

#include <QMenu>
#include <QToolBar>
#include <QWidget>
#include <map>
#include <stdexcept>
#include <utility>

namespace mesecina {

namespace {

QString plain(QString text) {
  text.remove(QLatin1Char('&'));
  if (text.endsWith(QStringLiteral("…"))) text.chop(1);
  return text;
}

}  // namespace

Actions::Actions(QWidget* window) : QObject(window), window_(window) {}

QAction* Actions::add(const QString& group, const Spec& spec, std::function<void()> run) {
  for (const Entry& entry : entries_) {
    if (entry.action->objectName() == spec.id) throw std::logic_error("action id is taken: " + spec.id.toStdString());
  }
  auto* action = new QAction(spec.icon, spec.text, this);
  action->setObjectName(spec.id);
  action->setCheckable(spec.is_checkable);
  action->setShortcuts(spec.shortcuts);
  const QString keys = action->shortcut().toString(QKeySequence::NativeText);
  const QString name = plain(spec.text);
  action->setToolTip(keys.isEmpty() ? tr("%1\n%2").arg(name, spec.tip) : tr("%1 (%2)\n%3").arg(name, keys, spec.tip));
  action->setStatusTip(spec.tip);
  if (spec.scope) {
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    spec.scope->addAction(action);
  } else {
    window_->addAction(action);
  }
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  entries_.push_back({group, action});
  return action;
}

QAction* Actions::operator[](const QString& id) const {
  for (const Entry& entry : entries_) {
    if (entry.action->objectName() == id) return entry.action;
  }
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
    tool_bar->widgetForAction(action)->setAccessibleName(plain(action->text()));
  }
}

QStringList Actions::faults() const {
  QStringList faults;
  std::map<QString, QString> owners;
  for (const auto& [group, action] : entries_) {
    const QString id = action->objectName();
    if (id.isEmpty()) faults << tr("an action has no id");
    if (plain(action->text()).isEmpty()) faults << tr("%1 has no text").arg(id);
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
