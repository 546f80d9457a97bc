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
  /// A step of an evolution, which makes the place of this number.
  Step(Document& document, Document_state after, QString evolution, std::size_t first_place)
      : Step(document, std::move(after), steps_text(evolution, 1), QStringLiteral("evolution/") + evolution) {
    evolution_ = std::move(evolution);
    first_place_ = first_place;
  }

  void undo() override { document_.apply(before_); }
  void redo() override { document_.apply(after_); }
  int id() const override { return merge_.isEmpty() ? -1 : 1; }
  bool mergeWith(const QUndoCommand* command) override {
    const auto* other = static_cast<const Step*>(command);
    if (other->merge_ != merge_) return false;
    if (!evolution_.isEmpty() && !continues(*other)) return false;
    after_ = other->after_;
    setText(evolution_.isEmpty() ? other->text() : steps_text(evolution_, after_.track->places.size() - first_place_));
    if (evolution_.isEmpty() && same_state(before_, after_)) {
      setObsolete(true);
      document_.apply(before_);
    }
    return true;
  }

 private:
  static QString steps_text(const QString& evolution, std::size_t count) {
    return count == 1 ? Document::tr("%1: 1 step").arg(evolution)
                      : Document::tr("%1: %2 steps").arg(evolution).arg(count);
  }
  bool continues(const Step& other) const {
    return after_.track == other.before_.track && other.first_place_ == after_.track->places.size();
  }

  Document& document_;
  Document_state before_;
  Document_state after_;
  QString merge_;
  QString evolution_;  ///< its label, where this is a step of one
  std::size_t first_place_ = 0;
};

Document::Document(Document_state start, QObject* parent)
    : QObject(parent), state_(std::move(start)), saved_(state_.inputs) {
  history_.setUndoLimit(most_steps);
}

Document::Document(Document_state start, Layers_for_inputs layers_for_inputs) : Document(std::move(start)) {
  layers_for_inputs_ = std::move(layers_for_inputs);
}

void Document::edit(Document_state after, const QString& text, const QString& merge) {
  const bool is_same = after.inputs == state_.inputs && after.settings == state_.settings &&
                       after.layers == state_.layers && after.track == state_.track &&
                       after.position == state_.position;
  if (is_same) {
    name_bundle(after.bundle);
    return;
  }
  const bool is_here = after.track && after.track == state_.track && after.position == state_.position;
  if (is_here && (!(after.inputs == state_.inputs) || concerns(*after.track, state_.settings, after.settings))) {
    after.track = branched(*after.track, after.position, after.inputs, after.settings);
    if (!after.track) after.position = 0;
  }
  history_.push(new Step(*this, std::move(after), text, merge));
}

Document_state Document::with_inputs(Inputs inputs) const {
  Document_state after = state_;
  after.inputs = std::move(inputs);
  if (layers_for_inputs_ && after.inputs.ids() != state_.inputs.ids())
    after.layers = layers_for_inputs_(after.inputs, std::move(after.layers));
  return after;
}

void Document::edit_inputs(Inputs inputs, const QString& text, const QString& merge) {
  edit(with_inputs(std::move(inputs)), text, merge);
}

void Document::replace_inputs(Inputs inputs, const QString& text) {
  Document_state after = with_inputs(std::move(inputs));
  after.track = nullptr;
  after.position = 0;
  edit(std::move(after), text);
}

Document_state Document::at(const Track_pointer& track, std::size_t position) const {
  Document_state after = with_inputs(track->places.at(position).inputs);
  after.settings = settings_at(*track, position, std::move(after.settings));
  after.track = track;
  after.position = position;
  return after;
}

void Document::add_step(const Evolution_spec& evolution, std::size_t position, const Evolution_state& before,
                        const Evolution_state& after, bool follows) {
  const Track_pointer start = state_.track ? state_.track : start_track(before.inputs);
  const Track_pointer longer = with_step(*start, position, evolution, before, after);
  const bool is_cut_off = state_.position > position;
  history_.push(new Step(*this, at(longer, follows || is_cut_off ? position + 1 : state_.position),
                         QString::fromStdString(evolution.label), position + 1));
}

void Document::go_to(std::size_t position) {
  if (!state_.track) return;
  position = std::min(position, state_.track->step_count());
  if (position != state_.position) apply(at(state_.track, position));
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

void Document::name_bundle(const std::string& name) {
  if (name == state_.bundle) return;
  state_.bundle = name;
  Q_EMIT changed({});
}

void Document::mark_saved(const std::vector<std::string>& input_ids) {
  // So that undo stops at what was saved.
  end_step();
  mark_saved(input_ids, state_.inputs);
}

void Document::mark_saved(const std::vector<std::string>& input_ids, const Inputs& inputs) {
  Inputs saved = inputs;
  const auto keep = [&](auto key) {
    if (std::ranges::find(input_ids, key.id) == input_ids.end()) saved = saved.with(key, saved_.get(key));
  };
  keep(points_input);
  keep(disks_input);
  keep(outline_input);
  keep(image_input);
  keep(mesh_input);
  keep(balls_input);
  keep(cloud_input);
  saved_ = std::move(saved);
  tell_modified();
}

void Document::mark_scene_saved() {
  end_step();
  mark_scene_saved(state_);
}

void Document::mark_scene_saved(const Document_state& scene) {
  saved_ = scene.inputs;
  saved_scene_ = scene;
  tell_modified();
}

void Document::mark_all_saved() {
  saved_ = state_.inputs;
  saved_scene_.reset();
  end_step();
  tell_modified();
}

bool Document::is_modified() const {
  const bool is_same_look =
      !saved_scene_ || (saved_scene_->settings == state_.settings && saved_scene_->layers == state_.layers);
  return !(saved_ == state_.inputs) || !is_same_look;
}

void Document::apply(const Document_state& state) {
  const Document_change change{!(state.inputs == state_.inputs), !(state.settings == state_.settings),
                               !(state.layers == state_.layers),
                               state.track != state_.track || state.position != state_.position};
  const bool is_named = state.bundle != state_.bundle;
  state_ = state;
  if (change.inputs || change.settings || change.layers || change.track || is_named) Q_EMIT changed(change);
  tell_modified();
}

void Document::tell_modified() {
  if (is_modified() == was_modified_) return;
  was_modified_ = !was_modified_;
  Q_EMIT modified_changed(was_modified_);
}

}  // namespace mesecina
