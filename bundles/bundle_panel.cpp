// SPDX-License-Identifier: GPL-3.0-or-later
#include "bundles/bundle_panel.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

#include "layers/panel_paint.h"

namespace mesecina {

namespace {

constexpr int help_role = Qt::UserRole;
constexpr int shown_role = Qt::UserRole + 1;
constexpr int changed_role = Qt::UserRole + 2;
constexpr int key_role = Qt::UserRole + 3;
constexpr int reason_role = Qt::UserRole + 4;
constexpr int long_list = 12;

/// A row: the key, the name, and the beginning of the help in small letters.
class Bundle_delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    const int em = option.fontMetrics.height();
    return {8 * em, em + small(option.font).second.height() + em / 2};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    const QPalette& palette = option.palette;
    const bool is_shown = index.data(shown_role).toBool();
    const bool is_selected = option.state & QStyle::State_Selected;
    const QColor base = palette.color(QPalette::Base);
    const QColor accent = palette.color(QPalette::Highlight);
    constexpr double tint_of_selected = 0.18;
    constexpr double tint_of_hovered = 0.08;
    if (is_selected) {
      painter->fillRect(option.rect, mix(base, accent, tint_of_selected));
    } else if (option.state & QStyle::State_MouseOver) {
      painter->fillRect(option.rect, mix(base, accent, tint_of_hovered));
    }
    const int em = option.fontMetrics.height();
    if (is_shown) painter->fillRect(QRect(option.rect.left(), option.rect.top(), em / 5, option.rect.height()), accent);
    const auto [small_font, small_metrics] = small(option.font);
    const QRect inside = option.rect.adjusted(em / 2, em / 4, -em / 2, -em / 4);
    const QRect text = inside.adjusted(em, 0, 0, 0);
    const QString reason = index.data(reason_role).toString();
    const bool is_dimmed = !reason.isEmpty();
    if (const int key = index.data(key_role).toInt(); key > 0) {
      painter->setFont(small_font);
      painter->setPen(subdued_text(palette));
      painter->drawText(QRect(inside.left(), inside.top(), em, em), Qt::AlignLeft | Qt::AlignVCenter,
                        QString::number(key));
    }
    QFont name_font = option.font;
    name_font.setBold(is_shown);
    painter->setFont(name_font);
    painter->setPen(is_dimmed ? subdued_text(palette) : palette.color(QPalette::Text));
    const QString mark = index.data(changed_role).toBool() ? Bundle_panel::tr("changed") : QString();
    const int room = mark.isEmpty() ? text.width() : text.width() - small_metrics.horizontalAdvance(mark) - em / 2;
    const QString name = QFontMetrics(name_font).elidedText(index.data().toString(), Qt::ElideRight, room);
    painter->drawText(QRect(text.left(), text.top(), room, em), Qt::AlignLeft | Qt::AlignVCenter, name);
    painter->setFont(small_font);
    painter->setPen(subdued_text(palette));
    painter->drawText(QRect(text.left(), text.top(), text.width(), em), Qt::AlignRight | Qt::AlignVCenter, mark);
    painter->drawText(
        QRect(text.left(), text.top() + em, text.width(), small_metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
        small_metrics.elidedText(is_dimmed ? reason : index.data(help_role).toString(), Qt::ElideRight, text.width()));
    painter->restore();
  }

  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const override {
    const int em = option.fontMetrics.height();
    editor->setGeometry(option.rect.adjusted(em, 0, 0, 0));
  }

 private:
  static std::pair<QFont, QFontMetrics> small(QFont font) {
    constexpr double fraction = 0.85;
    font.setPointSizeF(font.pointSizeF() * fraction);
    return {font, QFontMetrics(font)};
  }
};

}  // namespace

Bundle_panel::Bundle_panel(QWidget* parent)
    : QWidget(parent), filter_(new QLineEdit(this)), more_(new QToolButton(this)), list_(new QListWidget(this)) {
  const int em = fontMetrics().height();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(em / 3, em / 3, em / 3, em / 3);
  filter_->setPlaceholderText(tr("Search bundles"));
  filter_->setAccessibleName(tr("Search bundles"));
  filter_->setToolTip(tr("Words of the name or the description of a bundle"));
  filter_->setClearButtonEnabled(true);
  filter_->hide();
  more_->setIcon(painted_icon(paint_more));
  more_->setAutoRaise(true);
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setToolTip(tr("Save, import, export or reset bundles"));
  more_->setAccessibleName(tr("More about bundles"));
  more_->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
  row->addWidget(filter_, 1);
  row->addWidget(more_);
  layout->addLayout(row);
  layout->addWidget(list_, 1);
  list_->setObjectName(QStringLiteral("bundle-list"));
  list_->setAccessibleName(tr("Bundles"));
  list_->setWhatsThis(tr("Presets of layers, looks and settings. A click shows one, and so do the keys 1 to 9."));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setItemDelegate(new Bundle_delegate(list_));
  list_->setDragDropMode(QAbstractItemView::InternalMove);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->setMouseTracking(true);
  list_->installEventFilter(this);
  connect(list_, &QListWidget::itemClicked, this,
          [this](const QListWidgetItem* item) { Q_EMIT chosen(list_->row(item)); });
  connect(list_, &QListWidget::itemChanged, this, &Bundle_panel::tell_rename);
  connect(list_->model(), &QAbstractItemModel::rowsMoved, this,
          [this](const QModelIndex&, int from, int, const QModelIndex&, int before) {
            if (!is_filling_) Q_EMIT moved(from, before > from ? before - 1 : before);
          });
  connect(list_, &QWidget::customContextMenuRequested, this, &Bundle_panel::open_menu);
  connect(filter_, &QLineEdit::textChanged, this, &Bundle_panel::filter);
}

