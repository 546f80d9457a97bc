// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/layer_tree.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "layers/layer_delegate.h"
#include "layers/layer_model.h"
#include "layers/panel_paint.h"

namespace mesecina {

namespace {

constexpr int animation_interval = 120;  // ms

bool is_stage(const QModelIndex& index) { return index.data(Layer_model::is_stage_role).toBool(); }

bool is_checked(const QModelIndex& index) { return index.data(Qt::CheckStateRole).toInt() == Qt::Checked; }

}  // namespace

Layer_tree::Layer_tree(Layer_model* model, QWidget* parent)
    : QTreeView(parent), model_(model), delegate_(new Layer_delegate(this)) {
  setModel(model);
  setItemDelegate(delegate_);
  setHeaderHidden(true);
  setRootIsDecorated(false);
  setIndentation(0);
  setItemsExpandable(true);
  setExpandsOnDoubleClick(false);
  setSelectionMode(ExtendedSelection);
  setEditTriggers(NoEditTriggers);
  setDragDropMode(InternalMove);
  setDropIndicatorShown(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(ScrollPerPixel);
  setContextMenuPolicy(Qt::CustomContextMenu);
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Layers"));
  setWhatsThis(tr("Every layer, the topmost first. The eye shows or hides it; drag it to draw it earlier or later."));

  connect(this, &QTreeView::collapsed, this, [this](const QModelIndex& index) {
    if (!is_applying_filter_) collapsed_.insert(index.data().toString());
  });
  connect(this, &QTreeView::expanded, this, [this](const QModelIndex& index) {
    if (!is_applying_filter_) collapsed_.remove(index.data().toString());
  });
  timer_.setInterval(animation_interval);
  connect(&timer_, &QTimer::timeout, this, &Layer_tree::advance_computing_rows);
  connect(model, &QAbstractItemModel::layoutChanged, this, [this] {
    if (!has_stages_) close_unseen_stages();
    apply_filter();
  });
  connect(model, &QAbstractItemModel::dataChanged, this, [this] {
    if (is_visible_only_) apply_filter();
    if (!timer_.isActive() && model_->is_any_computing()) timer_.start();
  });
}

void Layer_tree::set_filter(const QString& text, bool is_visible_only) {
  filter_ = text.simplified();
  is_visible_only_ = is_visible_only;
  apply_filter();
}

bool Layer_tree::passes_filter(const QModelIndex& layer) const {
  if (is_visible_only_ && !is_checked(layer)) return false;
  const QString searched = layer.data(Layer_model::search_role).toString();
  const QStringList words = filter_.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return searched.contains(word, Qt::CaseInsensitive); });
}

void Layer_tree::close_unseen_stages() {
  has_stages_ = model_->rowCount() > 0;
  for (int s = 0; s < model_->rowCount(); ++s) {
    const QModelIndex stage = model_->index(s, 0);
    if (stage.data(Qt::CheckStateRole).toInt() == Qt::Unchecked) collapsed_.insert(stage.data().toString());
  }
}

void Layer_tree::showEvent(QShowEvent* event) {
  QTreeView::showEvent(event);
  // Only now is the height known that it must be scrolled in.
  if (currentIndex().isValid()) scrollTo(currentIndex());
}

void Layer_tree::apply_filter() {
  is_applying_filter_ = true;
  const auto hide = [this](const QModelIndex& index, bool is_hidden) {
    if (isRowHidden(index.row(), index.parent()) == is_hidden) return;
    if (is_hidden) selectionModel()->select(index, QItemSelectionModel::Deselect);
    setRowHidden(index.row(), index.parent(), is_hidden);
  };
  for (int s = 0; s < model_->rowCount(); ++s) {
    const QModelIndex stage = model_->index(s, 0);
    bool is_any_shown = false;
    for (int row = 0; row < model_->rowCount(stage); ++row) {
      const QModelIndex layer = model_->index(row, 0, stage);
      const bool is_shown = passes_filter(layer);
      is_any_shown = is_any_shown || is_shown;
      hide(layer, !is_shown);
    }
    hide(stage, !is_any_shown);
    setExpanded(stage, !filter_.isEmpty() || is_visible_only_ || !collapsed_.contains(stage.data().toString()));
  }
  is_applying_filter_ = false;
  viewport()->update();
}

