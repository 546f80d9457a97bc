#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Edits balls with mesecina3d in a real window under a virtual X server with real mouse and key events, looks at what it
# saved, and closes it while it computes.
# Usage: real_editing_test.sh PROGRAM
# shellcheck source=tests/real_window.sh
. "$(dirname "${BASH_SOURCE[0]}")/../real_window.sh"
is_gone() { ! kill -0 "$process"; }

# open_window NAME OPTION...: starts the program and waits for the window that has the name in its title.
open_window() {
  local name=$1
  shift
  "$program" "$@" >"$folder/output" 2>&1 &
  process=$!
  wait_for 30 xdotool search --onlyvisible --name "$name.*Mesecina" || fail "no window of $name: $(cat "$folder/output")"
  window=$(xdotool search --onlyvisible --name "$name.*Mesecina" | head -n 1)
  xdotool windowfocus --sync "$window"
  sleep 1
}
expect_good_end() {
  local code=0
  wait "$process" || code=$?
  process=
  [ "$code" -eq 0 ] || fail "exit code $code: $(cat "$folder/output")"
}

# One ball around the middle of the canvas.
file=$folder/one.woff
printf 'WOFF 1 0 0\n0 0 0 1\n' >"$file"
open_window one.woff "$file"
eval "$(xdotool getwindowgeometry --shell "$window")"
x=$((X + WIDTH / 2))
y=$((Y + HEIGHT / 2))
drag() {
  xdotool mousemove "$1" "$2" mousedown 1
  for step in 1 2 3 4; do
    xdotool mousemove $(($1 + ($3 - $1) * step / 4)) $(($2 + ($4 - $2) * step / 4))
    sleep 0.05
  done
  xdotool mouseup 1
}
balls() { tail -n +2 "$file"; }
first_ball_is() { [ "$(balls | head -n 1)" = "$1" ]; }
first_ball_is_not() { [ "$(balls | head -n 1)" != "$1" ]; }
has_balls() { grep -q "^WOFF $1 " "$file" && [ "$(balls | wc -l)" -eq "$1" ]; }
last_radius() { balls | tail -n 1 | cut -d ' ' -f 4; }
# last_radius_within RADIUS LEAST MOST: whether the last ball has between LEAST and MOST times that radius.
last_radius_within() {
  awk -v old="$1" -v new="$(last_radius)" -v least="$2" -v most="$3" 'BEGIN { exit !(new > least * old && new < most * old) }'
}

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

xdotool key --delay 30 v
drag "$x" "$y" $((x + 60)) "$y"
save_until 20 first_ball_is_not "0 0 0 1" || fail "a drag moved nothing"
has_balls 1 || fail "a drag changed the number of balls: $(cat "$file")"
xdotool key --delay 30 ctrl+z
save_until 20 first_ball_is "0 0 0 1" || fail "undo did not take the drag back: $(balls)"

xdotool key --delay 30 b
xdotool mousemove $((x - 30)) $((y + 40)) click 1
save_until 20 has_balls 2 || fail "a click added no ball: $(cat "$file")"
radius=$(last_radius)
xdotool keydown shift click 4 keyup shift
save_until 20 last_radius_within "$radius" 1.03 1.1 || fail "Shift and the wheel resized from $radius to $(last_radius)"
xdotool key --delay 30 Delete
save_until 20 has_balls 1 || fail "Del did not delete the new ball: $(cat "$file")"
first_ball_is "0 0 0 1" || fail "the first ball changed: $(balls)"

xdotool key --delay 30 ctrl+q
wait_for 20 is_gone || fail "Ctrl+Q does not close the window"
expect_good_end

# A torus whose samples take long.
awk 'BEGIN {
  n = 160; m = 60; turn = 6.283185307179586
  print "OFF"; print n * m, 2 * n * m, 0
  for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
    r = 1 + 0.3 * cos(turn * j / m); print r * cos(turn * i / n), r * sin(turn * i / n), 0.3 * sin(turn * j / m)
  }
  for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
    a = i * m + j; b = (i + 1) % n * m + j; c = (i + 1) % n * m + (j + 1) % m; d = i * m + (j + 1) % m
    print 3, a, b, c; print 3, a, c, d
  }
}' >"$folder/torus.off"
open_window torus.off "$folder/torus.off" --set delta=0.002
sleep 1
xdotool key --delay 30 ctrl+q
wait_for 5 is_gone || fail "the window does not close at once while it computes"
expect_good_end
