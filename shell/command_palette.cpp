// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/command_palette.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <utility>

#include "layers/panel_paint.h"
#include "shell/preferences.h"

namespace mesecina {

namespace {

constexpr QLatin1String recent_key("palette-recent");
constexpr int most_recent = 10;
constexpr int most_items = 100;
constexpr int most_rows = 11;

enum Role { detail_role = Qt::UserRole, kind_role, keys_role, is_possible_role, switch_role };

/// Title, and at the right what it is and its keys, more quietly.
class Row_delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {0, option.fontMetrics.height() * 3 / 2};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const bool is_selected = option.state & QStyle::State_Selected;
    const QPalette::ColorGroup group = index.data(is_possible_role).toBool() ? QPalette::Active : QPalette::Disabled;
    const QColor ink = option.palette.color(group, is_selected ? QPalette::HighlightedText : QPalette::Text);
    const QColor ground = option.palette.color(is_selected ? QPalette::Highlight : QPalette::Base);
    if (is_selected) painter->fillRect(option.rect, ground);
    const int em = option.fontMetrics.height();
    QRect row = option.rect.adjusted(em / 2, 0, -em / 2, 0);
    const QRect mark(row.left(), row.top(), em, row.height());
    row.setLeft(row.left() + em + em / 4);
    painter->save();
    painter->setFont(option.font);
    painter->setPen(ink);
    const QVariant is_on = index.data(switch_role);
    if (is_on.isValid() && is_on.toBool()) painter->drawText(mark, Qt::AlignCenter, QStringLiteral("✓"));
    constexpr double quiet = 0.35;
    const auto draw_right = [&](const QString& text, const QColor& color) {
      if (text.isEmpty()) return;
      painter->setPen(color);
      painter->drawText(row, Qt::AlignVCenter | Qt::AlignRight, text);
      row.setRight(row.right() - option.fontMetrics.horizontalAdvance(text) - em);
    };
    draw_right(index.data(keys_role).toString(), ink);
    draw_right(index.data(kind_role).toString(), mix(ink, ground, quiet));
    const auto draw_left = [&](const QString& text, const QColor& color) {
      const QString shown = option.fontMetrics.elidedText(text, Qt::ElideRight, row.width());
      painter->setPen(color);
      painter->drawText(row, Qt::AlignVCenter | Qt::AlignLeft, shown);
      row.setLeft(row.left() + option.fontMetrics.horizontalAdvance(shown) + em);
    };
    draw_left(index.data().toString(), ink);
    // Some names say little without their menu.
    if (row.width() > 4 * em) draw_left(index.data(detail_role).toString(), mix(ink, ground, quiet));
    painter->restore();
  }
};

/// As many whole words as the label has room for, with dots after them where some are left out.
QString elided_words(const QString& text, const QLabel& label) {
  const QRect room = label.contentsRect();
  const auto fits = [&](const QString& shown) {
    const QRect endless(0, 0, room.width(), QWIDGETSIZE_MAX);
    return label.fontMetrics().boundingRect(endless, Qt::TextWordWrap, shown).height() <= room.height();
  };
  QString words = text;
  while (!fits(words)) {
    const qsizetype end = words.lastIndexOf(QLatin1Char(' '));
    if (end <= 0) break;
    words = words.left(end) + QStringLiteral("\u2026");
  }
  return words;
}

}  // namespace

Command_palette::Command_palette(QString program, std::vector<std::unique_ptr<Palette_source>> sources, QWidget* window)
    : QFrame(window),
      program_(std::move(program)),
      sources_(std::move(sources)),
      focus_before_(QApplication::focusWidget()),
      line_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      detail_(new QLabel(this)),
      recent_(Preferences(program_).value(recent_key).toStringList()) {
  setObjectName(QStringLiteral("command-palette"));
  setAccessibleName(tr("Commands"));
  setAttribute(Qt::WA_NoMousePropagation);
  setCursor(Qt::ArrowCursor);
  const int em = fontMetrics().height();
  line_->setPlaceholderText(tr("A command, a layer, a setting and its value…"));
  line_->setAccessibleName(tr("What to do"));
  line_->setToolTip(tr("Some letters of a command, a layer or a setting; Enter does it, Esc closes"));
  line_->setClearButtonEnabled(true);
  line_->installEventFilter(this);
  list_->setAccessibleName(tr("Commands found"));
  list_->setToolTip(tr("Enter or a click does what the row says"));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setUniformItemSizes(true);
  list_->setItemDelegate(new Row_delegate(list_));
  detail_->setWordWrap(true);
  detail_->setTextFormat(Qt::PlainText);
  detail_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  detail_->setContentsMargins(em / 2, 0, em / 2, 0);
  constexpr int detail_lines = 3;
  detail_->setFixedHeight(detail_->fontMetrics().lineSpacing() * detail_lines);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(em / 2, em / 2, em / 2, em / 2);
  column->setSpacing(em / 3);
  column->addWidget(line_);
  column->addWidget(list_, 1);
  column->addWidget(detail_);
  connect(line_, &QLineEdit::textChanged, this, [this](const QString& text) {
    query_ = text;
    fill();
  });
  connect(list_, &QListWidget::currentRowChanged, this, &Command_palette::show_detail);
  connect(list_, &QListWidget::itemClicked, this, &Command_palette::take_current);
  window->installEventFilter(this);
  hide();
}

