// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app2d/editor_2.h"
#include "app2d/hover_2.h"
#include "app2d/tools_2.h"
#include "core/style.h"

namespace mesecina {

/// What is drawn above the scene.
struct Overlay_2 {
  std::vector<Point_2> selected;  ///< points and vertices, and centers of disks
  std::vector<Disk_2> selected_disks;
  std::vector<Disk_handle_2> handles;
  Preview_2 preview;
  const Hovered_2* hovered = nullptr;  ///< drawn with its dual; null for none
  Color background;
  double marker_size = 6;  ///< of ordinary points, in logical pixels
};

std::vector<Scene_layer> make_overlay(const Overlay_2& overlay);

}  // namespace mesecina
