// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mesecina {

/// Scenes of more bytes are not put into pictures: who sends a picture does not expect it to be so large.
inline constexpr std::size_t most_scene_bytes = 20'000'000;

/// The bytes of a picture (PNG, SVG or PDF) with the text of a session within, compressed, where other programs do not
/// look: a zTXt chunk, the <metadata> of the root, comments before the table of a PDF. The picture itself stays as it
/// is. Throws std::invalid_argument for other bytes. The scene must be ASCII.
std::string picture_with_scene(std::string_view picture, std::string_view scene);

/// The scene within a picture; nothing for a picture without one, and for anything else. Throws std::invalid_argument
/// when there is one but damaged.
std::optional<std::string> scene_of_picture(std::string_view bytes);

/// Puts the scene into the picture in this file. Throws File_error.
void add_scene_to_picture(const std::filesystem::path& file, std::string_view scene);

}  // namespace mesecina
