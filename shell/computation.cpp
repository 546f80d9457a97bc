// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/computation.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "shell/theme.h"

namespace mesecina {

namespace {
/// So that a quick recomputation shows no flicker of states in the panel.
constexpr std::chrono::milliseconds flush_interval(40);
}  // namespace

Computation::Computation(std::shared_ptr<const Registry> registry, Document& document, QObject* parent)
    : QObject(parent), registry_(std::move(registry)), document_(document), known_settings_(document.settings()) {
  flush_timer_.setSingleShot(true);
  connect(&flush_timer_, &QTimer::timeout, this, &Computation::flush);
  Worker::Listener listener;
  listener.started = [this](std::uint64_t, const std::string& layer) {
    layers_[layer].is_computing = is_busy_;
    touch(layer);
  };
  listener.progressed = [this](std::uint64_t, const std::string& stage, double fraction) {
    if (is_busy_) Q_EMIT progressed(stage_text(stage), fraction);
  };
  listener.finished_layer = [this](const Worker::Layer_result& result) { take(result); };
  listener.finished = [this](std::uint64_t ticket, bool) { finish(ticket); };
  // Closures that come after this object is gone are dropped by Qt with it.
  const auto deliver = [this](std::function<void()> closure) {
    QMetaObject::invokeMethod(this, std::move(closure), Qt::QueuedConnection);
  };
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  worker_ = std::make_unique<Worker>(registry_, threads, std::move(listener), deliver);
  connect(&document_, &Document::changed, this, &Computation::react);
  request_visible();
}

Computation::~Computation() { worker_.reset(); }

QString Computation::stage_text(const std::string& stage) const {
  // The graph names layers "layer:ID" and structures by their ids.
  const std::string id = stage.substr(stage.find(':') + 1);
  if (const Layer_spec* spec = registry_->find_layer(id)) return QString::fromStdString(spec->label);
  return QString::fromStdString(id).replace(QLatin1Char('-'), QLatin1Char(' '));
}

Scene Computation::scene(Color background) const {
  Scene scene;
  scene.background = background;
  for (const Layer_entry& entry : document_.layers()) {
    const Layer_spec* spec = registry_->find_layer(entry.id);
    if (!spec) continue;
    Scene_layer layer{entry.id, spec->label, primitives(entry.id), registry_->cut(*spec, document_.settings()),
                      entry.style};
    layer.style.color = visible_on(background, layer.style.color);
    scene.layers.push_back(std::move(layer));
  }
  return scene;
}

std::shared_ptr<const Primitive_set> Computation::primitives(const std::string& layer) const {
  const auto it = layers_.find(layer);
  return it == layers_.end() ? nullptr : it->second.primitives;
}

Layer_status Computation::status(const std::string& layer) const {
  Layer_status status;
  const auto it = layers_.find(layer);
  if (it == layers_.end()) return status;
  const Layer& known = it->second;
  status.reason = known.reason;
  status.warnings = known.warnings;
  status.seconds = known.seconds;
  status.count = known.primitives ? known.primitives->element_count() : 0;
  if (known.is_computing) {
    status.state = Layer_status::State::computing;
  } else if (known.generation == 0) {
    status.state = Layer_status::State::not_computed;
  } else if (known.generation != generation_) {
    status.state = Layer_status::State::stale;
  } else {
    status.state = known.reason.isEmpty() ? Layer_status::State::current : Layer_status::State::failed;
  }
  return status;
}

void Computation::describe(const std::string& layer, std::size_t element,
                           std::function<void(Element_description)> answer) {
  const auto it = layers_.find(layer);
  if (it == layers_.end() || it->second.generation != generation_) return;
  const auto deliver = [this, layer, set = it->second.primitives, generation = generation_,
                        answer = std::move(answer)](Element_description description) {
    const auto now = layers_.find(layer);
    if (generation == generation_ && now != layers_.end() && now->second.primitives == set)
      answer(std::move(description));
  };
  if (settings_are_newer_ && !is_busy_) {
    settings_are_newer_ = false;
    worker_->request({last_ticket_, document_.inputs(), document_.settings(), {}});
  }
  worker_->describe(layer, element, deliver);
}

void Computation::cancel() {
  worker_->cancel();
  for (auto& [id, layer] : layers_) {
    if (layer.is_computing) touch(id);
    layer.is_computing = false;
  }
  set_busy(false);
}

bool Computation::only_cuts_differ(const Settings& before, const Settings& after) const {
  std::set<std::string> different;
  for (const Settings* settings : {&before, &after}) {
    const Settings* other = settings == &before ? &after : &before;
    for (const auto& [id, value] : settings->changed()) {
      const Setting_value* there = other->find(id);
      if (!there || *there != value) different.insert(id);
    }
  }
  return std::ranges::all_of(different, [&](const std::string& id) {
    return std::ranges::any_of(registry_->layers(),
                               [&](const Layer_spec& spec) { return spec.cut_setting == id || spec.cut_switch == id; });
  });
}

void Computation::react(const Document_change& change) {
  const bool is_cut = change.settings && only_cuts_differ(known_settings_, document_.settings());
  known_settings_ = document_.settings();
  if (change.inputs || (change.settings && !is_cut)) {
    ++generation_;
    for (const auto& [id, layer] : layers_) touch(id);
  }
  if (is_cut) settings_are_newer_ = true;
  Q_EMIT scene_changed();
  request_visible();
}

std::vector<std::string> Computation::visible_layers() const {
  std::vector<std::string> visible;
  for (const Layer_spec& spec : registry_->layers()) {
    const Layer_entry* entry = find_entry(document_.layers(), spec.id);
    if (entry && entry->style.visible) visible.push_back(spec.id);
  }
  return visible;
}

void Computation::request_visible() {
  std::vector<std::string> wanted = visible_layers();
  const bool is_all_there = std::ranges::all_of(wanted, [&](const std::string& id) {
    const auto it = layers_.find(id);
    return it != layers_.end() && it->second.generation == generation_;
  });
  if (is_all_there) {
    if (is_busy_) cancel();
    return;
  }
  const auto sent = generations_.find(last_ticket_);
  const bool is_under_way = is_busy_ && sent != generations_.end() && sent->second == generation_;
  if (is_under_way && wanted == requested_) return;
  send(std::move(wanted));
}

void Computation::send(std::vector<std::string> layers) {
  ++last_ticket_;
  generations_[last_ticket_] = generation_;
  requested_ = layers;
  settings_are_newer_ = false;
  worker_->request({last_ticket_, document_.inputs(), document_.settings(), std::move(layers)});
  is_busy_ = true;
  Q_EMIT busy_changed(true);
}

void Computation::take(const Worker::Layer_result& result) {
  const auto sent = generations_.find(result.ticket);
  if (sent == generations_.end()) return;
  Layer& layer = layers_[result.layer];
  layer.is_computing = false;
  if (sent->second < layer.generation) return;
  layer.generation = sent->second;
  layer.primitives = result.outcome.value;
  layer.reason = QString::fromStdString(result.outcome.reason);
  layer.warnings.clear();
  for (const std::string& warning : result.warnings) layer.warnings << QString::fromStdString(warning);
  layer.seconds = result.seconds;
  touch(result.layer);
  Q_EMIT scene_changed();
}

void Computation::finish(std::uint64_t ticket) {
  generations_.erase(generations_.begin(), generations_.upper_bound(ticket - 1));
  if (ticket != last_ticket_) return;
  for (auto& [id, layer] : layers_) {
    if (layer.is_computing) touch(id);
    layer.is_computing = false;
  }
  set_busy(false);
}

void Computation::set_busy(bool is_busy) {
  if (is_busy == is_busy_) return;
  is_busy_ = is_busy;
  Q_EMIT busy_changed(is_busy);
}

void Computation::touch(const std::string& layer) {
  touched_.insert(layer);
  if (!flush_timer_.isActive()) flush_timer_.start(flush_interval);
}

void Computation::flush() {
  for (const std::string& id : std::exchange(touched_, {})) Q_EMIT layer_changed(QString::fromStdString(id));
}

}  // namespace mesecina
