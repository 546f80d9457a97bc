// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <QStringList>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "layers/layer_order.h"
#include "layers/layer_panel.h"

namespace mesecina {

/// Stages and below them their layers, topmost first, for a tree view. Holds what it was given; what the user wants
/// changed it says in signals and does not do itself.
class Layer_model : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Role {
    id_role = Qt::UserRole,  ///< QString: of the layer, or name of the stage
    is_stage_role,           ///< bool
    style_role,              ///< Style of a layer
    count_role,              ///< QString: elements of a layer, "visible / all" of a stage; empty where unknown
    state_role,              ///< int: a Layer_status::State; a hidden layer never failed
    reason_role,             ///< QString: why the visible layer failed; empty else
    is_input_missing_role,   ///< bool: it failed only because there is no input of the kind that it is about
    warnings_role,           ///< QStringList; none of a hidden layer
    is_interleaved_role,     ///< bool: of a stage
    search_role,             ///< QString: what the filter looks into
  };

  explicit Layer_model(std::shared_ptr<const Registry> registry, QObject* parent = nullptr);

  void set_layers(const Layer_list& layers);
  void set_status(const std::string& layer, const Layer_status& status);
  const Layer_list& layers() const { return layers_; }
  const std::vector<Shown_stage>& stages() const { return stages_; }
  QModelIndex find(const QString& layer) const;
  /// Label of a layer; its id when unknown.
  QString label(const std::string& layer) const;
  bool is_any_computing() const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  /// Qt::CheckStateRole tells visibility, also that of a stage.
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  /// Layers can be dropped between those of their own stage, or on it.
  bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                       const QModelIndex& parent) const override;
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

 Q_SIGNALS:
  void order_requested(const mesecina::Layer_list& layers);

 private:
  const Layer_entry& entry(const QModelIndex& index) const;
  QVariant stage_data(const Shown_stage& stage, int role) const;
  QVariant layer_data(const Layer_entry& entry, int role) const;
  QString help_of(const Layer_spec& spec) const;
  QString tool_tip(const Layer_spec& spec) const;
  quintptr stage_number(const std::string& stage) const;
  void layout(std::vector<Shown_stage> stages, const Layer_list& layers);

  std::shared_ptr<const Registry> registry_;
  Layer_list layers_;
  std::vector<Shown_stage> stages_;
  std::map<std::string, Layer_status> statuses_;
};

}  // namespace mesecina

Q_DECLARE_METATYPE(mesecina::Style)
