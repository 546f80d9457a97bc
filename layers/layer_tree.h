// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QTimer>
#include <QTreeView>

namespace mesecina {

class Layer_delegate;
class Layer_model;

/// The view of a Layer_model: selection is for looks, clicks on eyes and swatches leave it alone. The stages of the
/// first list of layers are open where a layer is visible.
class Layer_tree : public QTreeView {
  Q_OBJECT
 public:
  explicit Layer_tree(Layer_model* model, QWidget* parent = nullptr);

  /// Shows the layers whose label, id or help contains every word of `text`. What gets hidden leaves the selection.
  void set_filter(const QString& text, bool is_visible_only);
  Layer_delegate& delegate() const { return *delegate_; }
  /// In the order of the rows.
  QModelIndexList selected_layers() const;

 Q_SIGNALS:
  void eye_clicked(const QModelIndex& index, bool is_solo);
  /// The pressed mouse moved on over the eye of another layer, which is to become like the first one.
  void eye_swept(const QModelIndex& index, bool is_visible);
  void swatch_clicked(const QModelIndex& index);
  void toggle_requested();  ///< Space
  void style_requested();   ///< Enter

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  bool press_part(QMouseEvent* event);
  void apply_filter();
  void close_unseen_stages();
  bool passes_filter(const QModelIndex& layer) const;
  void advance_computing_rows();

  Layer_model* model_;
  Layer_delegate* delegate_;
  QTimer timer_;
  QString filter_;
  bool is_visible_only_ = false;
  bool is_applying_filter_ = false;
  bool is_sweeping_ = false;
  bool is_swept_visible_ = false;
  bool has_stages_ = false;
  QSet<QString> collapsed_;  ///< closed stages
};

}  // namespace mesecina
