// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session_formats.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "core/formats/picture_scene.h"
#include "core/formats/text_file.h"

namespace mesecina {

namespace {

namespace fs = std::filesystem;

constexpr std::array picture_extensions{"png", "svg", "pdf"};

bool is_picture(const fs::path& file) {
  const std::string extension = lower_case(file.extension().string());
  return std::ranges::any_of(picture_extensions,
                             [&](const char* known) { return extension == "." + std::string(known); });
}

/// Throws File_error for one that is damaged; nothing where there is none.
std::optional<Session> find_scene(const fs::path& file, const Registry& registry) {
  try {
    const auto scene = scene_of_picture(load_bytes(file).text);
    if (!scene) return std::nullopt;
    return parse_session(*scene, registry);
  } catch (const std::invalid_argument& error) {
    throw File_error(file, 0, std::string("the scene within the picture: ") + error.what());
  }
}

File_contents contents_of(Session session) {
  File_contents contents;
  contents.inputs = session.inputs;
  contents.warnings = session.unknown.parts.notes;
  contents.session = std::make_shared<const Session>(std::move(session));
  return contents;
}

}  // namespace

Session read_session_file(const fs::path& file, const Registry& registry) {
  if (is_picture(file)) {
    if (auto session = find_scene(file, registry)) return std::move(*session);
    throw File_error(file, 0, "expected a picture with a scene, as Mesecina writes it, found none within");
  }
  try {
    return parse_session(load_bytes(file).text, registry);
  } catch (const std::invalid_argument& error) {
    throw File_error(file, 0, error.what());
  }
}

void add_session_formats(Formats& formats, const std::shared_ptr<const Registry>& registry) {
  std::vector<std::string> only_with_scene;
  for (const char* extension : picture_extensions) {
    const auto known = std::ranges::find_if(
        formats.readers, [&](const Reader& reader) { return std::ranges::count(reader.extensions, extension) > 0; });
    if (known == formats.readers.end()) {
      only_with_scene.emplace_back(extension);
      continue;
    }
    known->read = [plain = known->read, registry](const fs::path& file) {
      auto session = is_picture(file) ? find_scene(file, *registry) : std::nullopt;
      return session ? contents_of(std::move(*session)) : plain(file);
    };
  }
  const auto read = [registry](const fs::path& file) { return contents_of(read_session_file(file, *registry)); };
  formats.readers.push_back({"Sessions", {std::string(session_extension)}, read});
  if (!only_with_scene.empty()) formats.readers.push_back({"Pictures with a scene", only_with_scene, read});
}

}  // namespace mesecina
