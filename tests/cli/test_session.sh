#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# --session gives what the same run spelled out gives, other options win over it, and damaged ones are told.
. "$(dirname "$0")/common.sh" "$@"

printf '0 0\n100 0\n100 60\n0 60\n40 33.3\n' >points.xy
cat >scene.mesecina <<'END'
{
 "format": "mesecina-session", "version": 1, "dimension": 2, "title": "points.xy",
 "settings": {"lambda-limit": 2.5, "later": 3},
 "layers": [
  {"id": "voronoi", "visible": true, "style": {"color": "#ff0000", "line-width": 3}},
  {"id": "delaunay", "visible": false, "style": {"line-width": 7}},
  {"id": "points", "visible": true, "style": {"point-size": 9}}
 ],
 "view": {"center": [50, 30], "scale": 5, "size": [600, 450]},
 "inputs": {"points": [0,0, 100,0, 100,60, 0,60, 40,33.3]}
}
END
echo '{"center": [50, 30], "scale": 10}' >view.json

succeed --nogui --session scene.mesecina --formats svg,json --output session
mkdir same && cp points.xy same/scene.xy
succeed --nogui same/scene.xy --layers voronoi,points --as-listed --set lambda-limit=2.5 --style voronoi.color=#ff0000 \
  --style voronoi.line-width=3 --style points.point-size=9 --view view.json --formats svg,json --output spelled
expect_same session/scene.svg spelled/scene.svg
for layer in voronoi points; do
  expect_same <(jq 'del(.input)' session/scene.$layer.json) <(jq 'del(.input)' spelled/scene.$layer.json)
done
expect_no_file session/scene.delaunay.json

# Other options win, and other files are seen in the same way.
succeed --nogui --session scene.mesecina --layers delaunay --style delaunay.color=#00ff00 --set lambda-limit=1 \
  --formats json,svg --output other
expect_file other/scene.delaunay.json
expect_no_file other/scene.voronoi.json
expect_json other/scene.delaunay.json '.[0].settings["lambda-limit"] == 1'
expect_in other/scene.svg '#00ff00'
expect_in other/scene.svg 'stroke-width="7"'
succeed --nogui points.xy --session scene.mesecina --formats svg --output files
expect_file files/points.svg
expect_no_file files/scene.svg
sed 's/points.xy/scene.xy/' files/points.svg >files/renamed.svg
expect_same files/renamed.svg session/scene.svg

# A session is also a file of data.
succeed --nogui scene.mesecina --layers points --output data
expect_json data/scene.points.json '.[0].points | length == 5'

run --nogui --session missing.mesecina
expect_status 2
expect_in stderr 'missing.mesecina'
head -c 300 scene.mesecina >cut.mesecina
run --nogui --session cut.mesecina
expect_status 2
expect_in stderr 'damaged or cut off'
sed 's/"dimension": 2/"dimension": 3/' scene.mesecina >space.mesecina
run --nogui --session space.mesecina
expect_status 2
expect_in stderr 'open it with that program'
run --nogui cut.mesecina
expect_status 1
expect_in stderr 'cut.mesecina'

# What a session says that this program does not know is told, also where the data come from another file.
for from in scene.mesecina "points.xy --session scene.mesecina"; do
  # shellcheck disable=SC2086
  succeed --nogui $from --layers points
  expect_in stderr "there is no setting 'later'"
  expect_lines stderr 1
done
# Lists within lists are no way to exhaust the stack.
deep=$(printf '%200000s' '' | tr ' ' '[')
echo "{\"format\": \"mesecina-session\", \"version\": 1, \"dimension\": 2, \"later\": $deep$(echo "$deep" | tr '[' ']')}" >deep.mesecina
run --nogui --session deep.mesecina
expect_status 2
expect_in stderr 'at most 500 lists'
run --nogui deep.mesecina
expect_status 1
expect_in stderr 'at most 500 lists'
# A name that is empty, as of a variable that is not set, is not the same as none.
run --nogui points.xy --session ""
expect_status 2
expect_in stderr '--session'

# With --record a film is what the session says, where the command line says nothing.
film_session() {  # film_session SOURCE
  jq --arg source "$1" '. + {"bundle": {"name": "Mine", "changed": true}, "recording": {"source": $source, "size": [64, 48],
    "frames-per-second": 5, "transparent": true, "sweeps": ["lambda-limit=0:9:4"]},
    "evolution": {"position": 1, "made-by": [], "steps": [
      {"evolution": "", "number": 0, "settings": {}, "inputs": {"points": [0,0, 100,0, 100,60, 0,60, 20,20]}},
      {"evolution": "smoothing", "number": 1, "settings": {}, "inputs": {"points": {"same-as": "inputs"}}},
      {"evolution": "smoothing", "number": 2, "settings": {}, "inputs": {"points": [0,0, 100,0, 100,60, 0,60, 60,40]}}]}}' \
    scene.mesecina >"$1.mesecina"
}
film_session animation
film_session evolution
film_session changes
succeed --nogui --session animation.mesecina --record sweep/%02d.png
[ "$(ls sweep | wc -l)" -eq 4 ] || fail "expected 4 frames"
[ "$(head -c 24 sweep/01.png | od -An -tu1 -j16 | tr -s ' ')" = " 0 0 0 64 0 0 0 48" ] || fail "expected 64 x 48 pixels"
succeed --nogui --session evolution.mesecina --record steps/%02d.png --size 80x60
[ "$(ls steps | wc -l)" -eq 3 ] || fail "expected 3 frames"
[ "$(head -c 24 steps/01.png | od -An -tu1 -j16 | tr -s ' ')" = " 0 0 0 80 0 0 0 60" ] || fail "expected 80 x 60 pixels"
for frame in 01 02 03; do
  for other in 01 02 03; do [ $frame = $other ] || expect_different steps/$frame.png steps/$other.png; done
done
succeed --nogui --session evolution.mesecina --record swept/%02d.png --sweep lambda-limit=0:9:6
[ "$(ls swept | wc -l)" -eq 6 ] || fail "expected 6 frames"
run --nogui --session changes.mesecina --record none/%02d.png
expect_status 2
expect_in stderr 'nothing moves'
run --nogui points.xy --session evolution.mesecina --record none/%02d.png
expect_status 2
expect_in stderr 'nothing moves'

# Where no layer is visible there is nothing to write, which nobody means; statistics have the counts all the same.
jq '.layers[].visible = false' scene.mesecina >hidden.mesecina
run --nogui --session hidden.mesecina --formats svg --output hidden
expect_status 2
expect_in stderr 'hidden.mesecina: no layer is visible there'
expect_in stderr '--layers'
expect_no_file hidden
succeed --nogui --session hidden.mesecina --stats hidden.jsonl --formats json --output hidden
expect_in stderr 'no layer is visible there'
expect_json hidden.jsonl '.[0].counts.points == 5 and (.[0].layers | length == 0)'
succeed --nogui --session hidden.mesecina --layers points --formats json --output hidden
expect_file hidden/hidden.points.json
expect_not_in stderr 'no layer is visible'
