// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs.h"

namespace mesecina {

Box bounding_box(const Inputs& inputs) {
  Box box;
  if (const auto points = inputs.get(points_input))
    for (const Point_2& p : *points) box.add(p);
  if (const auto disks = inputs.get(disks_input)) {
    for (const Disk_2& disk : *disks) {
      box.add(Point_2{disk.center.x - disk.radius, disk.center.y - disk.radius});
      box.add(Point_2{disk.center.x + disk.radius, disk.center.y + disk.radius});
    }
  }
  if (const auto outline = inputs.get(outline_input))
    for (const Ring_2& ring : outline->rings)
      for (const Point_2& p : ring) box.add(p);
  if (const auto image = inputs.get(image_input)) {
    box.add(image->lower_left);
    box.add(Point_2{image->lower_left.x + image->width * image->pixel_size,
                    image->lower_left.y + image->height * image->pixel_size});
  }
  if (const auto mesh = inputs.get(mesh_input))
    for (const Point_3& p : mesh->vertices) box.add(p);
  if (const auto cloud = inputs.get(cloud_input))
    for (const Point_3& p : *cloud) box.add(p);
  if (const auto balls = inputs.get(balls_input)) {
    for (const auto& [c, r] : *balls) {
      box.add(Point_3{c.x - r, c.y - r, c.z - r});
      box.add(Point_3{c.x + r, c.y + r, c.z + r});
    }
  }
  return box;
}

}  // namespace mesecina
