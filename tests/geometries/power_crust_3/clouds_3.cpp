// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/power_crust_3/clouds_3.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/formats/format.h"
#include "core/inputs.h"

namespace mesecina::test {

namespace {

using Engine = std::mt19937_64;

double uniform(Engine& engine, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(engine);
}

Point_3 direction(Engine& engine) {
  for (;;) {
    const Point_3 p{uniform(engine, -1, 1), uniform(engine, -1, 1), uniform(engine, -1, 1)};
    const double square = dot(p, p);
    if (square > 0.01 && square < 1) return (1 / std::sqrt(square)) * p;
  }
}

}  // namespace

Cloud random_cloud(int count, std::uint64_t seed) {
  Engine engine(seed);
  Cloud cloud;
  for (int i = 0; i < count; ++i)
    cloud.push_back({uniform(engine, 0, 1), uniform(engine, 0, 1), uniform(engine, 0, 1)});
  return cloud;
}

Cloud integer_cloud(int count, int largest, std::uint64_t seed) {
  Engine engine(seed);
  std::uniform_int_distribution<int> coordinate(0, largest);
  Cloud cloud;
  for (int i = 0; i < count; ++i)
    cloud.push_back({static_cast<double>(coordinate(engine)), static_cast<double>(coordinate(engine)),
                     static_cast<double>(coordinate(engine))});
  return cloud;
}

Cloud lattice(int side) {
  Cloud cloud;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        cloud.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  return cloud;
}

Cloud cube_surface(int side) {
  Cloud cloud = lattice(side);
  const auto is_inner = [side](double c) { return c > 0 && c < side - 1; };
  std::erase_if(cloud, [&](const Point_3& p) { return is_inner(p.x) && is_inner(p.y) && is_inner(p.z); });
  return cloud;
}

Cloud sphere_cloud(const Point_3& center, double radius, int count, std::uint64_t seed) {
  Engine engine(seed);
  Cloud cloud;
  for (int i = 0; i < count; ++i) cloud.push_back(center + radius * direction(engine));
  return cloud;
}

Cloud ellipsoid_cloud(int count, std::uint64_t seed) {
  Engine engine(seed);
  Cloud cloud;
  for (int i = 0; i < count; ++i) {
    const Point_3 p = direction(engine);
    cloud.push_back({2 * p.x, 1.3 * p.y, 0.7 * p.z});
  }
  return cloud;
}

Cloud torus_cloud(double large, double small, int count, std::uint64_t seed) {
  Engine engine(seed);
  Cloud cloud;
  while (static_cast<int>(cloud.size()) < count) {
    const double u = uniform(engine, 0, 2 * std::numbers::pi);
    const double v = uniform(engine, 0, 2 * std::numbers::pi);
    const double r = large + small * std::cos(v);
    if (uniform(engine, 0, large + small) > r) continue;
    cloud.push_back({r * std::cos(u), r * std::sin(u), small * std::sin(v)});
  }
  return cloud;
}

Cloud joined(Cloud one, const Cloud& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

Cloud shuffled(Cloud cloud, std::uint64_t seed) {
  Engine engine(seed);
  std::ranges::shuffle(cloud, engine);
  return cloud;
}

Cloud real_cloud(const std::filesystem::path& name) {
  const Inputs inputs = read_file(spatial_formats(), *data_folder() / "3d" / name).inputs;
  if (const auto cloud = inputs.get(cloud_input)) return *cloud;
  const auto mesh = inputs.get(mesh_input);
  return mesh ? mesh->vertices : Cloud{};
}

}  // namespace mesecina::test
