// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/picture_cache.h"

#include <tuple>

namespace mesecina {

namespace {

template <class T>
std::size_t bytes_in(const std::vector<T>& elements) {
  return elements.capacity() * sizeof(T);
}

}  // namespace

std::size_t bytes_of(const Primitive_set& set) {
  std::size_t bytes = sizeof(set) + bytes_in(set.vertices) + bytes_in(set.radii) + bytes_in(set.points) +
                      bytes_in(set.segments) + bytes_in(set.rays) + bytes_in(set.arcs) + bytes_in(set.triangles) +
                      bytes_in(set.polygon_offsets) + bytes_in(set.polygon_vertices) + bytes_in(set.balls) +
                      bytes_in(set.values) + bytes_in(set.ids);
  for (const Values& values : set.values) bytes += bytes_in(values.data);
  if (set.image) bytes += bytes_in(set.image->rgba);
  return bytes;
}

bool Picture_cache::Key::operator<(const Key& other) const {
  return std::tie(inputs, settings, layer) < std::tie(other.inputs, other.settings, other.layer);
}

Picture_cache::Key Picture_cache::key_of(const Inputs& inputs, const Settings& settings, std::string_view layer) {
  Key key{{}, settings.changed(), std::string(layer)};
  for (std::string& id : inputs.ids()) {
    const void* identity = inputs.identity(id);
    key.inputs.emplace_back(std::move(id), identity);
  }
  return key;
}

void Picture_cache::put(const Inputs& inputs, const Settings& settings, const std::string& layer,
                        Layer_picture picture) {
  Key key = key_of(inputs, settings, layer);
  forget(key);
  const std::size_t bytes = sizeof(Entry) + (picture.primitives ? bytes_of(*picture.primitives) : 0);
  const auto it = entries_.emplace(std::move(key), Entry{std::move(picture), inputs, bytes, {}}).first;
  it->second.use = uses_.insert(uses_.end(), &it->first);
  bytes_ += bytes;
  shrink();
}

const Layer_picture* Picture_cache::find(const Inputs& inputs, const Settings& settings, std::string_view layer) {
  const auto it = entries_.find(key_of(inputs, settings, layer));
  if (it == entries_.end()) return nullptr;
  uses_.splice(uses_.end(), uses_, it->second.use);
  return &it->second.picture;
}

void Picture_cache::set_budget(std::size_t bytes) {
  budget_ = bytes;
  shrink();
}

void Picture_cache::forget(const Key& key) {
  const auto it = entries_.find(key);
  if (it == entries_.end()) return;
  bytes_ -= it->second.bytes;
  uses_.erase(it->second.use);
  entries_.erase(it);
}

void Picture_cache::shrink() {
  while (bytes_ > budget_) forget(*uses_.front());
}

}  // namespace mesecina
