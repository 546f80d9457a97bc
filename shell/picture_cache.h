// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/inputs.h"
#include "core/place.h"
#include "core/primitives.h"
#include "core/settings.h"

namespace mesecina {

/// What a layer showed, or why it could not.
struct Layer_picture {
  std::shared_ptr<const Primitive_set> primitives;  ///< null when there is nothing
  QString reason;
  QStringList warnings;
  std::vector<std::vector<Place>> places;  ///< of each warning
  double seconds = 0;
};

/// Bytes that the set holds in memory, of which it may share the image with others. O(number of values).
std::size_t bytes_of(const Primitive_set& set);

/// Pictures of layers by the data that they show, up to so many bytes. Those that were not looked at for longest go
/// first.
class Picture_cache {
 public:
  explicit Picture_cache(std::size_t budget) : budget_(budget) {}

  /// Nothing is kept that is larger than the budget alone. `settings`: those that structures may read.
  void put(const Inputs& inputs, const Settings& settings, const std::string& layer, Layer_picture picture);
  /// Null when it is not kept. O(log n).
  const Layer_picture* find(const Inputs& inputs, const Settings& settings, std::string_view layer);

  std::size_t bytes() const { return bytes_; }
  std::size_t budget() const { return budget_; }
  void set_budget(std::size_t bytes);

 private:
  struct Key {
    std::vector<std::pair<std::string, const void*>> inputs;
    std::map<std::string, Setting_value, std::less<>> settings;
    std::string layer;
    bool operator<(const Key& other) const;
  };
  struct Entry {
    Layer_picture picture;
    Inputs inputs;  ///< so that their addresses, which stand for them in the key, are not used again
    std::size_t bytes = 0;
    std::list<const Key*>::iterator use;
  };
  static Key key_of(const Inputs& inputs, const Settings& settings, std::string_view layer);
  void forget(const Key& key);
  void shrink();

  std::size_t budget_;
  std::size_t bytes_ = 0;
  std::map<Key, Entry> entries_;
  std::list<const Key*> uses_;  ///< the least recent first
};

}  // namespace mesecina
