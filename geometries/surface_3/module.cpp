// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/module.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/graph.h"
#include "core/outcome.h"
#include "geometries/primitives_3.h"
#include "geometries/samples_3/module.h"
#include "geometries/scale_axis_3/module.h"
#include "geometries/surface_3/skin_surface_3.h"
#include "geometries/union_3/module.h"

namespace mesecina {

namespace {

constexpr Setting<double> tolerance_setting{"surface-tolerance"};
constexpr Setting<double> shrink_setting{"skin-shrink-factor"};

double diagonal_of(const std::vector<Ball_3>& balls) {
  Box box;
  for (const auto& [center, radius] : balls) {
    const Point_3 reach{radius, radius, radius};
    box.add(center - reach);
    box.add(center + reach);
  }
  return box.diagonal();
}

Union_surface_3 compute_surface(Context& context, std::shared_ptr<const Dual_3> dual, const std::string& name) {
  const double diagonal = diagonal_of(dual->regular->balls);
  const double tolerance = context.setting(tolerance_setting) * diagonal;
  if (!(tolerance > 0)) throw Unavailable("all balls are points: their union has no surface");
  Union_surface_3 surface = union_surface(std::move(dual), tolerance, context.progress());
  context.measure(name + "-deviation", surface.deviation / diagonal);
  if (surface.folded_patches > 0)
    context.warn(name + ": the surface may fold over itself, by less than its tolerance, at " +
                 std::to_string(surface.folded_patches) + " patches");
  return surface;
}

Primitive_set surface_layer(const Union_surface_3& surface, const std::vector<Ball_3>& balls) {
  Primitive_set set = primitives_in_space();
  set.vertices = surface.mesh.vertices;
  set.triangles = surface.mesh.triangles;
  set.is_complex = true;
  Values radius{"radius", "units of the input", {}};
  radius.data.reserve(surface.ball_of_triangle.size());
  for (const int ball : surface.ball_of_triangle) radius.data.push_back(balls[ball].radius);
  set.values.push_back(std::move(radius));
  return set;
}

/// Of the balls of the scale axis.
constexpr Key<Dual_3> scale_axis_dual_3_key{"scale-axis-dual-3"};

Dual_3 compute_scale_axis_dual(Context& context) {
  const auto axis = context.get(scale_axis_3_key);
  std::vector<Ball_3> balls;
  balls.reserve(axis->centers.size());
  for (std::size_t b = 0; b < axis->centers.size(); ++b) balls.push_back({axis->centers[b], axis->radii[b]});
  auto regular = std::make_shared<const Regular_3>(regular_triangulation(std::move(balls), context.progress()));
  return dual_complex(std::move(regular), context.progress());
}

}  // namespace

void register_surface_3(Registry& registry) {
  registry.begin_module({"surface-3", "Surfaces of unions", "Triangles for the boundary of unions of balls."});
  {
    Setting_spec setting;
    setting.id = tolerance_setting.id;
    setting.label = "Surface tolerance";
    setting.help =
        "Surfaces of unions of balls are nowhere farther than this from the true boundary, which has all the dents "
        "between balls. The default is below what unions of balls made with the default of delta differ from their "
        "mesh. Larger does not make fewer triangles than the boundary has patches. Of skin surfaces edges are about so "
        "near.";
    setting.unit = "fraction of the diagonal";
    setting.default_value = 0.002;
    setting.minimum = 1e-6;
    setting.maximum = 0.5;
    setting.tags = {"surface", "density"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = shrink_setting.id;
    setting.label = "Skin shrink factor";
    setting.help =
        "How much of the spheres the skin surface keeps: near 1 it is the boundary of the union with narrow blends, "
        "near 0 it is wide and smooth.";
    setting.unit = "factor";
    setting.default_value = 0.5;
    setting.minimum = 0.05;
    setting.maximum = 0.95;
    setting.tags = {"surface"};
    registry.add_setting(std::move(setting));
  }
  registry.add_structure<Union_surface_3>(union_surface_3_key, [](Context& context) {
    return compute_surface(context, context.get(dual_3_key), "union-surface");
  });
  registry.add_structure<Dual_3>(scale_axis_dual_3_key, compute_scale_axis_dual);
  registry.add_structure<Union_surface_3>(scale_axis_surface_3_key, [](Context& context) {
    return compute_surface(context, context.get(scale_axis_dual_3_key), "scale-axis-surface");
  });
  registry.add_layer(make_layer(
      "union-surface", "Surface of the union", "Union of balls",
      "The boundary of the union of the balls as triangles: closed, manifold, oriented outward, and within "
      "{surface-tolerance}. Its vertices lie on the boundary, each patch of a sphere is triangulated on its own. [H. "
      "Edelsbrunner: The union of balls and its dual shape, 1995]",
      {150, 170, 200}, [](Context& context) {
        const auto balls = context.get(dual_3_key)->regular;
        return surface_layer(*context.get(union_surface_3_key), balls->balls);
      }));
  registry.add_layer(
      make_layer("scale-axis-surface", "Scale axis: surface", "Scale axis",
                 "The simplified shape: the boundary of the union of the balls of the scale axis, shrunk back, within "
                 "{surface-tolerance}. [B. Miklos: The Scale Axis Transform, 2010, section 6.1]",
                 {140, 190, 150}, [](Context& context) {
                   const auto balls = context.get(scale_axis_dual_3_key)->regular;
                   return surface_layer(*context.get(scale_axis_surface_3_key), balls->balls);
                 }));
  Layer_spec skin = make_layer(
      "skin-surface", "Skin surface", "Union of balls",
      "A smooth surface around the balls, of patches of spheres and hyperboloids, within {surface-tolerance}. [H. "
      "Edelsbrunner: Deformable smooth surface design, 1999]",
      {200, 150, 150}, [](Context& context) {
        const auto balls = context.get(balls_3_key);
        std::vector<Ball_3> with_radius = *balls;
        std::erase_if(with_radius, [](const Ball_3& ball) { return !(ball.radius > 0); });
        const double tolerance = context.setting(tolerance_setting) * diagonal_of(with_radius);
        if (!(tolerance > 0)) throw Unavailable("all balls are points: they have no skin surface");
        Triangle_mesh_3 mesh =
            skin_surface(with_radius, context.setting(shrink_setting), tolerance, context.progress());
        Primitive_set set = primitives_in_space();
        set.vertices = std::move(mesh.vertices);
        set.triangles = std::move(mesh.triangles);
        set.is_complex = true;
        return set;
      });
  skin.style.smooth = true;
  registry.add_layer(std::move(skin));
}

}  // namespace mesecina
