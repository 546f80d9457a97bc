#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Uses mesecina2d in a real window under a virtual X server with real mouse and key events, and checks what it saved.
# Usage: real_window_test.sh PROGRAM
# shellcheck source=tests/real_window.sh
. "$(dirname "${BASH_SOURCE[0]}")/../real_window.sh"

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
last_point() { tail -n 1 "$folder/four.xy"; }
last_point_is() { [ "$(last_point)" = "$1" ]; }
last_point_is_not() { [ "$(last_point)" != "$1" ]; }
has_points() { [ "$(lines)" -eq "$1" ]; }

# save_until SECONDS COMMAND...: saves again and again until the command, which looks at the file, succeeds. Events are
# handled in order, so that the file of the last save tells what came of all before it, however slow the machine is.
save_until() {
  local end=$((SECONDS + $1))
  shift
  while [ "$SECONDS" -lt "$end" ]; do
    xdotool key --delay 30 ctrl+s
    for _ in $(seq 10); do
      sleep 0.05
      if "$@"; then return 0; fi
    done
  done
  return 1
}
expect_points() {
  save_until 20 has_points "$1" || fail "$2: expected $1 points in the saved file, found $(lines)"
}

# The two clicks of a double click may come too late after each other where the processor is busy: a click changes nothing.
for _ in 1 2 3; do
  xdotool mousemove "$x" "$y" click --repeat 2 --delay 60 1
  if save_until 7 has_points 5; then break; fi
done
has_points 5 || fail "double click adds a point: expected 5 points in the saved file, found $(lines)"
added=$(last_point)

xdotool mousemove "$x" "$y" mousedown 1
for step in 10 20 30 40; do
  xdotool mousemove $((x + step)) "$y"
  sleep 0.05
done
xdotool mouseup 1
save_until 20 last_point_is_not "$added" || fail "a drag moved nothing"

xdotool key --delay 30 ctrl+z
save_until 20 last_point_is "$added" || fail "undo did not take the drag back"

xdotool key --delay 30 ctrl+d
expect_points 6 "Ctrl+D duplicates"
xdotool key --delay 30 Delete
expect_points 5 "Del deletes"

# Disks are drawn into an empty plane and saved over the file of one.
xdotool key --delay 30 ctrl+q
wait_for 20 sh -c "! kill -0 $process" || fail "Ctrl+Q does not close the window"
process=
printf 'WPOFF 1 0 0\n0 0 10\n' >"$folder/one.wpoff"
"$program" "$folder/one.wpoff" >"$folder/output" 2>&1 &
process=$!
wait_for 30 xdotool search --onlyvisible --name 'one.wpoff.*Mesecina' || fail "no window with the file of disks: $(cat "$folder/output")"
window=$(xdotool search --onlyvisible --name 'one.wpoff.*Mesecina' | head -n 1)
xdotool windowfocus --sync "$window"
sleep 1
disks() { cat "$folder/one.wpoff"; }
has_disks() { grep -q "^WPOFF $1 0 0" "$folder/one.wpoff"; }
last_disk_is() { [ "$(tail -n 1 "$folder/one.wpoff")" = "$1" ]; }
radius() { tail -n 1 "$folder/one.wpoff" | cut -d ' ' -f 3; }
# radius_within RADIUS LEAST MOST: whether the last disk has between LEAST and MOST times that radius.
radius_within() {
  awk -v old="$1" -v new="$(radius)" -v least="$2" -v most="$3" 'BEGIN { exit !(new > least * old && new < most * old) }'
}
expect_disks() {
  save_until 20 has_disks "$1" || fail "$2: expected $1 disks, found $(disks)"
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
expect_disks 2 "a drag draws a disk"
drawn=$(tail -n 1 "$folder/one.wpoff")
old_radius=$(radius)

# The new disk is selected: one notch of the wheel makes it larger by about 6 percent, and undo takes that back.
xdotool mousemove $((x - 60)) "$y" click 4
save_until 20 radius_within "$old_radius" 1.03 1.1 || fail "the wheel resized from $old_radius to $(radius)"
xdotool key --delay 30 ctrl+z
save_until 20 last_disk_is "$drawn" || fail "undo did not take the wheel back"
has_disks 2 || fail "undo of the wheel changed the number of disks: $(disks)"

# Its boundary is 50 pixels from its center, and so is its handle.
xdotool key --delay 30 v
drag $((x - 10)) "$y" $((x + 40)) "$y"
save_until 20 radius_within "$old_radius" 1.9 2.1 ||
  fail "a handle dragged to twice the radius made $(radius) of $old_radius"
has_disks 2 || fail "a handle changed the number of disks: $(disks)"
xdotool key --delay 30 Delete
expect_disks 1 "Del deletes a disk"

xdotool key --delay 30 ctrl+q
wait_for 20 sh -c "! kill -0 $process" || fail "Ctrl+Q does not close the window"
code=0
wait "$process" || code=$?
process=
[ "$code" -eq 0 ] || fail "exit code $code: $(cat "$folder/output")"
