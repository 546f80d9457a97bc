// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/mesh_edges_3.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/disjoint_sets.h"

namespace mesecina {

namespace {}  // namespace

bool Mesh_edges_3::is_open() const {
  return std::ranges::any_of(irregular, [](const std::vector<int>& edge) { return edge.size() % 2 == 1; });
}

Mesh_edges_3 find_edges(const Triangle_mesh_3& mesh) {
  const int count = static_cast<int>(3 * mesh.triangles.size());
  const auto lesser_end = [&](int h) { return std::min(half_edge_source(mesh, h), half_edge_target(mesh, h)); };
  std::vector<int> first(mesh.vertices.size() + 1, 0);
  for (int h = 0; h < count; ++h) ++first[lesser_end(h) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::pair<int, int>> entries(count);  // the greater end, the half-edge
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int h = 0; h < count; ++h)
    entries[next[lesser_end(h)]++] = {std::max(half_edge_source(mesh, h), half_edge_target(mesh, h)), h};

  Mesh_edges_3 result;
  result.twin.assign(count, -1);
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    const auto begin = entries.begin() + first[v];
    const auto end = entries.begin() + first[v + 1];
    std::sort(begin, end);
    for (auto edge = begin; edge != end;) {
      auto edge_end = edge + 1;
      while (edge_end != end && edge_end->first == edge->first) ++edge_end;
      if (edge_end - edge == 2) {
        result.twin[edge->second] = edge[1].second;
        result.twin[edge[1].second] = edge->second;
      } else {
        std::vector<int>& half_edges = result.irregular.emplace_back();
        for (auto entry = edge; entry != edge_end; ++entry) half_edges.push_back(entry->second);
      }
      edge = edge_end;
    }
  }
  return result;
}

Mesh_components_3 orient_components(const Triangle_mesh_3& mesh, const Mesh_edges_3& edges) {
  const int count = static_cast<int>(mesh.triangles.size());
  const auto same_direction = [&](int g, int h) { return half_edge_source(mesh, g) == half_edge_source(mesh, h); };

  // Patches: joined by edges of two triangles.
  std::vector<int> patch(count, -1);
  std::vector<std::uint8_t> flipped(count, 0);
  std::vector<std::uint8_t> patch_agrees;  // as it was read
  std::vector<std::uint8_t> patch_is_orientable;
  std::vector<std::array<int, 2>> turns;  // per patch, how many triangles are flipped [1] and not [0]
  std::vector<int> stack;
  for (int seed = 0; seed < count; ++seed) {
    if (patch[seed] >= 0) continue;
    const int p = static_cast<int>(patch_agrees.size());
    patch_agrees.push_back(1);
    patch_is_orientable.push_back(1);
    turns.push_back({0, 0});
    patch[seed] = p;
    stack.push_back(seed);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      ++turns[p][flipped[t]];
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const int other = edges.twin[h];
        if (other < 0) continue;
        const bool same = same_direction(h, other);
        if (same) patch_agrees[p] = 0;
        const int u = other / 3;
        const auto wanted = static_cast<std::uint8_t>(same ? !flipped[t] : flipped[t]);
        if (patch[u] < 0) {
          patch[u] = p;
          flipped[u] = wanted;
          stack.push_back(u);
        } else if (flipped[u] != wanted) {
          patch_is_orientable[p] = 0;
        }
      }
    }
  }

  const int patches = static_cast<int>(patch_agrees.size());
  Disjoint_sets joined(patches);
  for (const std::vector<int>& edge : edges.irregular)
    for (const int h : edge) joined.join(patch[h / 3], patch[edge[0] / 3]);

  Mesh_components_3 result;
  std::vector<int> number(patches, -1);
  for (int p = 0; p < patches; ++p) {
    const int root = joined.find(p);
    if (root == p) number[p] = result.count++;
    number[p] = number[root];
  }
  const auto is_balanced = [&](const std::vector<int>& edge, bool with_turns) {
    int sum = 0;
    for (const int h : edge) {
      const bool turned = with_turns && flipped[h / 3] != 0;
      sum += same_direction(h, edge[0]) != turned ? 1 : -1;
    }
    return sum == 0;
  };

  // Majority decides the direction of a patch.
  for (int t = 0; t < count; ++t)
    if (turns[patch[t]][1] > turns[patch[t]][0]) flipped[t] ^= 1;
  std::vector<std::uint8_t> input_is_oriented(result.count, 1);
  result.is_oriented.assign(result.count, 1);
  for (int p = 0; p < patches; ++p) {
    if (!patch_agrees[p]) input_is_oriented[number[p]] = 0;
    if (!patch_is_orientable[p]) result.is_oriented[number[p]] = 0;
  }
  for (const std::vector<int>& edge : edges.irregular) {
    const int c = number[patch[edge[0] / 3]];
    if (!is_balanced(edge, false)) input_is_oriented[c] = 0;
    if (!is_balanced(edge, true)) result.is_oriented[c] = 0;
  }
  result.component.resize(count);
  result.flipped.assign(count, 0);
  for (int t = 0; t < count; ++t) {
    const int c = result.component[t] = number[patch[t]];
    if (input_is_oriented[c]) continue;
    result.flipped[t] = flipped[t];
    result.turned_triangles += flipped[t];
  }
  for (int c = 0; c < result.count; ++c)
    if (input_is_oriented[c]) result.is_oriented[c] = 1;
  return result;
}

}  // namespace mesecina
