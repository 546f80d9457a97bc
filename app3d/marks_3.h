// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>
#include <memory>
#include <vector>

#include "app3d/edits_3.h"
#include "app3d/sight_3.h"
#include "core/style.h"

class QPainter;
class QRectF;

namespace mesecina {

/// Points and balls of a selection, to be drawn above the scene. O(selection).
std::vector<Scene_layer> selection_marks_3(const Inputs& inputs, const Selection_3& selection);
/// Something that is not there yet.
Scene_layer ghost_layer_3(std::shared_ptr<const Primitive_set> primitives);

/// Outlines of the selection above everything, so that also what is hidden is seen; nothing for more than some hundred
/// elements, which would cover the scene.
void paint_outlines_3(QPainter& painter, const Sight_3& sight, const Inputs& inputs, const Selection_3& selection);
void paint_handle_3(QPainter& painter, const QPointF& pixel);
void paint_rectangle_3(QPainter& painter, const QRectF& rectangle);

/// "radius 12.5"
QString radius_readout_3(double radius);

}  // namespace mesecina
