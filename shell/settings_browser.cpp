// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/settings_browser.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "layers/panel_paint.h"

namespace mesecina {

Settings_browser::Settings_browser(Settings_panel* panel, QWidget* parent)
    : QWidget(parent),
      panel_(panel),
      filter_(new QLineEdit(this)),
      changed_only_(new QToolButton(this)),
      more_(new QToolButton(this)) {
  const int em = fontMetrics().height();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(em / 3, em / 3, em / 3, em / 3);
  row->setSpacing(em / 4);
  filter_->setPlaceholderText(tr("Search settings"));
  filter_->setAccessibleName(tr("Search settings"));
  filter_->setToolTip(tr("Words of the name, id, description or group of a setting"));
  filter_->setClearButtonEnabled(true);
  changed_only_->setCheckable(true);
  changed_only_->setAutoRaise(true);
  changed_only_->setText(QStringLiteral("●"));
  changed_only_->setToolTip(tr("List only settings that were changed"));
  changed_only_->setAccessibleName(tr("Changed settings only"));
  more_->setIcon(painted_icon(paint_more));
  more_->setAutoRaise(true);
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setToolTip(tr("Save, load or reset settings"));
  more_->setAccessibleName(tr("More about settings"));
  more_->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
  more_->hide();
  row->addWidget(filter_, 1);
  row->addWidget(changed_only_);
  row->addWidget(more_);
  layout->addLayout(row);
  panel_->setParent(this);
  layout->addWidget(panel_, 1);
  const auto update = [this] { panel_->set_filter(filter_->text(), changed_only_->isChecked()); };
  connect(filter_, &QLineEdit::textChanged, this, update);
  connect(changed_only_, &QToolButton::toggled, this, update);
}

void Settings_browser::set_menu_actions(const QList<QAction*>& actions) {
  auto* menu = new QMenu(more_);
  menu->addActions(actions);
  more_->setMenu(menu);
  more_->show();
}

void Settings_browser::search(const QString& words) {
  changed_only_->setChecked(false);
  filter_->setText(words);
  filter_->setFocus(Qt::ShortcutFocusReason);
  filter_->selectAll();
}

}  // namespace mesecina
