#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# --evolve: steps that inputs go before layers are computed.
. "$(dirname "$0")/common.sh" "$@"
giraffe=$examples/giraffe.wkt
length_of() { jq '.vertices as $v | [$v, $v[1:] + $v[:1]] | transpose | map(((.[0][0] - .[1][0]) as $x
  | (.[0][1] - .[1][1]) as $y | $x * $x + $y * $y) | sqrt) | add' "$1"; }
longer() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a > b) }'; }

succeed --list evolutions
expect_in stdout "laplacian-smoothing     Needs points along a curve, or an outline."
succeed --list evolutions --json
expect_json stdout '.[0] | all(.[]; (.id | test("^[a-z0-9-]+$")) and .label != "" and (.help | length) > 20
  and (.needs | length) > 4)'
expect_json stdout '.[0] | map(select(.id == "lloyd")) | .[0].needs == "points"'

succeed --nogui "$giraffe" --layers outline --output plain --stats
succeed --nogui "$giraffe" --layers outline --output five --evolve laplacian-smoothing=5 --stats
longer "$(length_of plain/giraffe.outline.json)" "$(length_of five/giraffe.outline.json)" ||
  fail "expected the outline to be shorter when smooth"
expect_json plain/stats.jsonl '.[0] | has("evolutions") | not'
expect_json five/stats.jsonl '.[0].evolutions | length == 1 and .[0].id == "laplacian-smoothing"
  and .[0].steps == 5 and .[0].seconds >= 0 and (.[0] | has("reason") | not)'

# Twice some steps are their sum, bytes and all; on several inputs and jobs as well.
succeed --nogui "$giraffe" --layers outline,scale-axis --output five --evolve laplacian-smoothing=5 --formats json,svg
succeed --nogui "$giraffe" "$examples/italy.wkt" --layers outline,scale-axis --output again --jobs 2 \
  --evolve laplacian-smoothing=2 --evolve laplacian-smoothing=3 --formats json,svg
rm -r again/italy.* {five,again}/.mesecina five/stats.jsonl five/summary.csv
expect_same five again

# Every evolution goes steps on an outline or on points, the same ones whatever the threads are.
write_ellipse ellipse.xy 150
for id in $("$program" --list evolutions --json | jq -r '.[].id'); do
  for threads in 1 3; do
    succeed --nogui "$giraffe" ellipse.xy --layers outline,points,disks,landmarks,landmark-disks --evolve $id=3 \
      --threads $threads --output all-$threads --stats
    expect_json all-$threads/stats.jsonl 'map(.evolutions[0].steps) | max == 3 and last == 3'
    rm -r all-$threads/stats.jsonl all-$threads/summary.csv all-$threads/.mesecina
  done
  expect_same all-1 all-3
done

# Steps that cannot be gone are told; what was reached is written.
printf '0 0\n5 5\n' >two.xy
succeed --nogui two.xy --layers points --output short --evolve laplacian-smoothing=5 --stats
expect_in stderr "evolution laplacian-smoothing: 0 of 5 steps: no point has exactly two neighbours"
expect_json short/stats.jsonl '.[0].evolutions[0] | .steps == 0 and (.reason | length > 0)'
expect_json short/two.points.json '.[0].points | length == 2'

printf 'WPOFF 2 0 0\n0 0 4\n3 0 4\n' >two.poff
succeed --nogui two.poff --layers disks --output unfit --evolve laplacian-smoothing=2 --evolve grow-balls=3 --stats
expect_in stderr "evolution laplacian-smoothing: 0 of 2 steps: there is no curve"
expect_json unfit/stats.jsonl '.[0].evolutions | map(.steps) == [0, 3]'

# What --resume finds of another number of steps is not what is asked for.
succeed --nogui "$giraffe" --layers outline --output resumed --resume --evolve laplacian-smoothing=1 --log info
succeed --nogui "$giraffe" --layers outline --output resumed --resume --evolve laplacian-smoothing=1 --log info
expect_in stderr "skipped"
succeed --nogui "$giraffe" --layers outline --output resumed --resume --evolve laplacian-smoothing=2 --log info
expect_not_in stderr "skipped"

run --nogui "$giraffe" --evolve laplacian-smooting=5
expect_status 2
expect_in stderr "did you mean 'laplacian-smoothing'?"
run --nogui "$giraffe" --evolve laplacian-smoothing
expect_status 2
expect_in stderr "ID=STEPS"