QModelIndexList Layer_tree::selected_layers() const {
  QModelIndexList result = selectionModel()->selectedIndexes();
  std::sort(result.begin(), result.end(), [](const QModelIndex& a, const QModelIndex& b) {
    return std::pair(a.parent().row(), a.row()) < std::pair(b.parent().row(), b.row());
  });
  return result;
}

bool Layer_tree::press_part(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return false;
  const QPoint position = event->position().toPoint();
  const QModelIndex index = indexAt(position);
  const Layer_delegate::Part part = delegate_->part_at(index, visualRect(index), font(), position);
  if (part == Layer_delegate::Part::eye) {
    const bool is_solo = event->modifiers().testFlag(Qt::AltModifier);
    is_sweeping_ = !is_solo && !is_stage(index) && !is_visible_only_;
    is_swept_visible_ = !is_checked(index);
    Q_EMIT eye_clicked(index, is_solo);
    return true;
  }
  if (index.isValid() && is_stage(index)) {
    selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    setExpanded(index, !isExpanded(index));
    return true;
  }
  if (part == Layer_delegate::Part::swatch && event->modifiers() == Qt::NoModifier) {
    Q_EMIT swatch_clicked(index);
    return true;
  }
  return false;
}

void Layer_tree::mousePressEvent(QMouseEvent* event) {
  if (press_part(event)) {
    event->accept();
  } else {
    QTreeView::mousePressEvent(event);
  }
}

void Layer_tree::mouseMoveEvent(QMouseEvent* event) {
  if (!is_sweeping_) {
    QTreeView::mouseMoveEvent(event);
    return;
  }
  const QModelIndex index = indexAt(event->position().toPoint());
  if (index.isValid() && !is_stage(index) && is_checked(index) != is_swept_visible_) {
    Q_EMIT eye_swept(index, is_swept_visible_);
  }
}

void Layer_tree::mouseReleaseEvent(QMouseEvent* event) {
  if (is_sweeping_) {
    is_sweeping_ = false;
    return;
  }
  QTreeView::mouseReleaseEvent(event);
}

void Layer_tree::mouseDoubleClickEvent(QMouseEvent* event) {
  // The second press of two quick ones on an eye is a click on it, too.
  if (press_part(event)) return;
  QTreeView::mouseDoubleClickEvent(event);
  if (event->button() == Qt::LeftButton && indexAt(event->position().toPoint()).isValid()) Q_EMIT style_requested();
}

void Layer_tree::keyPressEvent(QKeyEvent* event) {
  const QModelIndex current = currentIndex();
  if (event->key() == Qt::Key_Space && event->modifiers() == Qt::NoModifier) {
    if (current.isValid() && is_stage(current)) {
      Q_EMIT eye_clicked(current, false);
    } else {
      Q_EMIT toggle_requested();
    }
  } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    if (current.isValid() && is_stage(current)) {
      setExpanded(current, !isExpanded(current));
    } else {
      Q_EMIT style_requested();
    }
  } else {
    QTreeView::keyPressEvent(event);
  }
}

void Layer_tree::paintEvent(QPaintEvent* event) {
  QTreeView::paintEvent(event);
  for (int s = 0; s < model_->rowCount(); ++s) {
    if (!isRowHidden(s, {})) return;
  }
  const QString text = model_->rowCount() == 0 ? tr("There are no layers")
                       : filter_.isEmpty()     ? tr("No layer is visible")
                                               : tr("No layer matches “%1”").arg(filter_);
  const int margin = fontMetrics().height();
  QPainter painter(viewport());
  painter.setPen(subdued_text(palette()));
  painter.drawText(viewport()->rect().adjusted(margin, margin, -margin, -margin),
                   Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, text);
}

void Layer_tree::advance_computing_rows() {
  if (!model_->is_any_computing()) {
    timer_.stop();
    return;
  }
  delegate_->advance();
  for (int s = 0; s < model_->rowCount(); ++s) {
    const QModelIndex stage = model_->index(s, 0);
    for (int row = 0; row < model_->rowCount(stage); ++row) {
      const QModelIndex layer = model_->index(row, 0, stage);
      if (layer.data(Layer_model::state_role).toInt() == static_cast<int>(Layer_status::State::computing)) {
        update(layer);
      }
    }
  }
}

}  // namespace mesecina
