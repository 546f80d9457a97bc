#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Plants what check_sources.sh forbids and expects it to be found.
set -euo pipefail
check=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/check_sources.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
licence='// SPDX-License-Identifier: GPL-3.0-or-later'

reset() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/{core,geometries,layers}
  printf '%s\n#pragma once\n#include <vector>\n#include "core/b.h"\n' "$licence" >"$tree/core/a.h"
  printf '%s\n#include "core/a.h"\n#include "layers/x.h"\n#include <QImage>\n' "$licence" >"$tree/layers/x.cpp"
}
expect() {  # expect STATUS TEXT
  status=0
  output=$("$check" "$tree" 2>&1) || status=$?
  if [ "$status" -ne "$1" ] || [[ "$output" != *"$2"* ]]; then
    echo "expected exit status $1 and '$2', found $status and: $output" >&2
    exit 1
  fi
}

reset
expect 0 ""
printf '#include "geometries/y.h"\n' >>"$tree/layers/x.cpp"
expect 1 "layers/x.cpp:5: layers may not include geometries"
reset
printf '#include "layers/x.h"\n' >>"$tree/core/a.h"
expect 1 "core/a.h:5: core may not include layers"
reset
printf '#include <QString>\n' >>"$tree/core/a.h"
expect 1 "core may not use Qt or OpenGL"
reset
printf '#pragma once\n' >"$tree/geometries/y.h"
expect 1 "geometries/y.h:1: the licence line is missing"
