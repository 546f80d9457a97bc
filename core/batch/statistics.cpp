// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/statistics.h"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace mesecina {

using Ordered_json = nlohmann::ordered_json;

std::map<std::string, std::uint64_t> count_inputs(const Inputs& inputs) {
  std::map<std::string, std::uint64_t> counts;
  if (const auto points = inputs.get(points_input)) counts["points"] = points->size();
  if (const auto disks = inputs.get(disks_input)) counts["disks"] = disks->size();
  if (const auto outline = inputs.get(outline_input)) {
    counts["rings"] = outline->rings.size();
    std::uint64_t vertices = 0;
    for (const Ring_2& ring : outline->rings) vertices += ring.size();
    counts["outline-vertices"] = vertices;
  }
  if (const auto image = inputs.get(image_input))
    counts["pixels"] = static_cast<std::uint64_t>(image->width) * static_cast<std::uint64_t>(image->height);
  if (const auto mesh = inputs.get(mesh_input)) {
    counts["mesh-vertices"] = mesh->vertices.size();
    counts["triangles"] = mesh->triangles.size();
  }
  if (const auto balls = inputs.get(balls_input)) counts["balls"] = balls->size();
  if (const auto cloud = inputs.get(cloud_input)) counts["points"] = cloud->size();
  return counts;
}

std::string layer_statistics(const Primitive_set* primitives, const std::string& reason) {
  Ordered_json json;
  if (!primitives) {
    json["reason"] = reason;
    return json.dump();
  }
  const auto add = [&](const char* name, std::size_t count) {
    if (count > 0) json[name] = count;
  };
  json["vertices"] = primitives->vertices.size();
  add("points", primitives->points.size());
  add("segments", primitives->segments.size());
  add("rays", primitives->rays.size());
  add("arcs", primitives->arcs.size());
  add("triangles", primitives->triangles.size());
  add("polygons", primitives->polygon_count());
  add("balls", primitives->balls.size());
  if (const auto topology = mesecina::topology(*primitives)) {
    json["euler"] = topology->euler;
    json["betti"] = topology->betti;
  }
  return json.dump();
}

std::string to_json_line(const Input_statistics& statistics) {
  Ordered_json json;
  json["input"] = statistics.input;
  json["status"] = statistics.failed ? "failed" : statistics.refused.empty() ? "ok" : "incomplete";
  if (statistics.failed) json["reason"] = statistics.reason;
  if (!statistics.refused.empty()) json["refused"] = statistics.refused;
  json["seconds"] = statistics.seconds;
  json["peak_rss_bytes"] = peak_memory();
  json["counts"] = statistics.counts;
  for (const Evolution_statistics& evolution : statistics.evolutions) {
    Ordered_json entry{{"id", evolution.id}, {"steps", evolution.steps}, {"seconds", evolution.seconds}};
    if (!evolution.end_reason.empty()) entry["reason"] = evolution.end_reason;
    json["evolutions"].push_back(std::move(entry));
  }
  json["layers"] = Ordered_json::object();
  for (const auto& [id, text] : statistics.layers) json["layers"][id] = Ordered_json::parse(text);
  if (!statistics.errors.empty()) json["error"] = statistics.errors;
  if (!statistics.notes.empty()) json["notes"] = statistics.notes;
  json["warnings"] = statistics.warnings;
  return json.dump(-1, ' ', false, Ordered_json::error_handler_t::replace) + "\n";
}

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

void forget_peak_memory() { std::ofstream("/proc/self/clear_refs") << '5'; }

std::uint64_t present_memory() {
  // Sizes in pages: of the program, and of what of it is resident.
  std::ifstream statm("/proc/self/statm");
  std::uint64_t size = 0;
  std::uint64_t resident = 0;
  statm >> size >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace mesecina
