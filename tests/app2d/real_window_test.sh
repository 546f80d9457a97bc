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

# Disks are drawn into an empty plane and saved over the file of one.
xdotool key --delay 30 ctrl+q
wait_for 10 sh -c "! kill -0 $process" || fail "Ctrl+Q does not close the window"
process=
printf 'WPOFF 1 0 0\n0 0 10\n' >"$folder/one.wpoff"
"$program" "$folder/one.wpoff" >"$folder/output" 2>&1 &
process=$!
wait_for 30 xdotool search --onlyvisible --name 'one.wpoff.*Mesecina' || fail "no window with the file of disks: $(cat "$folder/output")"
window=$(xdotool search --onlyvisible --name 'one.wpoff.*Mesecina' | head -n 1)
xdotool windowfocus --sync "$window"
sleep 1
disks() { cat "$folder/one.wpoff"; }
save_and_expect_disks() {
  sleep 0.3
  xdotool key --delay 30 ctrl+s
  wait_for 5 grep -q "^WPOFF $1 0 0" "$folder/one.wpoff" || fail "$2: expected $1 disks, found $(disks)"
  # Also where the number of disks is the same, so that nothing tells when the file is written.
  sleep 0.5
}
drag() {
  xdotool mousemove "$1" "$2" mousedown 1
  for step in 1 2 3 4; do
    xdotool mousemove $(($1 + ($3 - $1) * step / 4)) $(($2 + ($4 - $2) * step / 4))
    sleep 0.05
  done
  xdotool mouseup 1
}

xdotool key --delay 30 d
drag $((x - 60)) "$y" $((x - 20)) $((y + 30))
save_and_expect_disks 2 "a drag draws a disk"
drawn=$(tail -n 1 "$folder/one.wpoff")
radius() { tail -n 1 "$folder/one.wpoff" | cut -d ' ' -f 3; }
old_radius=$(radius)

# The new disk is selected: one notch of the wheel makes it larger by about 6 percent, and undo takes that back.
xdotool mousemove $((x - 60)) "$y" click 4
save_and_expect_disks 2 "the wheel keeps disks"
awk -v a="$old_radius" -v b="$(radius)" 'BEGIN { exit !(b > 1.03 * a && b < 1.1 * a) }' ||
  fail "the wheel resized from $old_radius to $(radius)"
xdotool key --delay 30 ctrl+z
save_and_expect_disks 2 "undo keeps disks"
[ "$(tail -n 1 "$folder/one.wpoff")" = "$drawn" ] || fail "undo did not take the wheel back"

# Its boundary is 50 pixels from its center, and so is its handle.
xdotool key --delay 30 v
drag $((x - 10)) "$y" $((x + 40)) "$y"
save_and_expect_disks 2 "a handle keeps disks"
awk -v a="$old_radius" -v b="$(radius)" 'BEGIN { exit !(b > 1.9 * a && b < 2.1 * a) }' ||
  fail "a handle dragged to twice the radius made $(radius) of $old_radius"
xdotool key --delay 30 Delete
save_and_expect_disks 1 "Del deletes a disk"

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
