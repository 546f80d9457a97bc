// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGLViewer/vec.h>

#include "core/point.h"

namespace mesecina {

inline qglviewer::Vec to_vec(const Point_3& p) { return {p.x, p.y, p.z}; }
inline Point_3 to_point(const qglviewer::Vec& v) { return {v.x, v.y, v.z}; }

}  // namespace mesecina
