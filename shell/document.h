// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/inputs.h"
#include "core/settings.h"
#include "layers/layer_list.h"

namespace mesecina {

/// All that a user can change and undo, as one value. A copy costs a few pointers and the looks of some dozen layers.
struct Document_state {
  Inputs inputs;
  Settings settings;
  Layer_list layers;
};

/// Which parts differ from what they were.
struct Document_change {
  bool inputs = false;
  bool settings = false;
  bool layers = false;
};

/// True when both hold equal data; images are compared by identity. O(size) at worst.
bool same_data(const Inputs& first, const Inputs& second);

/// The state of a program with its history. Only this class changes the state.
class Document : public QObject {
  Q_OBJECT
 public:
  /// The layers that belong to other kinds of inputs than there were, in the same step as these.
  using Layers_for_inputs = std::function<Layer_list(const Inputs&, Layer_list)>;

  explicit Document(Document_state start, QObject* parent = nullptr);
  Document(Document_state start, Layers_for_inputs layers_for_inputs);

  const Document_state& state() const { return state_; }
  const Inputs& inputs() const { return state_.inputs; }
  const Settings& settings() const { return state_.settings; }
  const Layer_list& layers() const { return state_.layers; }

  /// One undoable step, `text` in the user's words ("Move 3 points"). Steps that follow each other with the same
  /// non-empty `merge` key are one; when they lead back to where they began there is none. No change, no step.
  void edit(Document_state after, const QString& text, const QString& merge = {});
  void edit_inputs(Inputs inputs, const QString& text, const QString& merge = {});
  void edit_settings(Settings settings, const QString& text, const QString& merge = {});
  void edit_layers(Layer_list layers, const QString& text, const QString& merge = {});

  QUndoStack& history() { return history_; }

  /// Says that the inputs of these ids are in a file as they are now.
  void mark_saved(const std::vector<std::string>& input_ids);
  void mark_all_saved();
  /// True when some input is not as it was saved last.
  bool is_modified() const;

 Q_SIGNALS:
  void changed(const mesecina::Document_change& change);
  void modified_changed(bool is_modified);

 private:
  class Step;
  void apply(const Document_state& state);
  void tell_modified();

  Document_state state_;
  Layers_for_inputs layers_for_inputs_;
  Inputs saved_;
  bool was_modified_ = false;
  QUndoStack history_;
};

}  // namespace mesecina
