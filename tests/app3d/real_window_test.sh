#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Uses mesecina3d in a real window under a virtual X server with real mouse and key events, and looks at the screen.
# Usage: real_window_test.sh PROGRAM
# shellcheck source=tests/real_window.sh
. "$(dirname "${BASH_SOURCE[0]}")/../real_window.sh"

# Three balls in a row along x.
printf '%s\n' '-2 0 0 1' '0 0 0 1' '2 0 0 1' >"$folder/row.cin"
"$program" "$folder/row.cin" >"$folder/output" 2>&1 &
process=$!
wait_for 30 xdotool search --onlyvisible --name 'row.cin.*Mesecina' || fail "no window with the file's name: $(cat "$folder/output")"
window=$(xdotool search --onlyvisible --name 'row.cin.*Mesecina' | head -n 1)
xdotool windowfocus --sync "$window"
eval "$(xdotool getwindowgeometry --shell "$window")"
x=$((X + WIDTH / 2))
y=$((Y + HEIGHT / 2))

# covered: how many pixels in the middle of the window are not white.
covered() {
  import -window root -crop 400x400+$((x - 200))+$((y - 200)) png:- |
    convert - -fill black +opaque white -format '%[fx:round((1-mean)*160000)]' info:
}
is_covered() { [ "$(covered)" -gt 8000 ]; }
changes_from() { [ "$(covered)" -ne "$1" ]; }
is_still() {
  local before
  before=$(covered)
  sleep 0.4
  [ "$(covered)" -eq "$before" ]
}
settled() {
  wait_for 20 is_still || fail "the picture does not come to rest"
  covered
}

wait_for 30 is_covered || fail "nothing is drawn: $(covered) pixels"
from_front=$(settled)

drag() {
  xdotool mousemove "$1" "$2" mousedown "$5"
  for step in 1 2 3 4; do
    xdotool mousemove $(($1 + ($3 - $1) * step / 4)) $(($2 + ($4 - $2) * step / 4))
    sleep 0.05
  done
  xdotool mouseup "$5"
}

drag "$x" "$y" $((x + 150)) "$y" 1
wait_for 20 changes_from "$from_front" || fail "a drag turns nothing"
turned=$(settled)

xdotool mousemove "$x" "$y" click 4 click 4 click 4
wait_for 20 changes_from "$turned" || fail "the wheel does not zoom"
[ "$(settled)" -gt "$turned" ] || fail "the wheel does not enlarge"

xdotool key --delay 30 0
seen_first() { [ "$(covered)" -eq "$from_front" ]; }
wait_for 20 seen_first || fail "0 does not go back to the first view: $(covered) pixels, $from_front at first"

xdotool key --delay 30 alt+h
wait_for 20 changes_from "$from_front" || fail "Alt+H shows no other layers"
xdotool key --delay 30 ctrl+z
wait_for 20 seen_first || fail "undo does not hide the layers again"

# Half of each ball is left, filled where it is cut; the view before has no plane.
xdotool key --delay 30 shift+x
wait_for 20 changes_from "$from_front" || fail "a cutting plane changes nothing"
[ "$(settled)" -lt "$from_front" ] || fail "a cutting plane takes nothing away"
xdotool key --delay 30 BackSpace
wait_for 20 seen_first || fail "the previous view is another: $(covered) pixels, $from_front at first"

xdotool key --delay 30 ctrl+q
wait_for 20 sh -c "! kill -0 $process" || fail "Ctrl+Q does not close the window"
code=0
wait "$process" || code=$?
process=
[ "$code" -eq 0 ] || fail "exit code $code: $(cat "$folder/output")"
