// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "core/formats/format.h"

namespace mesecina {

/// The JSON of a layer: keys in a fixed order, an array without entries is omitted except `vertices`; `radii` are those
/// of the medial balls of the vertices. Doubles are in
/// shortest round-trip form, +infinity is "inf", not-a-number "nan". A million vertices take about half a second.
void write_json_layer(std::ostream& stream, const Layer_document& document);

/// One row per element under a header. Columns: element (its number), kind, id, x0, y0, x1, y1, then x2, y2 if the
/// layer has arcs or triangles, radius, ring if it has polygons, and one column per value; z0, z1, z2 after their y
/// when the layer is in space. Fields that do not apply are empty. A point or ball is at 0; a segment goes from 0 to 1;
/// a ray starts at 0 in the direction 1; an arc goes counterclockwise from 0 to 1 around 2; a triangle has the corners
/// 0, 1, 2; a polygon's vertices are in ring, "x y;x y;...".
void write_csv_layer(std::ostream& stream, const Layer_document& document);

/// Wavefront OBJ: v, p, l and f. A disk is its center after a comment with its radius; an arc is a polyline with at
/// most one degree per segment; a polygon of the plane is a closed line, as OBJ has no even-odd holes, and one of space
/// a face; rays are left out and counted in a comment. A layer in the plane has z = 0. Of a complex in space points and
/// segments that bound other elements are not written again.
void write_obj_layer(std::ostream& stream, const Layer_document& document);

/// Binary little-endian PLY. If every element is a point or ball there is one vertex per element, with the values (and
/// the radius, 0 for points) as properties. Else every vertex of the layer is written once (with its radius as
/// vertex_radii gives it, if there are any), triangles are faces, and segments, arcs (polylines with at most one degree
/// per edge) and polygons (closed) are edges, both with the values of their element; but polygons of space are faces,
/// after the triangles. Where each vertex is one point, the values of points are properties of the vertices; else they,
/// and rays and values of balls of such a layer, are left out and counted in a comment.
/// The name of a value keeps only letters, digits, '-' and '_'.
void write_ply_layer(std::ostream& stream, const Layer_document& document);

/// OFF of text: all vertices, then segments as faces of two vertices (of a complex in space those that are no sides of
/// faces), triangles and polygons. Points and balls are only
/// their vertices; rays and arcs are left out. What is lost is said in comments, which follow the first line.
void write_off_layer(std::ostream& stream, const Layer_document& document);

/// Binary STL: triangles, and polygons as triangles, each with a normal and its own corners, in single precision. The
/// header has the start of the reason, and counts what is left out: all else, and polygons that append_triangles
/// refuses. Throws std::invalid_argument for coordinates beyond single precision.
void write_stl_layer(std::ostream& stream, const Layer_document& document);

/// Medial mesh as Q-MAT, MATFP and the MAT add-on of Blender read it: "n e f", vertices "v x y z radius", edges "e i j"
/// (segments, and the edges of faces, each once, in increasing order), faces "f i j k" (triangles, and polygons as fans
/// of their first vertex). Radii are those of vertex_radii; a layer of balls alone has a vertex per ball. A layer
/// without radii and balls has "0 0 0" and a comment that says why. All comments are at the end, as those programs know
/// none.
void write_ma_layer(std::ostream& stream, const Layer_document& document);

/// The layer's balls, as layer_balls gives them: "WOFF n 0 0", or "MOFF n 0 1" (no faces, not grown), and n lines
/// x y z radius. Comments at the end say what is left out.
void write_woff_layer(std::ostream& stream, const Layer_document& document);
void write_moff_layer(std::ostream& stream, const Layer_document& document);

/// The writers of inputs do nothing else than writing one key; without it they write the same as for an empty value.
/// Numbers must be finite. Rings must be as the readers make them: no vertex equal to the next one around the ring and
/// at least three that differ.
void write_xy_points(std::ostream& stream, const Inputs& inputs);
void write_poff_points(std::ostream& stream, const Inputs& inputs);
void write_wpoff_disks(std::ostream& stream, const Inputs& inputs);
void write_csv_disks(std::ostream& stream, const Inputs& inputs);
void write_woff_balls(std::ostream& stream, const Inputs& inputs);
void write_moff_balls(std::ostream& stream, const Inputs& inputs);
void write_ma_balls(std::ostream& stream, const Inputs& inputs);
void write_csv_balls(std::ostream& stream, const Inputs& inputs);
void write_xyz_cloud(std::ostream& stream, const Inputs& inputs);
/// A mesh without triangles comes back as a cloud.
void write_off_mesh(std::ostream& stream, const Inputs& inputs);
/// As write_off_mesh; without vertices a comment alone, which is not read.
void write_obj_mesh(std::ostream& stream, const Inputs& inputs);
void write_ply_mesh(std::ostream& stream, const Inputs& inputs);
/// As write_stl_layer. Read again, coordinates are rounded to single precision, vertices are in the order of the
/// triangles, those in one place are one, and those of no triangle are gone.
void write_stl_mesh(std::ostream& stream, const Inputs& inputs);

/// Rings become the outer rings and holes of polygons by how they contain one another. Every ring keeps its first
/// vertex and direction; holes are written after their outer ring. Rings that cross each other or themselves have no
/// such nesting: each is then a polygon of its own, and readers of the even-odd rule still get the same shape.
void write_wkt_outline(std::ostream& stream, const Inputs& inputs);
void write_geojson_outline(std::ostream& stream, const Inputs& inputs);

}  // namespace mesecina
