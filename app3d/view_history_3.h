// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/view_3.h"

namespace mesecina {

/// Whether pictures of the two cannot be told apart.
bool is_nearly_equal(const View_3& one, const View_3& other);

/// The views one can go back to: the newest hundred, none like the one before.
class View_history_3 {
 public:
  void remember(const View_3& view);
  /// Takes the newest one that is not like `current`; nullopt when there is none.
  std::optional<View_3> take(const View_3& current);

 private:
  std::vector<View_3> views_;
};

}  // namespace mesecina
