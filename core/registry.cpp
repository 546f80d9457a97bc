// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/registry.h"

#include <stdexcept>

namespace mesecina {

namespace {

template <class Spec>
void index_new(std::map<std::string, std::size_t, std::less<>>& index, const std::vector<Spec>& specs, const Spec& spec,
               const char* kind) {
  if (!index.emplace(spec.id, specs.size()).second)
    throw std::logic_error(std::string(kind) + " '" + spec.id + "' is registered twice");
}

template <class Spec>
const Spec* find_in(const std::map<std::string, std::size_t, std::less<>>& index, const std::vector<Spec>& specs,
                    std::string_view id) {
  const auto it = index.find(id);
  return it == index.end() ? nullptr : &specs[it->second];
}

double as_number(const Setting_value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  throw std::logic_error("a cut needs a number");
}

}  // namespace

std::string why_unfit(const Evolution_spec& evolution, const Evolution_state& state) {
  return evolution.needs.why_not ? evolution.needs.why_not(state) : std::string();
}

void Registry::begin_module(Module_spec module) { modules_.push_back(std::move(module)); }

void Registry::add(Structure_spec spec) {
  index_new(structure_index_, structures_, spec, "structure");
  structures_.push_back(std::move(spec));
}

void Registry::add_layer(Layer_spec layer) {
  if (modules_.empty()) throw std::logic_error("layer '" + layer.id + "' belongs to no module");
  index_new(layer_index_, layers_, layer, "layer");
  module_index_["layer:" + layer.id] = modules_.size() - 1;
  if (dimension_ == 3) layer.style.filled = true;
  layers_.push_back(std::move(layer));
}

void Registry::add_setting(Setting_spec setting) {
  if (modules_.empty()) throw std::logic_error("setting '" + setting.id + "' belongs to no module");
  check_setting(setting, setting.default_value);
  index_new(setting_index_, settings_, setting, "setting");
  module_index_["setting:" + setting.id] = modules_.size() - 1;
  settings_.push_back(std::move(setting));
}

void Registry::add_evolution(Evolution_spec evolution) {
  if (modules_.empty()) throw std::logic_error("evolution '" + evolution.id + "' belongs to no module");
  index_new(evolution_index_, evolutions_, evolution, "evolution");
  module_index_["evolution:" + evolution.id] = modules_.size() - 1;
  evolutions_.push_back(std::move(evolution));
}

const Layer_spec* Registry::find_layer(std::string_view id) const { return find_in(layer_index_, layers_, id); }
const Setting_spec* Registry::find_setting(std::string_view id) const { return find_in(setting_index_, settings_, id); }
const Evolution_spec* Registry::find_evolution(std::string_view id) const {
  return find_in(evolution_index_, evolutions_, id);
}
const Structure_spec* Registry::find_structure(std::string_view id) const {
  return find_in(structure_index_, structures_, id);
}

const Module_spec* Registry::module_of(std::string_view id) const {
  for (const char* kind : {"layer:", "setting:", "evolution:"})
    if (const auto it = module_index_.find(kind + std::string(id)); it != module_index_.end())
      return &modules_[it->second];
  return nullptr;
}

std::optional<Cut> Registry::cut(const Layer_spec& layer, const Settings& settings) const {
  if (layer.cut_setting.empty()) return std::nullopt;
  const bool is_switched = !layer.cut_switch.empty() && std::get<bool>(value(settings, layer.cut_switch));
  return Cut{is_switched ? layer.cut_value_when_switched : layer.cut_value,
             as_number(value(settings, layer.cut_setting))};
}

const Setting_value& Registry::value(const Settings& settings, std::string_view id) const {
  if (const Setting_value* changed = settings.find(id)) return *changed;
  const Setting_spec* spec = find_setting(id);
  if (!spec) throw std::out_of_range("no setting '" + std::string(id) + "'");
  return spec->default_value;
}

}  // namespace mesecina
