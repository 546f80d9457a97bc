// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/solid_3/meshes_3.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/formats/format.h"
#include "core/outcome.h"

namespace mesecina::test {

Triangle_mesh_3 box_mesh(const Point_3& lower, const Point_3& upper) {
  Triangle_mesh_3 mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(
        {(i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y, (i & 4) != 0 ? upper.z : lower.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Triangle_mesh_3 sphere_mesh(const Point_3& center, double radius, int rings) {
  Triangle_mesh_3 mesh;
  const int around = 2 * rings;
  const auto add = [&](double polar, double angle) {
    mesh.vertices.push_back(center + radius * Point_3{std::sin(polar) * std::cos(angle),
                                                      std::sin(polar) * std::sin(angle), std::cos(polar)});
  };
  mesh.vertices.push_back(center + Point_3{0, 0, radius});
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < around; ++j) add(std::numbers::pi * i / rings, 2 * std::numbers::pi * j / around);
  mesh.vertices.push_back(center - Point_3{0, 0, radius});
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [&](int i, int j) { return 1 + (i - 1) * around + j % around; };
  for (int j = 0; j < around; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i + 1 < rings; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    mesh.triangles.push_back({last, at(rings - 1, j + 1), at(rings - 1, j)});
  }
  return mesh;
}

Triangle_mesh_3 torus_mesh(double large, double small, int around, int across) {
  Triangle_mesh_3 mesh;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double a = 2 * std::numbers::pi * i / around;
      const double b = 2 * std::numbers::pi * j / across;
      const double distance_to_axis = large + small * std::cos(b);
      mesh.vertices.push_back({distance_to_axis * std::cos(a), distance_to_axis * std::sin(a), small * std::sin(b)});
    }
  }
  const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

Triangle_mesh_3 sheet_mesh(int columns, int rows) {
  Triangle_mesh_3 mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.vertices.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  const auto at = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

Triangle_mesh_3 joined(const std::vector<Triangle_mesh_3>& meshes) {
  Triangle_mesh_3 result;
  for (const Triangle_mesh_3& mesh : meshes) {
    const int before = static_cast<int>(result.vertices.size());
    result.vertices.insert(result.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const std::array<int, 3>& t : mesh.triangles)
      result.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
  }
  return result;
}

Triangle_mesh_3 turned(Triangle_mesh_3 mesh) {
  for (std::array<int, 3>& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

Triangle_mesh_3 shuffled(Triangle_mesh_3 mesh, std::uint64_t seed) {
  const std::vector<int> order = random_permutation(static_cast<int>(mesh.triangles.size()), seed);
  std::vector<std::array<int, 3>> triangles;
  for (const int t : order) triangles.push_back(mesh.triangles[t]);
  mesh.triangles = std::move(triangles);
  return mesh;
}

Triangle_mesh_3 unwelded(const Triangle_mesh_3& mesh) {
  Triangle_mesh_3 result;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const int first = static_cast<int>(result.vertices.size());
    for (const int v : t) result.vertices.push_back(mesh.vertices[v]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

Solid_3 solid_of(const Triangle_mesh_3& mesh, Repair repair, int threads) {
  Progress progress({}, {}, threads);
  return make_solid(std::make_shared<const Triangle_mesh_3>(mesh), repair, progress);
}

std::string reason_of(const Triangle_mesh_3& mesh, Repair repair) {
  try {
    solid_of(mesh, repair);
  } catch (const Unavailable& reason) {
    return reason.what();
  }
  return {};
}

std::vector<std::uint8_t> inside_of(const Solid_3& solid, const std::vector<Point_3>& points, int threads) {
  Progress progress({}, {}, threads);
  return are_inside(solid, points, progress);
}

std::vector<Point_3> points_around(const Triangle_mesh_3& mesh, int count, std::uint64_t seed) {
  Box box;
  for (const Point_3& p : mesh.vertices) box.add(p);
  const Point_3 margin = 0.1 * (box.upper - box.lower);
  Random random(seed);
  std::vector<Point_3> result;
  for (int i = 0; i < count; ++i)
    result.push_back({random.uniform(box.lower.x - margin.x, box.upper.x + margin.x),
                      random.uniform(box.lower.y - margin.y, box.upper.y + margin.y),
                      random.uniform(box.lower.z - margin.z, box.upper.z + margin.z)});
  return result;
}

std::vector<Point_3> difficult_points(const Triangle_mesh_3& mesh, int count, std::uint64_t seed) {
  std::vector<Point_3> result = points_around(mesh, count, seed);
  Random random(seed + 1);
  const auto vertex = [&] { return mesh.vertices[random.index(static_cast<int>(mesh.vertices.size()))]; };
  for (Point_3& p : result) {
    const int kind = random.index(8);
    if ((kind & 1) == 0) p.x = vertex().x;
    if ((kind & 2) == 0) p.y = vertex().y;
    if ((kind & 4) == 0) p.z = vertex().z;
    if (random.chance(0.2)) p = vertex();
    if (random.chance(0.1)) {
      const std::array<int, 3>& t = mesh.triangles[random.index(static_cast<int>(mesh.triangles.size()))];
      p = midpoint(mesh.vertices[t[0]], mesh.vertices[t[1]]);
    }
  }
  return result;
}

double volume(const Triangle_mesh_3& mesh) {
  double result = 0;
  for (const auto& [u, v, w] : mesh.triangles)
    result += dot(mesh.vertices[u], cross(mesh.vertices[v], mesh.vertices[w])) / 6;
  return result;
}

bool is_closed(const Triangle_mesh_3& mesh) {
  std::map<std::pair<int, int>, int> balance;
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int u = t[k];
      const int v = t[(k + 1) % 3];
      balance[std::minmax(u, v)] += u < v ? 1 : -1;
    }
  }
  for (const auto& [edge, sum] : balance)
    if (sum != 0) return false;
  return true;
}

Triangle_mesh_3 real_mesh(const std::filesystem::path& name) {
  const auto mesh = read_file(spatial_formats(), *data_folder() / "3d" / name).inputs.get(mesh_input);
  return mesh ? *mesh : Triangle_mesh_3{};
}

}  // namespace mesecina::test
