// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/computation.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/help_text.h"
#include "shell/theme.h"

namespace mesecina {

namespace {
/// So that a quick recomputation shows no flicker of states in the panel.
constexpr std::chrono::milliseconds flush_interval(40);
constexpr std::size_t usual_budget = std::size_t{512} << 20;
}  // namespace

Computation::Computation(std::shared_ptr<const Registry> registry, Document& document, QObject* parent)
    : QObject(parent), registry_(std::move(registry)), document_(document), cache_(usual_budget) {
  data_ = present_data();
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
  listener.reported = [this](const Worker::Report& report) {
    const auto sent = generations_.find(report.ticket);
    const bool is_of_present_data = sent != generations_.end() && sent->second == generation_;
    if (is_of_present_data && !report.stages.empty()) Q_EMIT reported(report);
  };
  listener.finished = [this](std::uint64_t ticket, bool is_complete) {
    if (is_complete) Q_EMIT request_completed();
    finish(ticket);
  };
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
    scene.layers.push_back(
        {entry.id, spec->label, primitives(entry.id), registry_->cut(*spec, document_.settings()), entry.style});
  }
  make_visible_on_background(scene);
  return scene;
}

std::shared_ptr<const Primitive_set> Computation::primitives(const std::string& layer) const {
  const auto it = layers_.find(layer);
  return it == layers_.end() ? nullptr : it->second.picture.primitives;
}

Layer_status Computation::status(const std::string& layer) const {
  Layer_status status;
  const auto it = layers_.find(layer);
  if (it == layers_.end()) return status;
  const Layer& known = it->second;
  status.reason = known.picture.reason;
  status.warnings = known.picture.warnings;
  status.places = known.picture.places;
  status.seconds = known.picture.seconds;
  status.count = known.picture.primitives ? known.picture.primitives->element_count() : 0;
  if (known.is_computing) {
    status.state = Layer_status::State::computing;
  } else if (known.generation == 0) {
    status.state = Layer_status::State::not_computed;
  } else if (known.generation != generation_) {
    status.state = Layer_status::State::stale;
  } else {
    status.state = known.picture.reason.isEmpty() ? Layer_status::State::current : Layer_status::State::failed;
  }
  return status;
}

void Computation::describe(const std::string& layer, std::size_t element,
                           std::function<void(Element_description)> answer) {
  const auto it = layers_.find(layer);
  if (it == layers_.end() || it->second.generation != generation_) return;
  const auto deliver = [this, layer, set = it->second.picture.primitives, generation = generation_,
                        answer = std::move(answer)](Element_description description) {
    const auto now = layers_.find(layer);
    if (generation == generation_ && now != layers_.end() && now->second.picture.primitives == set)
      answer(std::move(description));
  };
  if (is_worker_behind_ && !is_busy_) {
    is_worker_behind_ = false;
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

Computation::Data Computation::present_data() const {
  Data data{document_.inputs(), document_.settings()};
  for (const Layer_spec& spec : registry_->layers())
    for (const std::string& id : {spec.cut_setting, spec.cut_switch})
      if (data.settings.find(id)) data.settings = data.settings.without(id);
  return data;
}

void Computation::react(const Document_change& change) {
  Data data = present_data();
  const bool is_other_data = !(data.inputs == data_.inputs) || data.settings != data_.settings;
  if (is_other_data) {
    // The pictures of the start were computed before there was a track.
    if (document_.track())
      for (const auto& [id, layer] : layers_) keep(id);
    data_ = std::move(data);
    ++generation_;
    for (const auto& [id, layer] : layers_) touch(id);
    show_kept_pictures();
  }
  if (change.settings || is_other_data) is_worker_behind_ = true;
  Q_EMIT scene_changed();
  request_visible();
}

void Computation::keep(const std::string& layer) {
  const Layer& known = layers_.at(layer);
  if (known.generation != generation_ || cache_.find(data_.inputs, data_.settings, layer)) return;
  const std::size_t before = cache_.bytes();
  cache_.put(data_.inputs, data_.settings, layer, known.picture);
  if (cache_.bytes() != before) Q_EMIT kept_bytes_changed();
}

void Computation::show_kept_pictures() {
  for (const Layer_spec& spec : registry_->layers()) {
    const Layer_picture* picture = cache_.find(data_.inputs, data_.settings, spec.id);
    if (!picture) continue;
    Layer& layer = layers_[spec.id];
    layer.picture = *picture;
    layer.generation = generation_;
    layer.is_computing = false;
    touch(spec.id);
  }
}

void Computation::set_kept_bytes_budget(std::size_t bytes) {
  cache_.set_budget(bytes);
  Q_EMIT kept_bytes_changed();
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
  std::erase_if(wanted, [&](const std::string& id) {
    const auto it = layers_.find(id);
    return it != layers_.end() && it->second.generation == generation_;
  });
  if (wanted.empty()) {
    if (is_busy_) cancel();
    return;
  }
  const auto sent = generations_.find(last_ticket_);
  const bool is_of_present_data = is_busy_ && sent != generations_.end() && sent->second == generation_;
  const bool is_under_way = is_of_present_data && std::ranges::all_of(wanted, [&](const std::string& id) {
                              return std::ranges::find(requested_, id) != requested_.end();
                            });
  if (!is_under_way) send(std::move(wanted));
}

void Computation::send(std::vector<std::string> layers) {
  ++last_ticket_;
  generations_[last_ticket_] = generation_;
  requested_ = layers;
  is_worker_behind_ = false;
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
  const auto text_of = [this](const std::string& text) {
    return QString::fromStdString(with_labels(text, *registry_));
  };
  layer.picture = {result.outcome.value, text_of(result.outcome.reason), {}, {}, result.seconds};
  for (const Remark& remark : result.remarks) {
    layer.picture.warnings << text_of(remark.text);
    layer.picture.places.push_back(remark.places);
  }
  if (document_.track()) keep(result.layer);
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
