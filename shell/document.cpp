// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/document.h"

#include <QUndoCommand>
#include <algorithm>
#include <utility>

namespace mesecina {

namespace {

template <class T>
bool same_value(const Inputs& first, const Inputs& second, Input_key<T> key) {
  const auto a = first.get(key);
  const auto b = second.get(key);
  return a == b || (a && b && *a == *b);
}

bool same_state(const Document_state& first, const Document_state& second) {
  return first.settings == second.settings && first.layers == second.layers && same_data(first.inputs, second.inputs);
}

constexpr int most_steps = 200;

}  // namespace

bool same_data(const Inputs& first, const Inputs& second) {
  if (first.ids() != second.ids()) return false;
  for (const std::string& id : first.ids()) {
    if (first.identity(id) == second.identity(id)) continue;
    const bool is_same = (id == points_input.id && same_value(first, second, points_input)) ||
                         (id == disks_input.id && same_value(first, second, disks_input)) ||
                         (id == outline_input.id && same_value(first, second, outline_input)) ||
                         (id == balls_input.id && same_value(first, second, balls_input)) ||
                         (id == cloud_input.id && same_value(first, second, cloud_input)) ||
                         (id == mesh_input.id && same_value(first, second, mesh_input));
    if (!is_same) return false;
  }
  return true;
}

class Document::Step : public QUndoCommand {
 public:
  Step(Document& document, Document_state after, const QString& text, QString merge)
      : QUndoCommand(text),
        document_(document),
        before_(document.state_),
        after_(std::move(after)),
        merge_(std::move(merge)) {}

  void undo() override { document_.apply(before_); }
  void redo() override { document_.apply(after_); }
  int id() const override { return merge_.isEmpty() ? -1 : 1; }
  bool mergeWith(const QUndoCommand* command) override {
    const auto* other = static_cast<const Step*>(command);
    if (other->merge_ != merge_) return false;
    after_ = other->after_;
    setText(other->text());
    if (same_state(before_, after_)) {
      setObsolete(true);
      document_.apply(before_);
    }
    return true;
  }

 private:
  Document& document_;
  Document_state before_;
  Document_state after_;
  QString merge_;
};

Document::Document(Document_state start, QObject* parent)
    : QObject(parent), state_(std::move(start)), saved_(state_.inputs) {
  history_.setUndoLimit(most_steps);
}

Document::Document(Document_state start, Layers_for_inputs layers_for_inputs) : Document(std::move(start)) {
  layers_for_inputs_ = std::move(layers_for_inputs);
}

void Document::edit(Document_state after, const QString& text, const QString& merge) {
  const bool is_same =
      after.inputs == state_.inputs && after.settings == state_.settings && after.layers == state_.layers;
  if (is_same) return;
  history_.push(new Step(*this, std::move(after), text, merge));
}

void Document::edit_inputs(Inputs inputs, const QString& text, const QString& merge) {
  Document_state after = state_;
  after.inputs = std::move(inputs);
  if (layers_for_inputs_ && after.inputs.ids() != state_.inputs.ids())
    after.layers = layers_for_inputs_(after.inputs, std::move(after.layers));
  edit(std::move(after), text, merge);
}

void Document::edit_settings(Settings settings, const QString& text, const QString& merge) {
  Document_state after = state_;
  after.settings = std::move(settings);
  edit(std::move(after), text, merge);
}

void Document::edit_layers(Layer_list layers, const QString& text, const QString& merge) {
  Document_state after = state_;
  after.layers = std::move(layers);
  edit(std::move(after), text, merge);
}

void Document::mark_saved(const std::vector<std::string>& input_ids) {
  const auto mark = [&](auto key) {
    if (std::ranges::find(input_ids, key.id) != input_ids.end()) saved_ = saved_.with(key, state_.inputs.get(key));
  };
  mark(points_input);
  mark(disks_input);
  mark(outline_input);
  mark(image_input);
  mark(mesh_input);
  mark(balls_input);
  mark(cloud_input);
  // What comes now is another step, so that undo stops at what was saved.
  history_.setClean();
  tell_modified();
}

void Document::mark_all_saved() {
  saved_ = state_.inputs;
  history_.setClean();
  tell_modified();
}

bool Document::is_modified() const { return !(saved_ == state_.inputs); }

void Document::apply(const Document_state& state) {
  const Document_change change{!(state.inputs == state_.inputs), !(state.settings == state_.settings),
                               !(state.layers == state_.layers)};
  state_ = state;
  if (change.inputs || change.settings || change.layers) Q_EMIT changed(change);
  tell_modified();
}

void Document::tell_modified() {
  if (is_modified() == was_modified_) return;
  was_modified_ = !was_modified_;
  Q_EMIT modified_changed(was_modified_);
}

}  // namespace mesecina
