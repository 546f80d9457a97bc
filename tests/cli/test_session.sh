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
