// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <set>
#include <stdexcept>
#include <variant>

namespace mesecina {

namespace {

constexpr std::string_view layer_prefix = "layer:";

struct Read_node {
  std::string id;
};
struct Read_input {
  std::string id;
};
struct Read_setting {
  std::string id;
};
using Read = std::variant<Read_node, Read_input, Read_setting>;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

struct Graph::Node {
  std::shared_ptr<void> value;
  std::string reason;
  std::vector<Remark> remarks;
  std::map<std::string, double> measures;
  std::map<std::string, std::string> notes;
  std::vector<Read> reads;
  std::uint64_t computed_at = 0;  ///< revision of the graph; 0: never
  std::uint64_t verified_at = 0;
  std::uint64_t computations = 0;
  bool running = false;
  bool checking = false;  ///< whether what it read is still current is being found out
};

namespace {

/// Sets a flag of a node for as long as this lives.
class Mark {
 public:
  explicit Mark(bool& flag) : flag_(flag) { flag_ = true; }
  ~Mark() { flag_ = false; }
  Mark(const Mark&) = delete;
  Mark& operator=(const Mark&) = delete;

 private:
  bool& flag_;
};

}  // namespace

struct Graph::State {
  std::shared_ptr<const Registry> registry;
  Inputs inputs;
  Settings settings;
  std::uint64_t revision = 1;
  std::map<std::string, std::uint64_t, std::less<>> input_changed_at;
  std::map<std::string, std::uint64_t, std::less<>> setting_changed_at;
  std::map<std::string, Node, std::less<>> nodes;
  std::vector<Stage> stages;
  Progress* progress = nullptr;

  Node& node(std::string_view id) {
    const auto it = nodes.find(id);
    return it != nodes.end() ? it->second : nodes[std::string(id)];
  }

