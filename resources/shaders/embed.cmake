# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=header -P embed.cmake: writes every shader of this folder into a C++ header as a string.
set(text "// SPDX-License-Identifier: GPL-3.0-or-later\n#pragma once\n\n#include <string_view>\n\n")
string(APPEND text "namespace mesecina::shaders {\n\n")
file(GLOB shaders ${CMAKE_CURRENT_LIST_DIR}/*.vert ${CMAKE_CURRENT_LIST_DIR}/*.frag)
foreach(shader IN LISTS shaders)
  cmake_path(GET shader STEM stem)
  cmake_path(GET shader EXTENSION LAST_ONLY extension)
  string(SUBSTRING ${extension} 1 -1 extension)
  file(READ ${shader} source)
  string(APPEND text "inline constexpr std::string_view ${stem}_${extension} = R\"glsl(${source})glsl\";\n\n")
endforeach()
string(APPEND text "}  // namespace mesecina::shaders\n")
file(WRITE ${OUTPUT} "${text}")