void Command_palette::open() {
  place();
  layout()->activate();
  fill();
  show();
  raise();
  line_->setFocus(Qt::PopupFocusReason);
}

void Command_palette::set_query(const QString& query) { line_->setText(query); }

int Command_palette::current() const { return list_->currentRow(); }

void Command_palette::place() {
  const int em = fontMetrics().height();
  constexpr int usual_width = 44;
  const QWidget* window = parentWidget();
  const int width = std::min(usual_width * em, window->width() - 2 * em);
  const int rows = most_rows * list_->fontMetrics().height() * 3 / 2;
  const int height =
      std::min(rows + line_->sizeHint().height() + detail_->height() + 3 * em, window->height() - 2 * em);
  setGeometry((window->width() - width) / 2, std::min(4 * em, (window->height() - height) / 2), width, height);
}

void Command_palette::fill() {
  items_.clear();
  for (const auto& source : sources_) {
    std::vector<Palette_item> found = source->find(query_.trimmed());
    std::ranges::move(found, std::back_inserter(items_));
  }
  // What was used lately is a little better than its score.
  constexpr int share = 8;
  for (Palette_item& item : items_) {
    const qsizetype age = recent_.indexOf(item.key);
    if (age >= 0) item.score += item.score / share + static_cast<int>(recent_.size() - age);
  }
  std::ranges::stable_sort(items_, std::greater(), &Palette_item::score);
  if (items_.size() > most_items && !query_.trimmed().isEmpty()) items_.resize(most_items);
  list_->clear();
  for (const Palette_item& item : items_) {
    auto* row = new QListWidgetItem(item.title, list_);
    row->setData(detail_role, item.detail);
    row->setData(kind_role, item.kind);
    row->setData(keys_role, item.keys);
    row->setData(is_possible_role, item.is_possible);
    if (item.is_on) row->setData(switch_role, *item.is_on);
    row->setData(Qt::AccessibleDescriptionRole, item.detail);
  }
  list_->setCurrentRow(items_.empty() ? -1 : 0);
  show_detail();
}

void Command_palette::show_detail() {
  const int row = current();
  const bool is_there = row >= 0 && row < static_cast<int>(items_.size());
  const QString text =
      is_there ? items_[static_cast<std::size_t>(row)].detail : tr("Nothing is called so. Try fewer letters.");
  // The whole is in the tip and in the manual.
  detail_->setText(elided_words(text, *detail_));
  detail_->setToolTip(text);
}

void Command_palette::remember(const QString& key) {
  recent_.removeAll(key);
  recent_.prepend(key);
  recent_ = recent_.mid(0, most_recent);
  Preferences(program_).set_value(recent_key, recent_);
}

void Command_palette::take_current() {
  const int row = current();
  if (row < 0 || row >= static_cast<int>(items_.size())) return;
  const Palette_item item = items_[static_cast<std::size_t>(row)];
  if (!item.is_possible) {
    QApplication::beep();
    return;
  }
  if (!item.run) {
    line_->setText(item.completion);
    return;
  }
  remember(item.key);
  // What runs may look at the focus, open something, or end the program.
  dismiss();
  item.run();
}

void Command_palette::dismiss() {
  if (std::exchange(is_closing_, true)) return;
  parentWidget()->removeEventFilter(this);
  hide();
  if (focus_before_) focus_before_->setFocus();
  deleteLater();
}

bool Command_palette::use_key(int key, Qt::KeyboardModifiers modifiers) {
  const int count = list_->count();
  const auto go = [&](int row) { list_->setCurrentRow(std::clamp(row, 0, std::max(0, count - 1))); };
  switch (key) {
    case Qt::Key_Escape:
      dismiss();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      take_current();
      return true;
    case Qt::Key_Up:
      go(count == 0 ? 0 : (current() + count - 1) % count);
      return true;
    case Qt::Key_Down:
      go(count == 0 ? 0 : (current() + 1) % count);
      return true;
    case Qt::Key_PageUp:
      go(current() - most_rows);
      return true;
    case Qt::Key_PageDown:
      go(current() + most_rows);
      return true;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
      go(count == 0 ? 0
                    : (current() + (modifiers & Qt::ShiftModifier || key == Qt::Key_Backtab ? count - 1 : 1)) % count);
      return true;
    default:
      return false;
  }
}

bool Command_palette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget()) {
    if (event->type() == QEvent::Resize) place();
    return false;
  }
  switch (event->type()) {
    case QEvent::ShortcutOverride:
      // Keys of the window do nothing while it is open.
      event->accept();
      return true;
    case QEvent::KeyPress: {
      auto* key = static_cast<QKeyEvent*>(event);
      return use_key(key->key(), key->modifiers());
    }
    case QEvent::FocusOut:
      if (static_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason) dismiss();
      return false;
    default:
      return false;
  }
}

void Command_palette::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint_plate(painter, rect(), palette());
}

}  // namespace mesecina