  Node& refresh(Graph& graph, std::string_view id);
  void compute(Graph& graph, std::string_view id, Node& node);
  bool is_current(std::string_view id);
  std::uint64_t changed_at(const Read& read);
};

struct Context::Frame {
  Graph::Node* node;       ///< null: reads are not recorded
  double waited = 0;       ///< seconds spent in other nodes
  std::string_view stage;  ///< its name in reports of progress
};

std::shared_ptr<const void> Context::structure(std::string_view id, std::type_index type) {
  const Structure_spec* spec = graph_.registry().find_structure(id);
  if (!spec) throw std::logic_error("no structure '" + std::string(id) + "' is registered");
  if (spec->type != type) throw std::logic_error("structure '" + std::string(id) + "' is of another type");
  if (frame_.node) {
    const bool known = std::ranges::any_of(frame_.node->reads, [&](const Read& read) {
      const auto* other = std::get_if<Read_node>(&read);
      return other && other->id == id;
    });
    if (!known) frame_.node->reads.push_back(Read_node{std::string(id)});
  }
  // What is being checked reads, so far as is known, the very structure that asks here.
  if (graph_.state_->node(id).checking) throw std::logic_error("structure '" + std::string(id) + "' depends on itself");
  const auto start = Clock::now();
  const std::size_t stages_before = graph_.state_->stages.size();
  Graph::Node& node = graph_.state_->refresh(graph_, id);
  frame_.waited += seconds_since(start);
  // What is reported from here on is again of the one that asked.
  if (graph_.state_->stages.size() != stages_before) progress().begin_stage(frame_.stage);
  if (!node.value) throw Unavailable(node.reason);
  return node.value;
}

void Context::record_input(std::string_view id) {
  if (frame_.node) frame_.node->reads.push_back(Read_input{std::string(id)});
}

const Inputs& Context::inputs() const { return graph_.state_->inputs; }

const Setting_value& Context::setting_value(std::string_view id) {
  if (frame_.node) frame_.node->reads.push_back(Read_setting{std::string(id)});
  return graph_.registry().value(graph_.state_->settings, id);
}

Progress& Context::progress() { return *graph_.state_->progress; }

void Context::warn(std::string text, std::vector<Place> places) {
  if (places.size() > most_places) places.resize(most_places);
  if (frame_.node) frame_.node->remarks.push_back({std::move(text), std::move(places)});
}

void Context::measure(std::string name, double value) {
  if (frame_.node) frame_.node->measures[std::move(name)] = value;
}

void Context::note(std::string name, std::string text) {
  if (frame_.node) frame_.node->notes[std::move(name)] = std::move(text);
}

Graph::Graph(std::shared_ptr<const Registry> registry) : state_(std::make_unique<State>()) {
  state_->registry = std::move(registry);
}
Graph::~Graph() = default;

const Inputs& Graph::inputs() const { return state_->inputs; }
const Settings& Graph::settings() const { return state_->settings; }
const Registry& Graph::registry() const { return *state_->registry; }
const std::vector<Graph::Stage>& Graph::stages() const { return state_->stages; }
void Graph::clear_stages() { state_->stages.clear(); }

void Graph::set_inputs(Inputs inputs) {
  std::set<std::string> ids;
  for (std::string& id : inputs.ids()) ids.insert(std::move(id));
  for (std::string& id : state_->inputs.ids()) ids.insert(std::move(id));
  ++state_->revision;
  for (const std::string& id : ids)
    if (inputs.identity(id) != state_->inputs.identity(id)) state_->input_changed_at[id] = state_->revision;
  state_->inputs = std::move(inputs);
}

void Graph::set_settings(Settings settings) {
  ++state_->revision;
  for (const Setting_spec& spec : state_->registry->settings()) {
    if (state_->registry->value(settings, spec.id) != state_->registry->value(state_->settings, spec.id))
      state_->setting_changed_at[spec.id] = state_->revision;
  }
  state_->settings = std::move(settings);
}

std::uint64_t Graph::State::changed_at(const Read& read) {
  const auto look_up = [](const auto& map, const std::string& id) {
    const auto it = map.find(id);
    return it == map.end() ? std::uint64_t{0} : it->second;
  };
  if (const auto* input = std::get_if<Read_input>(&read)) return look_up(input_changed_at, input->id);
  if (const auto* setting = std::get_if<Read_setting>(&read)) return look_up(setting_changed_at, setting->id);
  return node(std::get<Read_node>(read).id).computed_at;
}

bool Graph::State::is_current(std::string_view id) {
  Node& n = node(id);
  if (n.computed_at == 0) return false;
  if (n.verified_at == revision || n.checking) return true;
  const Mark checking(n.checking);
  for (const Read& read : n.reads) {
    if (const auto* other = std::get_if<Read_node>(&read); other && !is_current(other->id)) return false;
    if (changed_at(read) > n.computed_at) return false;
  }
  n.verified_at = revision;
  return true;
}

Graph::Node& Graph::State::refresh(Graph& graph, std::string_view id) {
  Node& n = node(id);
  if (n.running) throw std::logic_error("structure '" + std::string(id) + "' depends on itself");
  // Nodes that read each other are all failures; asked again by one that it rests on, such a node has not changed.
  if (n.computed_at != 0 && (n.verified_at == revision || n.checking)) return n;
  if (n.computed_at != 0) {
    // In the order in which they were read: a later read may only have happened because of what an earlier one said.
    bool stale = false;
    const Mark checking(n.checking);
    const std::vector<Read> reads = n.reads;
    for (const Read& read : reads) {
      if (const auto* other = std::get_if<Read_node>(&read)) refresh(graph, other->id);
      if (changed_at(read) > n.computed_at) {
        stale = true;
        break;
      }
    }
    if (!stale) {
      n.verified_at = revision;
      return n;
    }
  }
  compute(graph, id, n);
  return n;
}

void Graph::State::compute(Graph& graph, std::string_view id, Node& n) {
  progress->check();
  progress->begin_stage(id);
  const auto start = Clock::now();
  std::shared_ptr<void> previous = std::move(n.value);
  n.value = nullptr;
  n.reason.clear();
  n.remarks.clear();
  n.measures.clear();
  n.notes.clear();
  n.reads.clear();
  n.computed_at = 0;
  const Mark running(n.running);

  Context::Frame frame{&n, 0, id};
  Context context(graph, frame);
  bool updated = false;
  try {
    if (id.starts_with(layer_prefix)) {
      previous.reset();
      const Layer_spec* spec = registry->find_layer(id.substr(layer_prefix.size()));
      n.value = std::make_shared<Primitive_set>(spec->build(context));
    } else {
      const Structure_spec* spec = registry->find_structure(id);
      if (previous && spec->update) {
        updated = true;
        n.value = spec->update(context, std::move(previous));
      } else {
        previous.reset();
        n.value = spec->compute(context);
      }
    }
  } catch (const Cancelled&) {
    n.value = nullptr;
    throw;
  } catch (const Unavailable& unavailable) {
    n.value = nullptr;
    n.reason = unavailable.what();
  } catch (const std::bad_alloc&) {
    n.value = nullptr;
    n.reason = out_of_memory_reason;
  } catch (const std::exception& error) {
    n.value = nullptr;
    n.reason = "internal error in '" + std::string(id) + "': " + error.what();
  }
  n.computed_at = n.verified_at = revision;
  ++n.computations;
  stages.push_back({std::string(id), std::max(0.0, seconds_since(start) - frame.waited), updated});
}

std::pair<std::shared_ptr<const void>, std::string> Graph::evaluate(std::string_view id, Progress& progress) {
  state_->progress = &progress;
  const Node& node = state_->refresh(*this, id);
  return {node.value, node.reason};
}

Outcome<Primitive_set> Graph::layer(std::string_view id, Progress& progress) {
  if (!registry().find_layer(id)) throw std::out_of_range("no layer '" + std::string(id) + "'");
  auto [value, reason] = evaluate(std::string(layer_prefix) + std::string(id), progress);
  return {std::static_pointer_cast<const Primitive_set>(std::move(value)), std::move(reason)};
}

Element_description Graph::describe(std::string_view layer_id, std::size_t element, Progress& progress) {
  const Layer_spec* spec = registry().find_layer(layer_id);
  if (!spec) throw std::out_of_range("no layer '" + std::string(layer_id) + "'");
  state_->progress = &progress;
  Element_description description;
  if (!spec->describe) return description;
  Context::Frame frame{nullptr, 0, layer_id};
  Context context(*this, frame);
  try {
    description = spec->describe(context, element);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception&) {
    return {};
  }
  return description;
}

Outcome<Evolution_state> Graph::evolve(std::string_view evolution_id, std::uint64_t step, Progress& progress) {
  const Evolution_spec* spec = registry().find_evolution(evolution_id);
  if (!spec) throw std::out_of_range("no evolution '" + std::string(evolution_id) + "'");
  const Evolution_state before{state_->inputs, state_->settings};
  state_->progress = &progress;
  progress.check();
  progress.begin_stage(evolution_id);
  Context::Frame frame{nullptr, 0, evolution_id};
  Context context(*this, frame);
  try {
    if (std::string reason = why_unfit(*spec, before); !reason.empty()) return {nullptr, std::move(reason)};
    return {std::make_shared<const Evolution_state>(spec->step(context, before, step)), {}};
  } catch (const Cancelled&) {
    throw;
  } catch (const Unavailable& unavailable) {
    return {nullptr, unavailable.what()};
  } catch (const std::bad_alloc&) {
    return {nullptr, std::string(out_of_memory_reason)};
  } catch (const std::exception& error) {
    return {nullptr, "internal error in '" + std::string(evolution_id) + "': " + error.what()};
  }
}

bool Graph::is_current(std::string_view layer_id) {
  return state_->is_current(std::string(layer_prefix) + std::string(layer_id));
}

std::map<std::string, double> Graph::measures() const {
  std::map<std::string, double> result;
  for (const auto& [id, node] : state_->nodes)
    if (node.verified_at == state_->revision) result.insert(node.measures.begin(), node.measures.end());
  return result;
}

std::map<std::string, std::string> Graph::notes() const {
  std::map<std::string, std::string> result;
  for (const auto& [id, node] : state_->nodes)
    if (node.verified_at == state_->revision) result.insert(node.notes.begin(), node.notes.end());
  return result;
}

std::vector<Remark> Graph::remarks(std::string_view layer_id) const {
  std::vector<Remark> result;
  std::set<std::string> seen;
  const auto visit = [&](const auto& self, const std::string& id) -> void {
    if (!seen.insert(id).second) return;
    const auto it = state_->nodes.find(id);
    if (it == state_->nodes.end()) return;
    for (const Read& read : it->second.reads)
      if (const auto* other = std::get_if<Read_node>(&read)) self(self, other->id);
    for (const Remark& remark : it->second.remarks)
      if (std::ranges::find(result, remark.text, &Remark::text) == result.end()) result.push_back(remark);
  };
  visit(visit, std::string(layer_prefix) + std::string(layer_id));
  return result;
}

std::vector<std::string> Graph::warnings(std::string_view layer_id) const {
  std::vector<std::string> texts;
  for (Remark& remark : remarks(layer_id)) texts.push_back(std::move(remark.text));
  return texts;
}

std::uint64_t Graph::computations(std::string_view id) const {
  for (const std::string& name : {std::string(id), std::string(layer_prefix) + std::string(id)})
    if (const auto it = state_->nodes.find(name); it != state_->nodes.end()) return it->second.computations;
  return 0;
}

}  // namespace mesecina
