// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/style.h"
#include "layers/gl_arc_fill_2.h"
#include "layers/gl_geometry_2.h"
#include "layers/gl_look.h"
#include "layers/gl_objects.h"

namespace mesecina {

/// A run of polygons that are filled together.
struct Polygon_run {
  std::size_t first = 0;  ///< instance
  std::size_t count = 0;
  bool is_plain = false;  ///< no point is covered twice: no need for the stencil
};

/// A buffer with one instance per element or piece of one.
struct Gl_batch {
  Instances instances;  ///< `data` is emptied after the upload
  Gl_buffer geometry;
  double typical_radius = 0;                              ///< of circles: the median
  std::map<std::string, Gl_buffer, std::less<>> numbers;  ///< by name of the values; "": a colour for each element
  std::vector<Polygon_run> runs;
  std::optional<Scene_layer> layer_of_runs;  ///< without its primitives

  int count() const { return static_cast<int>(instances.elements.size()); }
};

/// The uploaded area that arcs bound.
struct Gl_arc_fill {
  Point_2 origin;
  Gl_buffer triangles;
  std::size_t triangle_count = 0;
  Gl_buffer segments;
  std::vector<Segment_run> runs;  ///< of the segments
};

/// That area of one Primitive_set, and what it was made for.
struct Arc_fill_buffers {
  double reach = 0;  ///< farthest_reach() of the arcs
  double size = 0;   ///< the longer side of the arcs' box
  std::vector<bool> drawn;
  std::optional<Window_2> window;  ///< outside of which it is cut off; absent: the whole area
  Gl_arc_fill fill;
};

/// The buffers of one Primitive_set, each uploaded when it is first drawn.
///
/// A part is uploaded whole if float coordinates place it within a hundredth of a pixel. If not (a deep zoom, a far
/// vertex, a huge circle), what meets a window of several screens around the view is cut out in double precision and
/// uploaded, and again only when the view leaves that window.
class Gl_primitives {
 public:
  explicit Gl_primitives(const std::shared_ptr<const Primitive_set>& set);

  bool is_of(const std::shared_ptr<const Primitive_set>& set) const { return set_.lock() == set; }
  bool is_expired() const { return set_.expired(); }

  struct Batches {
    Gl_batch* near = nullptr;
    Gl_batch* far = nullptr;  ///< circles laid out as Cut_out::far; null when there are none
    bool is_whole = true;
  };
  /// For the view: `scale` device pixels per unit and `half_diagonal` device pixels from the middle to a corner.
  Batches batches(const Primitive_set& set, Part part, const Point_2& center, double scale, double half_diagonal);
  /// The area that the drawn arcs bound, for a view as above. It is uploaded anew when other arcs are drawn, and like
  /// the parts above when the view needs another window.
  const Gl_arc_fill& arc_fill(const Scene_layer& layer, const Point_2& center, double scale, double half_diagonal);
  Layer_numbers& numbers() { return numbers_; }
  /// Numbers and ranks per instance. `name` must be of values of the set, or "" for a colour of its own each.
  unsigned number_buffer(const Primitive_set& set, Gl_batch& batch, const std::string& name);
  /// For a batch of polygons: drawn ones that follow each other in one colour are one run. Computed again only when
  /// they may have changed.
  const std::vector<Polygon_run>& runs(const Scene_layer& layer, Gl_batch& batch);
  /// 0 when there is no image.
  unsigned image(const Primitive_set& set);

  /// Since it was made.
  std::size_t uploaded_bytes() const { return uploaded_bytes_; }

 private:
  struct Part_buffers {
    double reach = 0;
    std::optional<Gl_batch> whole;
    std::optional<Window_2> window;
    Gl_batch near;
    Gl_batch far;
  };
  void upload(Gl_batch& batch);
  void upload(const Arc_fill& fill);

  std::weak_ptr<const Primitive_set> set_;
  Point_2 origin_;
  std::map<Part, Part_buffers> parts_;
  std::optional<Arc_fill_buffers> arc_fill_;
  Layer_numbers numbers_;
  std::optional<Gl_texture> image_;
  std::size_t uploaded_bytes_ = 0;
};

}  // namespace mesecina
