// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "core/outcome.h"
#include "geometries/parallel.h"
#include "geometries/scale_axis_3/scale_axis_3.h"

namespace mesecina {

namespace {

constexpr int most_rounds = 24;
constexpr std::size_t most_balls = 20'000'000;

class Sampler {
 public:
  Sampler(const Medial_complex_3& complex, double scale, double min_angle, Progress& progress) : scale_(scale) {
    constexpr double largest_angle = 179;
    cosine_ = std::cos(std::min(min_angle, largest_angle) * std::numbers::pi / 180);
    // A face with n corners has n - 2 triangles.
    const std::size_t count = complex.face_vertices.size() - 2 * complex.face_count();
    const auto copy_balls = [&] {
      result_.centers = complex.centers;
      result_.radii = complex.radii;
      result_.triangles.reserve(count);
      result_.face_of_triangle.reserve(count);
    };
    const auto make_room = [&] {
      open_.resize(count);
      open_faces_.resize(count);
    };
    at_once(progress, make_room, copy_balls);
    parallel_for(complex.face_count(), progress, [&](std::size_t f) {
      const auto corners = complex.face(f);
      std::size_t t = complex.face_offsets[f] - 2 * f;
      for (std::size_t i = 1; i + 1 < corners.size(); ++i, ++t) {
        open_[t] = {corners[0], corners[i], corners[i + 1]};
        open_faces_[t] = static_cast<int>(f);
      }
    });
    Loose_parts_3 loose = loose_parts(complex, progress);
    open_edges_ = std::move(loose.edges);
    result_.points = std::move(loose.vertices);
  }

  Ball_complex_3 run(Progress& progress) {
    for (int round = 0; round < most_rounds && split_once(progress); ++round) {
      progress.check();
      if (result_.centers.size() > most_balls)
        throw Unavailable("the scale axis would get more than " + std::to_string(most_balls) +
                          " balls; choose a smaller {sampling-min-angle}");
    }
    close();
    for (double& radius : result_.radii) radius /= scale_;
    return std::move(result_);
  }

 private:
  bool is_too_long(int a, int b) const {
    const double r = result_.radii[a] / scale_;
    const double q = result_.radii[b] / scale_;
    const double d = distance(result_.centers[a], result_.centers[b]);
    if (d <= std::abs(r - q)) return false;
    return d * d - r * r - q * q > 2 * r * q * cosine_;
  }

  /// The vertex in the middle of an edge that is to be halved; -1 for others. Squared radii of medial balls are
  /// squared distances to a point, so that those of their middle follow.
  int middle_of(int a, int b) {
    if (!is_too_long(a, b)) return -1;
    if (a > b) std::swap(a, b);
    const std::uint64_t key = (static_cast<std::uint64_t>(a) << 32U) | static_cast<std::uint32_t>(b);
    const auto [it, is_new] = middles_.try_emplace(key, -1);
    if (is_new) {
      it->second = static_cast<int>(result_.centers.size());
      const double p = result_.radii[a];
      const double q = result_.radii[b];
      const double square = (p * p + q * q) / 2 - squared_distance(result_.centers[a], result_.centers[b]) / 4;
      result_.centers.push_back(midpoint(result_.centers[a], result_.centers[b]));
      result_.radii.push_back(std::sqrt(std::max(square, 0.0)));
    }
    return it->second;
  }

  /// Halves what is new since the last round; the rest has no edge that is too long.
  bool split_once(Progress& progress) {
    middles_.clear();
    std::vector<std::uint8_t> is_split(open_.size(), 0);
    parallel_for(open_.size(), progress, [&](std::size_t t) {
      const auto& [a, b, c] = open_[t];
      is_split[t] = is_too_long(a, b) || is_too_long(b, c) || is_too_long(c, a) ? 1 : 0;
    });
    const std::size_t before = result_.centers.size();
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> faces;
    for (std::size_t t = 0; t < open_.size(); ++t) {
      if (is_split[t] == 0) {
        result_.triangles.push_back(open_[t]);
        result_.face_of_triangle.push_back(open_faces_[t]);
      } else {
        split_triangle(open_[t], triangles);
        faces.resize(triangles.size(), open_faces_[t]);
      }
    }
    std::vector<std::array<int, 2>> edges;
    for (const auto& [a, b] : open_edges_) {
      const int m = middle_of(a, b);
      if (m < 0) {
        result_.edges.push_back({a, b});
      } else {
        edges.push_back({a, m});
        edges.push_back({m, b});
      }
    }
    open_ = std::move(triangles);
    open_faces_ = std::move(faces);
    open_edges_ = std::move(edges);
    return result_.centers.size() > before;
  }

  /// What would be halved still when rounds are over.
  void close() {
    result_.triangles.insert(result_.triangles.end(), open_.begin(), open_.end());
    result_.face_of_triangle.insert(result_.face_of_triangle.end(), open_faces_.begin(), open_faces_.end());
    result_.edges.insert(result_.edges.end(), open_edges_.begin(), open_edges_.end());
  }

  /// Of a triangle with an edge that is too long.
  void split_triangle(const std::array<int, 3>& corners, std::vector<std::array<int, 3>>& triangles) {
    std::array<int, 3> middles{};  // across from the corners
    int halved = 0;
    for (int i = 0; i < 3; ++i) {
      middles[i] = middle_of(corners[(i + 1) % 3], corners[(i + 2) % 3]);
      halved += middles[i] >= 0 ? 1 : 0;
    }
    if (halved == 3) {
      for (int i = 0; i < 3; ++i) triangles.push_back({corners[i], middles[(i + 2) % 3], middles[(i + 1) % 3]});
      triangles.push_back(middles);
      return;
    }
    // Turned so that corner 0 lies across from the halved edge, or from the only one that is not.
    int turn = 0;
    while ((middles[turn] >= 0) != (halved == 1)) ++turn;
    const int a = corners[turn];
    const int b = corners[(turn + 1) % 3];
    const int c = corners[(turn + 2) % 3];
    if (halved == 1) {
      const int m = middles[turn];
      triangles.push_back({a, b, m});
      triangles.push_back({a, m, c});
    } else {
      const int ca = middles[(turn + 1) % 3];
      const int ab = middles[(turn + 2) % 3];
      triangles.push_back({a, ab, ca});
      triangles.push_back({ab, b, ca});
      triangles.push_back({b, c, ca});
    }
  }

  double scale_;
  double cosine_ = 0;
  std::unordered_map<std::uint64_t, int> middles_;
  std::vector<std::array<int, 3>> open_;
  std::vector<int> open_faces_;
  std::vector<std::array<int, 2>> open_edges_;
  Ball_complex_3 result_;
};

}  // namespace

Ball_complex_3 sampled(const Medial_complex_3& complex, double scale, double min_angle, Progress& progress) {
  progress.begin_stage("sampling of the scale axis");
  return Sampler(complex, scale, min_angle, progress).run(progress);
}

}  // namespace mesecina
