// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QAbstractItemModel>
#include <memory>
#include <string>
#include <vector>

#include "layers/layer_delegate.h"
#include "layers/layer_panel.h"
#include "layers/layer_tree.h"

namespace mesecina {

/// "a", "b", "c" of stage "First" and "d", "e" of stage "Second" from bottom to top; a and d are visible. Layer e has a
/// cut of "lambda" by the setting "limit" (default 2, from 0 to 10).
std::shared_ptr<const Registry> make_registry();
/// Points with the values "lambda" (0, 1, ..., 100 over `scale`) and "weight" (constant).
std::shared_ptr<const Primitive_set> make_points(double scale = 1);

/// A panel in a window that does as it is told, like a program.
class Panel_test : public testing::Test {
 protected:
  struct Edit {
    Layer_list layers;
    QString what;
    QString merge;
  };
  struct Setting_edit {
    QString setting;
    double value = 0;
    QString merge;
  };

  Panel_test();
  Layer_tree& tree() const;
  QModelIndex row(const QString& layer) const;
  QModelIndex stage(int number) const;
  QPoint part(const QModelIndex& index, Layer_delegate::Part part) const;
  void click(const QModelIndex& index, Layer_delegate::Part part, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  const Style& style(const std::string& layer) const;
  /// Ids of the visible layers, concatenated from bottom to top.
  std::string visible() const;
  /// Ids of all layers, concatenated from bottom to top.
  std::string order() const;
  /// What the rows show, concatenated from top to bottom, without those that are filtered out.
  std::string shown() const;

  std::shared_ptr<const Registry> registry_ = make_registry();
  Layer_panel panel_{registry_};
  std::vector<Edit> edits_;
  std::vector<Setting_edit> setting_edits_;
};

}  // namespace mesecina
