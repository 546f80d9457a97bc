// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// The elements after those there are; there need not be any. Nothing changes where none are added. O(all).
template <class T>
Inputs with_elements(const Inputs& inputs, Input_key<std::vector<T>> key, const std::vector<T>& added) {
  if (added.empty()) return inputs;
  const auto old = inputs.get(key);
  std::vector<T> all;
  all.reserve((old ? old->size() : 0) + added.size());
  if (old) all = *old;
  all.insert(all.end(), added.begin(), added.end());
  return inputs.with(key, std::move(all));
}

/// Without the elements whose numbers are in `removed`, which is sorted; without the key where none is left. O(all).
template <class T>
Inputs without_elements(const Inputs& inputs, Input_key<std::vector<T>> key, const std::vector<std::size_t>& removed) {
  const auto all = inputs.get(key);
  if (!all || removed.empty()) return inputs;
  std::vector<T> rest;
  rest.reserve(all->size());
  auto next = removed.begin();
  for (std::size_t i = 0; i < all->size(); ++i) {
    if (next != removed.end() && *next == i) {
      ++next;
    } else {
      rest.push_back((*all)[i]);
    }
  }
  return rest.empty() ? inputs.with(key, std::shared_ptr<const std::vector<T>>()) : inputs.with(key, std::move(rest));
}

/// Calls change(element) for each of these elements that is there. O(all).
template <class T, class Change>
Inputs changed_elements(const Inputs& inputs, Input_key<std::vector<T>> key, const std::vector<std::size_t>& changed,
                        Change change) {
  const auto all = inputs.get(key);
  if (!all || changed.empty()) return inputs;
  std::vector<T> copy = *all;
  for (const std::size_t i : changed)
    if (i < copy.size()) change(copy[i]);
  return inputs.with(key, std::move(copy));
}

}  // namespace mesecina
