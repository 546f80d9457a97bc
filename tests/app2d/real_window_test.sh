#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Uses mesecina2d in a real window under a virtual X server with real mouse and key events, and checks what it saved.
# Usage: real_window_test.sh PROGRAM
set -euo pipefail

program=$(realpath "$1")
if [ -z "${INSIDE_XVFB-}" ]; then
  INSIDE_XVFB=1 exec xvfb-run -a -s "-screen 0 1280x800x24" "$0" "$program"
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
  echo "real window: $1" >&2
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

printf '0 0\n100 0\n100 60\n0 60\n' >"$folder/four.xy"
"$program" "$folder/four.xy" >"$folder/output" 2>&1 &
process=$!
wait_for 30 xdotool search --onlyvisible --name 'four.xy.*Mesecina' || fail "no window with the file's name: $(cat "$folder/output")"
window=$(xdotool search --onlyvisible --name 'four.xy.*Mesecina' | head -n 1)
xdotool windowfocus --sync "$window"
sleep 1

# The middle of the window lies on the canvas, which the data fills; every corner has 60 to the side and 0 to the top.
eval "$(xdotool getwindowgeometry --shell "$window")"
x=$((X + WIDTH / 2))
y=$((Y + HEIGHT / 2))
lines() { wc -l <"$folder/four.xy"; }
save_and_expect() {
  xdotool key --delay 30 ctrl+s
  wait_for 5 test "$(lines)" -eq "$1" || true
  for _ in $(seq 50); do
    [ "$(lines)" -eq "$1" ] && return 0
    sleep 0.1
  done
  fail "$2: expected $1 points in the saved file, found $(lines)"
}

xdotool mousemove "$x" "$y" click --repeat 2 --delay 60 1
sleep 0.5
save_and_expect 5 "double click adds a point"
added=$(tail -n 1 "$folder/four.xy")

xdotool mousemove "$x" "$y" mousedown 1
for step in 10 20 30 40; do
  xdotool mousemove $((x + step)) "$y"
  sleep 0.05
done
xdotool mouseup 1
sleep 0.3
xdotool key --delay 30 ctrl+s
sleep 0.5
[ "$(tail -n 1 "$folder/four.xy")" != "$added" ] || fail "a drag moved nothing"

xdotool key --delay 30 ctrl+z
sleep 0.3
xdotool key --delay 30 ctrl+s
sleep 0.5
[ "$(tail -n 1 "$folder/four.xy")" = "$added" ] || fail "undo did not take the drag back"

xdotool key --delay 30 ctrl+d
sleep 0.3
save_and_expect 6 "Ctrl+D duplicates"
xdotool key --delay 30 Delete
sleep 0.3
save_and_expect 5 "Del deletes"

xdotool key --delay 30 ctrl+q
for _ in $(seq 30); do
  kill -0 "$process" 2>/dev/null || break
  sleep 0.1
done
kill -0 "$process" 2>/dev/null && fail "Ctrl+Q does not close the window"
code=0
wait "$process" || code=$?
process=
[ "$code" -eq 0 ] || fail "exit code $code: $(cat "$folder/output")"
