#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# mesecina3d without a window: from meshes and balls to the scale axis, in files.
. "$(dirname "$0")/common.sh" "$@"

# A torus with a bent circle, as OBJ.
write_torus() {  # write_torus FILE
  awk 'BEGIN { n = 40; m = 16; turn = 8 * atan2(1, 1)
    for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
      u = turn * i / n; v = turn * j / m; r = 1 + 0.4 * cos(v)
      print "v", r * cos(u), r * sin(u), 0.4 * sin(v) + 0.06 * cos(2 * u) }
    for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
      a = i * m + j; b = (i + 1) % n * m + j; c = (i + 1) % n * m + (j + 1) % m; d = i * m + (j + 1) % m
      print "f", a + 1, b + 1, c + 1, d + 1 } }' >"$1"
}
write_torus torus.obj
layers=balls,dual,medial-axis,scale-axis,scale-axis-balls
settings=(--set delta=0.03 --set scale=1.1)

succeed --nogui torus.obj --layers $layers "${settings[@]}" --formats json,ply,ma --stats --output results
for layer in ${layers//,/ }; do
  for extension in json ply ma; do [ "$layer.$extension" = dual.ma ] || expect_file results/torus.$layer.$extension; done
done
# One tunnel, at every stage.
expect_json results/stats.jsonl '.[0] | .status == "ok" and .notes.repair == "none" and .counts.triangles == 1280'
for layer in dual medial-axis scale-axis; do
  expect_json results/stats.jsonl ".[0].layers[\"$layer\"] | .euler == 0 and .betti == [1, 1, 0]"
done
expect_json results/torus.medial-axis.json '.[0] | .dimension == 3 and (.polygons | length) > 100
  and (.radii | length) == (.vertices | length) and (.points | length) == (.vertices | length)
  and (.points | length) - (.segments | length) + (.polygons | length) == 0
  and ([.values.angle, .values.lambda, .values.scale, .values.sheet | length] | unique)
    == [(.points | length) + (.segments | length) + (.polygons | length)]'

# The same bytes whatever the threads are; the balls that were written are read back and give the same union.
succeed --nogui torus.obj --layers $layers "${settings[@]}" --formats json,ply,ma --threads 1 --output one
succeed --nogui torus.obj --layers $layers "${settings[@]}" --formats json,ply,ma --threads 2 --output two
rm -r one/.mesecina two/.mesecina
expect_same one two
succeed --nogui torus.obj --layers balls --set delta=0.03 --formats woff --output again
succeed --nogui again/torus.balls.woff --layers dual --stats --output again
expect_json again/stats.jsonl '.[0].layers.dual.betti == [1, 1, 0]'

# Limits of the medial axis are applied in files and in statistics; what is left is a complex, and is read again.
filtered=lambda-medial-axis,angle-medial-axis,scale-medial-axis
succeed --nogui torus.obj --layers $filtered,medial-axis,medial-contacts --set delta=0.06 --set lambda-limit=0.3 \
  --set angle-limit=120 --set scale-limit=1.2 --formats json,csv,ply,ma --stats --output cut
for name in lambda:0.3 angle:120 scale:1.2; do
  layer=${name%%:*}-medial-axis
  expect_json cut/torus.$layer.json ".[0] | (.values.${name%%:*} | map(if . == \"inf\" then 1e9 else . end) | min) >= ${name#*:}
    and (.points | length) == (.vertices | length)
    and ([.polygons[] | . + .[:1] | range(length - 1) as \$i | .[\$i:\$i + 2] | sort] | unique | length) <= (.segments | length)"
  expect_json cut/stats.jsonl ".[0].layers | .[\"$layer\"].polygons > 0 and .[\"$layer\"].polygons < .[\"medial-axis\"].polygons
    and (.[\"$layer\"].betti | length) == 3"
  expect_lines cut/torus.$layer.csv $((1 + $(jq '(.points | length) + (.segments | length) + (.polygons | length)' cut/torus.$layer.json)))
  cp cut/torus.$layer.ply $layer-mesh.ply
  cp cut/torus.$layer.ma $layer-balls.ma
  succeed --nogui $layer-mesh.ply $layer-balls.ma --layers mesh,balls --stats --output opened
  balls=$(jq '.vertices | length' cut/torus.$layer.json)
  expect_json opened/stats.jsonl "map(select(.input == \"$layer-balls.ma\"))[0].layers.balls.balls == $balls"
  expect_json opened/stats.jsonl "map(select(.input == \"$layer-mesh.ply\"))[0].layers.mesh.vertices == $balls"
done
expect_json cut/torus.medial-contacts.json \
  ".[0] | (.segments | length) == $(jq '.polygons | length' cut/torus.medial-axis.json) and .values[\"to-ball-2\"] != null"

# Balls of a few kinds.
printf '0 0 0 1\n' >one.cin
printf '0 0 0 1\n3 0 0 1\n' >apart.cin
printf '0 0 0 1\n2 0 0 1\n' >touching.cin
printf '0 0 0 2\n0.5 0 0 1\n' >nested.cin
printf '0 0 0 1\n0 0 0 1\n' >equal.cin
awk 'BEGIN { for (i = 0; i < 12; ++i) print 4 * cos(i * 0.5235987755983), 4 * sin(i * 0.5235987755983), 0, 1.2 }' >ring.cin
succeed --nogui one.cin apart.cin touching.cin nested.cin equal.cin ring.cin --layers dual,medial-axis --stats --output sets
for expected in one:1,0,0 apart:2,0,0 touching:1,0,0 nested:1,0,0 equal:1,0,0 ring:1,1,0; do
  for layer in dual medial-axis; do
    expect_json sets/stats.jsonl "map(select(.input == \"${expected%%:*}.cin\"))[0].layers[\"$layer\"].betti == [${expected#*:}]"
  done
done

# Bad files are told in one line each, and hurt no other.
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' >short.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >index.off
printf 'solid nothing\n' >empty.stl
printf '0 0 0 -1\n' >negative.cin
run --nogui short.off torus.obj index.off empty.stl negative.cin --layers balls --set delta=0.05 --stats --output bad
expect_status 1
expect_json bad/stats.jsonl 'map(.status) == ["failed", "ok", "failed", "failed", "failed"]'
expect_json bad/stats.jsonl 'map(select(.status == "failed").reason) | all(test("^[a-z]+\\.[a-z]+:"))'
expect_lines stderr 4
expect_file bad/torus.balls.json

# A mesh with a hole is healed and it is said how; with repair off it is refused with a reason.
head -n -40 torus.obj >open.obj
succeed --nogui open.obj --layers balls "${settings[@]}" --stats --output healed
expect_json healed/stats.jsonl '.[0] | .status == "ok" and (.notes.repair | length) > 3 and .notes.repair != "none"'
run --nogui open.obj --layers balls --set repair=off --stats --output healed
expect_json healed/stats.jsonl '.[0].layers.balls.reason | length > 20'

# A format that holds nothing of a layer gives an empty file, and it is said what there is.
succeed --nogui one.cin torus.obj --layers given-balls,mesh --formats stl,woff --stats --output kinds
expect_in stderr 'one.cin: layer given-balls: stl holds triangles, and there is 1 ball: the file is empty'
expect_in stderr 'torus.obj: layer mesh: woff holds balls, and there are 1280 triangles: the file is empty'
expect_not_in stderr 'layer mesh: stl'
expect_not_in stderr 'layer given-balls: woff'
expect_json kinds/stats.jsonl '.[0].warnings | any(contains("stl holds triangles"))'

# Helps and reasons name settings by their ids.
succeed --list settings
expect_in stdout 'stepped-growing in percent of what they are'
expect_not_in stdout '{'
succeed --list layers --json
expect_json stdout '.[0] | map(.help) | all(contains("{") | not)'
succeed --nogui torus.obj --layers balls --set ball-source=given --stats --formats json --output reasons
expect_in stderr 'choose another ball-source'
expect_json reasons/torus.balls.json '.[0].reason | endswith("choose another ball-source")'

# Only what is not complete is computed again.
succeed --nogui torus.obj --layers $layers "${settings[@]}" --formats json,ply,ma --resume --log info --output results
expect_in stderr 'results are complete; skipped'
