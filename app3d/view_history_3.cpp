// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/view_history_3.h"

#include "core/camera_path_3.h"

namespace mesecina {

bool is_nearly_equal(const View_3& one, const View_3& other) {
  return one.cutting_plane == other.cutting_plane && is_nearly_equal(one.camera, other.camera);
}

void View_history_3::remember(const View_3& view) {
  constexpr std::size_t most = 100;
  if (!views_.empty() && is_nearly_equal(views_.back(), view)) return;
  views_.push_back(view);
  if (views_.size() > most) views_.erase(views_.begin());
}

std::optional<View_3> View_history_3::take(const View_3& current) {
  while (!views_.empty()) {
    const View_3 view = views_.back();
    views_.pop_back();
    if (!is_nearly_equal(view, current)) return view;
  }
  return std::nullopt;
}

}  // namespace mesecina
