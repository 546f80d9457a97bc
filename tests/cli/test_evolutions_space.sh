#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# --evolve in space: steps that meshes and balls go before layers are computed.
. "$(dirname "$0")/common.sh" "$@"
cat >octahedron.off <<'END'
OFF
6 8 0
1 0 0
-1 0 0
0 1 0
0 -1 0
0 0 1
0 0 -1
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
END
printf 'x,y,z,radius\n0,0,0,2\n2,0,0,1\n' >two.csv

succeed --list evolutions --json
expect_json stdout '.[0] | map(.id) | contains(["laplacian-smoothing", "noise", "grow-balls", "shrink-balls",
  "stepped-growing"])'

# The neighbours of each vertex are around the center: half of the way, twice.
succeed --nogui octahedron.off --layers mesh --evolve laplacian-smoothing=2
expect_json out/octahedron.mesh.json '.[0].vertices | map(map(fabs) | add) | all(.[]; . == 0.25)'

succeed --nogui octahedron.off --layers mesh --evolve noise=3 --seed 4 --output once
succeed --nogui octahedron.off --layers mesh --evolve noise=3 --set evolution-seed=4 --output again
succeed --nogui octahedron.off --layers mesh --evolve noise=3 --output other
cmp once/octahedron.mesh.json again/octahedron.mesh.json || fail "expected --seed to set evolution-seed"
expect_different once/octahedron.mesh.json other/octahedron.mesh.json

succeed --nogui two.csv --layers given-balls,medial-axis --evolve grow-balls=10 --set growing-step=5 --stats
expect_json out/two.given-balls.json '.[0].values.radius == [3, 1.5]'
expect_json out/stats.jsonl '.[0].evolutions == [.[0].evolutions[0]] and .[0].evolutions[0].steps == 10'
succeed --nogui two.csv --layers given-balls --evolve shrink-balls=10 --set growing-step=25 --stats
expect_in stderr "evolution shrink-balls: 3 of 10 steps: the balls have shrunk to nothing"
expect_json out/two.given-balls.json '.[0].values.radius == [0.5, 0.25]'

run --nogui two.csv --evolve grow-ball=10
expect_status 2
expect_in stderr "did you mean 'grow-balls'?"
