// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/inputs.h"
#include "core/settings.h"
#include "layers/layer_list.h"
#include "shell/evolution_track.h"

namespace mesecina {

/// All that a user can change and undo, as one value. A copy costs a few pointers and the looks of some dozen layers.
struct Document_state {
  Inputs inputs;
  Settings settings;
  Layer_list layers;
  Track_pointer track = nullptr;  ///< null: no evolution has made a step
  std::size_t position = 0;       ///< the place of the track that inputs and settings are those of
  std::string bundle = {};        ///< name of the one that was shown or kept last; empty for none
};

/// Which parts differ from what they were.
struct Document_change {
  bool inputs = false;
  bool settings = false;
  bool layers = false;
  bool track = false;  ///< the track, or the place on it
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
  const Track_pointer& track() const { return state_.track; }
  std::size_t position() const { return state_.position; }
  /// Of the track; 0 without one.
  std::size_t step_count() const { return state_.track ? state_.track->step_count() : 0; }

  /// One undoable step, `text` in the user's words ("Move 3 points"). Steps that follow each other with the same
  /// non-empty `merge` key are one; when they lead back to where they began there is none. No change, no step.
  /// Of the track the places before the present one stay, those after it go when inputs change, or settings that its
  /// steps were made by; undo brings them back.
  void edit(Document_state after, const QString& text, const QString& merge = {});
  void edit_inputs(Inputs inputs, const QString& text, const QString& merge = {});
  /// As edit_inputs, and without a track: these inputs have nothing to do with those before.
  void replace_inputs(Inputs inputs, const QString& text);
  void edit_settings(Settings settings, const QString& text, const QString& merge = {});
  void edit_layers(Layer_list layers, const QString& text, const QString& merge = {});

  /// Says that what is shown was kept as the bundle of this name, or that its bundle is called so now. No step of undo.
  void name_bundle(const std::string& name);

  /// One more place after the place `position` of the track, made of `before` by one step of the evolution; places that
  /// were after it go. Steps of an evolution that follow each other are one step of undo ("Smoothing: 12 steps").
  /// `follows`: the new place becomes the present one.
  void add_step(const Evolution_spec& evolution, std::size_t position, const Evolution_state& before,
                const Evolution_state& after, bool follows);
  /// Goes to a place of the track, the last one at most. No step of undo.
  void go_to(std::size_t position);

  QUndoStack& history() { return history_; }

  /// Says that the inputs of these ids are in a file as they are now; so are those that evolutions keep for themselves,
  /// which no file of data holds.
  void mark_saved(const std::vector<std::string>& input_ids);
  /// The same of inputs that there were when saving began; and of a whole scene.
  void mark_saved(const std::vector<std::string>& input_ids, const Inputs& inputs);
  void mark_scene_saved(const Document_state& scene);
  /// What comes now is another step of the history, also where it would be merged.
  void end_step() { history_.setClean(); }
  void mark_all_saved();
  /// Says that a file holds everything there is, looks and settings too, and is to hold it from now on.
  void mark_scene_saved();
  /// True when some input is not as it was saved last, or anything of a scene that a file holds.
  bool is_modified() const;

 Q_SIGNALS:
  void changed(const mesecina::Document_change& change);
  void modified_changed(bool is_modified);

 private:
  class Step;
  void apply(const Document_state& state);
  Document_state with_inputs(Inputs inputs) const;
  Document_state at(const Track_pointer& track, std::size_t position) const;
  void tell_modified();

  Document_state state_;
  Layers_for_inputs layers_for_inputs_;
  Inputs saved_;
  std::optional<Document_state> saved_scene_;  ///< absent where the file holds data only
  bool was_modified_ = false;
  QUndoStack history_;
};

}  // namespace mesecina
