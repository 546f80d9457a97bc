# SPDX-License-Identifier: GPL-3.0-or-later
# For tests with real windows, to be sourced with the test's arguments, of which the first is the program: starts the test
# again under a virtual X server. Then there are $program, an empty folder $folder that goes in the end, $process, which is
# ended with the test, and the functions below; preferences are those of a new user, and OpenGL is software.
set -euo pipefail

program=$(realpath "$1")
# Without -noreset the server starts anew when its last client ends, and refuses the next one meanwhile.
if [ -z "${INSIDE_XVFB-}" ]; then
  INSIDE_XVFB=1 exec xvfb-run -a -s "-screen 0 1280x800x24 -noreset" "$0" "$program"
fi

folder=$(mktemp -d)
process=
cleanup() {
  [ -z "$process" ] || kill "$process" 2>/dev/null || true
  rm -rf "$folder"
}
trap cleanup EXIT

export XDG_CONFIG_HOME=$folder/config XDG_RUNTIME_DIR=$folder/run QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY MESECINA_CANVAS QT_SCALE_FACTOR MESECINA_NO_PROMPT
mkdir -m 700 "$folder/run"

fail() {
  echo "$(basename "$0" .sh): $1" >&2
  exit 1
}

# wait_for SECONDS COMMAND...: until the command succeeds.
wait_for() {
  local tries=$(($1 * 10))
  shift
  for _ in $(seq "$tries"); do
    if "$@" >/dev/null 2>&1; then return 0; fi
    sleep 0.1
  done
  return 1
}
