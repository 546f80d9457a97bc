// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/files_3.h"

#include <QDir>
#include <QFileInfo>
#include <utility>

#include "app3d/example_3.h"
#include "core/input_elements.h"

namespace mesecina {

namespace {

QString part_name(const std::string& input_id) {
  if (input_id == mesh_input.id) return Files_3::tr("mesh");
  if (input_id == balls_input.id) return Files_3::tr("balls");
  return Files_3::tr("points");
}

}  // namespace

Inputs appended_3(const Inputs& inputs, const Inputs& more) {
  Inputs result = inputs;
  if (const auto balls = more.get(balls_input)) result = with_elements(result, balls_input, *balls);
  if (const auto cloud = more.get(cloud_input)) result = with_elements(result, cloud_input, *cloud);
  const auto added = more.get(mesh_input);
  if (!added) return result;
  const auto own = inputs.get(mesh_input);
  if (!own) return result.with(mesh_input, added);
  Triangle_mesh_3 both = *own;
  const int first = static_cast<int>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), added->vertices.begin(), added->vertices.end());
  for (const auto& [a, b, c] : added->triangles) both.triangles.push_back({first + a, first + b, first + c});
  return result.with(mesh_input, std::move(both));
}

Files_3::Files_3(Document& document, std::shared_ptr<const Formats> formats, QWidget* window)
    : Files(document, std::move(formats), {QStringLiteral("mesecina3d"), 3, appended_3, part_name}, window) {}

QStringList Files_3::examples() { return {QStringLiteral("points.xyz"), QStringLiteral("ring.off")}; }

Inputs Files_3::example(const QString& name) {
  constexpr int segments = 96;
  Triangle_mesh_3 ring = twisted_ring(segments);
  if (name == QLatin1String("ring.off")) return Inputs().with(mesh_input, std::move(ring));
  return Inputs().with(cloud_input, std::move(ring.vertices));
}

void Files_3::write_example(const Formats& formats, const QString& name, const QString& folder) {
  const Inputs inputs = example(name);
  const std::string extension = QFileInfo(name).suffix().toStdString();
  for (const Input_writer& writer : formats.input_writers) {
    if (writer.extension != extension || !inputs.identity(writer.input_id)) continue;
    write_file(QDir(folder).filePath(name).toStdString(), [&](std::ostream& out) { writer.write(out, inputs); });
    return;
  }
}

}  // namespace mesecina
