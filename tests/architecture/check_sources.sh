#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_sources.sh ROOT: names every line that breaks the rules of the house (docs/architecture.md): which room may
# include which, no Qt or OpenGL in core and geometries, the licence on top of every source. Exit 1 when there is one.
set -euo pipefail
cd "$1"

# Rooms whose headers each room may include.
declare -A may_include=(
  [core]="core"
  [geometries]="core geometries"
  [layers]="core layers"
  [bundles]="core layers bundles"
  [shell]="core geometries layers bundles shell"
  [app2d]="core geometries layers bundles shell app2d"
  [app3d]="core geometries layers bundles shell app3d"
)
# Headers of libraries that the rooms without windows do without.
window_headers='#include <(Q|epoxy/|glm/|GL/|EGL/)'

broken=0
complain() {
  echo "$1" >&2
  broken=1
}

for room in "${!may_include[@]}"; do
  [ -d "$room" ] || continue
  while IFS=: read -r file line text; do
    included=${text#*\"}
    included_room=${included%%/*}
    [ -n "${may_include[$included_room]-}" ] || continue
    [[ " ${may_include[$room]} " == *" $included_room "* ]] ||
      complain "$file:$line: $room may not include $included_room"
  done < <(grep -rnE --include='*.h' --include='*.cpp' '^ *# *include "[^"]+/' "$room" || true)
done

for room in core geometries; do
  [ -d "$room" ] || continue
  while IFS= read -r place; do
    complain "$place: $room may not use Qt or OpenGL"
  done < <(grep -rnE --include='*.h' --include='*.cpp' "$window_headers" "$room" || true)
done

while IFS= read -r file; do
  read -r first <"$file" || true
  [ "$first" = "// SPDX-License-Identifier: GPL-3.0-or-later" ] || complain "$file:1: the licence line is missing"
done < <(find core geometries layers bundles shell app2d app3d tests bench docs \( -name '*.h' -o -name '*.cpp' \) \
  2>/dev/null | sort)

exit $broken
