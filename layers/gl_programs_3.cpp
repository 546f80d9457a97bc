// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_programs_3.h"

#include <string>
#include <string_view>

#include "layers/gl_shader_sources.h"

namespace mesecina {

namespace {

struct Kind {
  Gl_programs_3::Paint paint;
  bool has_planes;
};

Gl_program program_of(const Kind& kind, std::initializer_list<std::string_view> vertex, std::string_view fragment) {
  std::string head = "#version 330 core\n";
  if (kind.paint == Gl_programs_3::Paint::ids) head += "#define IDS\n";
  if (kind.paint == Gl_programs_3::Paint::peeled_colors) head += "#define PEELING\n";
  if (kind.has_planes) head += "#define PLANES\n";
  Gl_program program(vertex, {head, shaders::surface_3_frag, fragment});
  program.use();
  // Samplers of different kinds must not read the same unit, used or not.
  program.set("color_map", units_3::color_map);
  program.set("places", units_3::places);
  program.set("pieces", units_3::pieces);
  program.set("normals", units_3::normals);
  program.set("numbers", units_3::numbers);
  program.set("threshold_numbers", units_3::threshold_numbers);
  program.set("cut_numbers", units_3::cut_numbers);
  program.set("solid_depth", units_3::solid_depth);
  program.set("nearer_depth", units_3::nearer_depth);
  return program;
}

Gl_program element_program(const Kind& kind, std::string_view vertex, std::string_view fragment) {
  return program_of(kind, {shaders::color_map_vert, shaders::element_3_vert, vertex}, fragment);
}

}  // namespace

Gl_programs_3::Gl_programs_3(Paint painted, bool has_planes)
    : paint(painted),
      points(element_program({painted, has_planes}, shaders::point_3_vert, shaders::point_3_frag)),
      segments(element_program({painted, has_planes}, shaders::segment_3_vert, shaders::segment_3_frag)),
      faces(element_program({painted, has_planes}, shaders::face_3_vert, shaders::face_3_frag)),
      balls(element_program({painted, has_planes}, shaders::ball_3_vert, shaders::ball_3_frag)),
      areas(program_of({painted, has_planes}, {"#version 330 core\n", shaders::area_3_vert}, shaders::area_3_frag)) {}

}  // namespace mesecina
