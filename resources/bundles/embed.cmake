# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=source -P embed.cmake: writes the bundles of this folder into a C++ source as strings.
set(text "// SPDX-License-Identifier: GPL-3.0-or-later\n#include \"core/shipped_bundle_files.h\"\n\n")
string(APPEND text "#include <array>\n\nnamespace mesecina {\n\nnamespace {\n\nusing namespace std::string_view_literals;\n\n")
foreach(dimension 2 3)
  file(GLOB bundles ${CMAKE_CURRENT_LIST_DIR}/${dimension}d/*.json)
  list(SORT bundles)
  string(APPEND text "constexpr std::array files_${dimension} = {\n")
  foreach(bundle IN LISTS bundles)
    file(READ ${bundle} source)
    string(APPEND text "R\"bundle(${source})bundle\"sv,\n")
  endforeach()
  string(APPEND text "};\n\n")
endforeach()
string(APPEND text "}  // namespace\n\nstd::span<const std::string_view> shipped_bundle_files(int dimension) {\n"
       "  if (dimension == 2) return files_2;\n  if (dimension == 3) return files_3;\n  return {};\n}\n\n"
       "}  // namespace mesecina\n")
file(WRITE ${OUTPUT} "${text}")