void Bundle_panel::set_bundles(const std::vector<Bundle>& bundles) {
  const int row = selected();
  is_filling_ = true;
  list_->clear();
  for (const Bundle& bundle : bundles) {
    auto* item = new QListWidgetItem(QString::fromStdString(bundle.name), list_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled);
    const QString help = QString::fromStdString(bundle.help);
    item->setData(help_role, help);
    item->setData(key_role, key_of(bundles, static_cast<std::size_t>(list_->count()) - 1));
    explain(item);
  }
  is_filling_ = false;
  filter_->setVisible(list_->count() > long_list);
  if (list_->count() <= long_list) filter_->clear();
  filter();
  select(std::min(row, list_->count() - 1));
}

void Bundle_panel::set_reasons(const QStringList& reasons) {
  is_filling_ = true;
  for (int i = 0; i < list_->count() && i < reasons.size(); ++i) {
    list_->item(i)->setData(reason_role, reasons[i]);
    explain(list_->item(i));
  }
  is_filling_ = false;
}

void Bundle_panel::explain(QListWidgetItem* item) {
  const int key = item->data(key_role).toInt();
  const QString reason = item->data(reason_role).toString();
  const QString help = item->data(help_role).toString();
  const QString missing = reason.isEmpty() ? QString() : tr("Shows nothing now: %1.").arg(reason);
  item->setToolTip(
      QStringLiteral("<b>%1</b>%2<br>%3%4")
          .arg(item->text().toHtmlEscaped(), key > 0 ? tr(" (key %1)").arg(key) : QString(), help.toHtmlEscaped(),
               missing.isEmpty() ? QString() : QStringLiteral("<br><i>%1</i>").arg(missing.toHtmlEscaped())));
  QStringList said;
  if (item->data(changed_role).toBool()) said << tr("Shown, and changed since.");
  if (!missing.isEmpty()) said << missing;
  item->setData(Qt::AccessibleDescriptionRole, (said << help).join(QLatin1Char(' ')));
}

void Bundle_panel::set_shown(int row, bool is_changed) {
  is_filling_ = true;
  for (int i = 0; i < list_->count(); ++i) {
    QListWidgetItem* item = list_->item(i);
    item->setData(shown_role, i == row);
    item->setData(changed_role, i == row && is_changed);
    explain(item);
  }
  is_filling_ = false;
}

void Bundle_panel::set_menu_actions(const QList<QAction*>& list_actions, const QList<QAction*>& bundle_actions) {
  auto* menu = new QMenu(more_);
  menu->addActions(list_actions);
  menu->addSeparator();
  menu->addActions(bundle_actions);
  more_->setMenu(menu);
  bundle_actions_ = bundle_actions;
}

int Bundle_panel::selected() const {
  const QList<QListWidgetItem*> items = list_->selectedItems();
  return items.isEmpty() ? -1 : list_->row(items.front());
}

void Bundle_panel::select(int row) {
  if (row >= 0 && row < list_->count())
    list_->setCurrentRow(row);
  else
    list_->clearSelection();
}

void Bundle_panel::edit_name(int row) {
  if (row < 0 || row >= list_->count()) return;
  list_->item(row)->setHidden(false);
  select(row);
  list_->setFocus(Qt::ShortcutFocusReason);
  list_->editItem(list_->item(row));
}

bool Bundle_panel::eventFilter(QObject* watched, QEvent* event) {
  const bool is_key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  const int key = is_key ? static_cast<QKeyEvent*>(event)->key() : 0;
  const bool applies = key == Qt::Key_Return || key == Qt::Key_Enter;
  if (watched != list_ || (!applies && key != Qt::Key_Delete)) return QWidget::eventFilter(watched, event);
  event->accept();
  const int row = selected();
  if (event->type() == QEvent::ShortcutOverride || row < 0) return true;
  if (applies)
    Q_EMIT chosen(row);
  else
    Q_EMIT remove_requested(row);
  return true;
}

void Bundle_panel::tell_rename(const QListWidgetItem* item) {
  if (!is_filling_) Q_EMIT renamed(list_->row(item), item->text());
}

void Bundle_panel::filter() {
  for (int i = 0; i < list_->count(); ++i) {
    const QListWidgetItem* item = list_->item(i);
    const bool fits = item->text().contains(filter_->text(), Qt::CaseInsensitive) ||
                      item->data(help_role).toString().contains(filter_->text(), Qt::CaseInsensitive);
    list_->item(i)->setHidden(!fits);
  }
}

void Bundle_panel::open_menu(const QPoint& position) {
  if (const QListWidgetItem* item = list_->itemAt(position)) {
    select(list_->row(item));
    QMenu menu(this);
    menu.addActions(bundle_actions_);
    menu.exec(list_->viewport()->mapToGlobal(position));
  }
}

}  // namespace mesecina
