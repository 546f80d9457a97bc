// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_features_3/module.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/graph.h"
#include "geometries/primitives_3.h"
#include "geometries/scale_axis_3/module.h"
#include "geometries/union_3/module.h"

namespace mesecina {

namespace {

/// What to show the features of.
struct Axis {
  std::shared_ptr<const Medial_complex_3> complex;
  std::shared_ptr<const Medial_features_3> features;
  double scale = 1;  ///< by which radii are too large
};

Axis medial_axis(Context& context) { return {context.get(medial_axis_3_key), context.get(medial_features_3_key)}; }

Axis scale_axis(Context& context) {
  const auto pruned = context.get(pruned_axis_3_key);
  return {{pruned, &pruned->complex}, context.get(scale_axis_features_3_key), context.setting(scale_3_setting)};
}

Primitive_set vertices_of(const Axis& axis) {
  Primitive_set set = primitives_in_space();
  set.vertices = axis.complex->centers;
  set.radii = axis.complex->radii;
  for (double& radius : set.radii) radius /= axis.scale;
  set.is_complex = true;
  return set;
}

/// Edges have the numbers that they have among the elements of the whole complex.
Primitive_set curve_primitives(const Axis& axis, const Medial_curves_3& curves, const char* name) {
  Primitive_set set = vertices_of(axis);
  Values number{name, "", {}};
  Values length{"length", "units of the input", {}};
  for (std::size_t i = 0; i < curves.edges.size(); ++i) {
    set.segments.push_back(axis.complex->edges[curves.edges[i]]);
    set.ids.push_back(static_cast<std::int64_t>(axis.complex->centers.size()) + curves.edges[i]);
    number.data.push_back(curves.curves[i]);
    length.data.push_back(curves.lengths[curves.curves[i]]);
  }
  set.values = {std::move(number), std::move(length)};
  return set;
}

Primitive_set seam_layer(const Axis& axis) {
  Primitive_set set = curve_primitives(axis, axis.features->seams, "seam");
  Values faces{"faces", "", {}};
  for (const int e : axis.features->seams.edges) faces.data.push_back(axis.features->faces_of_edges[e]);
  set.values.push_back(std::move(faces));
  return select(set, std::vector<bool>(set.element_count(), true));
}

Primitive_set rim_layer(const Axis& axis) {
  Primitive_set set = curve_primitives(axis, axis.features->rims, "rim");
  const auto& sheets = axis.features->sheets_of_rims;
  set.values.push_back({"sheet", "", std::vector<double>(sheets.begin(), sheets.end())});
  return select(set, std::vector<bool>(set.element_count(), true));
}

Primitive_set junction_layer(const Axis& axis) {
  Primitive_set set = vertices_of(axis);
  const Medial_features_3& features = *axis.features;
  set.points = features.junctions;
  Values radius{"radius", "units of the input", {}};
  for (const int v : features.junctions) {
    radius.data.push_back(set.radii[v]);
    set.ids.push_back(v);
  }
  const auto count = [](const char* name, const std::vector<int>& counts) {
    return Values{name, "", std::vector<double>(counts.begin(), counts.end())};
  };
  set.values = {count("seams", features.seams_of_junctions), count("sheets", features.sheets_of_junctions),
                std::move(radius)};
  return select(set, std::vector<bool>(set.element_count(), true));
}

/// Of the faces of each sheet one number.
template <class Combine>
std::vector<double> values_of_sheets(const Sheets_3& sheets, const std::vector<double>& faces, const Combine& combine) {
  std::vector<double> of_sheets(sheets.count, 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    double& value = of_sheets[sheets.sheet_of_face[f]];
    value = combine(value, faces[f]);
  }
  std::vector<double> result;
  result.reserve(faces.size());
  for (const int sheet : sheets.sheet_of_face) result.push_back(of_sheets[sheet]);
  return result;
}

Primitive_set sheet_layer(Context& context) {
  const auto axis = context.get(medial_axis_3_key);
  const Sheets_3 parts = sheets(*axis);
  const Loose_parts_3 loose = loose_parts(*axis);
  const auto add = [&](Primitive_set& set, const char* name, const char* unit, std::vector<double> faces,
                       double of_loose) {
    add_medial_values(set, name, unit,
                      values_with_bounds(*axis, std::move(faces), std::vector<double>(loose.edges.size(), of_loose),
                                         std::vector<double>(loose.vertices.size(), of_loose)));
  };
  Primitive_set set = medial_primitives(*axis);
  add_medial_values(set, "sheet", "", sheet_values(*axis));
  add(set, "area", "squared units of the input",
      values_of_sheets(parts, areas_of_faces(*axis), [](double sum, double area) { return sum + area; }), 0);
  constexpr double never_removed = 180;
  add(set, "sheet-angle", "degrees",
      values_of_sheets(parts, angle_of_faces(*axis, context.progress()),
                       [](double most, double angle) { return std::max(most, angle); }),
      never_removed);
  return set;
}

void add_feature_layers(Registry& registry, bool is_scale_axis) {
  const auto axis_of = is_scale_axis ? scale_axis : medial_axis;
  const std::string prefix = is_scale_axis ? "scale-axis-" : "";
  const std::string title = is_scale_axis ? "Scale axis: " : "";
  const std::string of_axis = is_scale_axis ? "of the scale axis before it is sampled" : "of the medial axis";
  const char* stage = is_scale_axis ? "Scale axis" : "Union of balls";
  const std::string paper =
      " [P. Giblin, B. Kimia: A formal classification of 3D medial axis points and their local geometry, 2004]";
  Layer_spec seams =
      make_layer((prefix + "seams").c_str(), (title + (is_scale_axis ? "seams" : "Seams")).c_str(), stage,
                 ("Where three or more sheets " + of_axis +
                  " meet: edges with so many faces, as curves that go on through every vertex with two of them. Values "
                  "are the number of the curve, its length, and how many faces meet." +
                  paper)
                     .c_str(),
                 is_scale_axis ? Color{165, 60, 20} : Color{200, 60, 30},
                 [axis_of](Context& context) { return seam_layer(axis_of(context)); });
  seams.style.line_width = 2.5;
  registry.add_layer(std::move(seams));
  Layer_spec rims = make_layer((prefix + "rims").c_str(), (title + (is_scale_axis ? "rims" : "Rims")).c_str(), stage,
                               ("Where sheets " + of_axis +
                                " end: edges with one face, as curves that go on through every vertex with two of "
                                "them. Values are the number of the curve, its length, and the sheet." +
                                paper)
                                   .c_str(),
                               is_scale_axis ? Color{15, 100, 120} : Color{30, 130, 150},
                               [axis_of](Context& context) { return rim_layer(axis_of(context)); });
  rims.style.line_width = 2;
  registry.add_layer(std::move(rims));
  Layer_spec junctions =
      make_layer((prefix + "junctions").c_str(), (title + (is_scale_axis ? "junctions" : "Junctions")).c_str(), stage,
                 ("Vertices " + of_axis +
                  " where seams meet, or where one ends: with one edge of a seam, or three and more. Values are how "
                  "many that are, how many different sheets meet, and the radius of the medial ball." +
                  paper)
                     .c_str(),
                 is_scale_axis ? Color{90, 20, 70} : Color{120, 30, 100},
                 [axis_of](Context& context) { return junction_layer(axis_of(context)); });
  junctions.style.point_size = 5;
  registry.add_layer(std::move(junctions));
}

}  // namespace

void register_medial_features_3(Registry& registry) {
  registry.begin_module({"medial-features-3", "Features of the medial axis",
                         "What the medial axis of the union is made of: sheets, their seams and rims, and junctions."});
  registry.add_structure<Medial_features_3>(medial_features_3_key, [](Context& context) {
    const auto axis = context.get(medial_axis_3_key);
    return medial_features(*axis, sheets(*axis).sheet_of_face);
  });
  Layer_spec by_sheets = make_layer(
      "sheets", "Sheets", "Union of balls",
      "The medial axis by its sheets: faces that hang together across edges with two faces. Values are the number of "
      "the sheet (-1 where several meet and where there is none), its area, and its largest contact angle, 180 for "
      "what has no face. Values of edges and vertices are the largest of the faces around them.",
      {60, 130, 90}, sheet_layer);
  by_sheets.style.value = "sheet";
  by_sheets.style.color_map = "random";
  registry.add_layer(std::move(by_sheets));
  add_feature_layers(registry, false);
}

void register_scale_axis_features_3(Registry& registry) {
  registry.begin_module({"scale-axis-features-3", "Features of the scale axis",
                         "Seams, rims and junctions of the scale axis before it is sampled."});
  registry.add_structure<Medial_features_3>(scale_axis_features_3_key, [](Context& context) {
    const auto pruned = context.get(pruned_axis_3_key);
    return medial_features(pruned->complex, pruned->sheets.sheet_of_face);
  });
  add_feature_layers(registry, true);
}

}  // namespace mesecina
