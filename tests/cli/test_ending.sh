#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A window that is told to end by a signal keeps its scene and ends well; the next one goes on there and offers nothing.
. "$(dirname "$0")/common.sh" "$@"
export QT_QPA_PLATFORM=offscreen HOME=$work XDG_DATA_HOME=$work/data XDG_CONFIG_HOME=$work/config XDG_RUNTIME_DIR=$work/run
mkdir -m 700 run
scenes=$work/data/mesecina/mesecina2d/scenes
printf '0 0\n100 0\n100 60\n0 60\n40 33.3\n' >points.xy

# begin TITLE ARGUMENT...: a window, until its scene is on the disk.
begin() {
  local title=$1
  shift
  command_line=$*
  "$program" "$@" >stdout 2>stderr &
  process=$!
  for _ in $(seq 600); do
    if cat "$scenes"/running/*/scene.json 2>/dev/null | grep -qF "\"$title\""; then return; fi
    sleep 0.1
  done
  fail "expected a scene '$title' on the disk"
}
# end_by SIGNAL STATUS
end_by() {
  kill -s "$1" "$process"
  status=0
  wait "$process" || status=$?
  expect_status "$2"
}
count() { find "$scenes/$1" -name scene.json 2>/dev/null | wc -l; }

begin points.xy points.xy
end_by TERM 0
[ "$(count kept)" -eq 1 ] && [ "$(count running)" -eq 0 ] || fail "expected a scene that is kept"
for signal in INT HUP; do
  # Begins as it was left, and is still one scene.
  begin points.xy
  end_by $signal 0
  [ "$(count kept)" -eq 1 ] && [ "$(count running)" -eq 0 ] || fail "expected one scene that is kept after $signal"
done
# What is killed is not kept, but there to be offered; and that is not what a scene looks like that was ended well.
begin points.xy
end_by KILL 137
[ "$(count running)" -eq 1 ] || fail "expected a scene that can be recovered"

# A script that does not come to its end has failed; it leaves no scene.
echo 'wait' >script.txt
mkfifo pipe
"$program" points.xy --script pipe >stdout 2>stderr &
process=$!
exec 3>pipe
echo wait >&3
sleep 1
kill -s TERM "$process"
exec 3>&-
status=0
wait "$process" || status=$?
[ "$status" -eq 130 ] || [ "$status" -eq 143 ] || fail "expected 130 or, before there is a window, 143; found $status"
