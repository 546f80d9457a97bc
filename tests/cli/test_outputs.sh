#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Names and contents of what is written, in every format.
. "$(dirname "$0")/common.sh" "$@"
write_ellipse ellipse.xy

# By default: JSON of the layers that are visible at first, into ./out.
succeed --nogui ellipse.xy
ls out/ellipse.*.json >/dev/null || fail "expected JSON files in ./out"

# Every layer writer and every picture format that the program says it has.
succeed --list formats --json
layer_extensions=$(jq -r '.[] | select(.use == "write layers") | .extensions[]' stdout)
picture_extensions=$(jq -r '.[] | select(.use == "write pictures") | .extensions[]' stdout)
formats=$(jq -r '[.[] | select(.use != "read").name] | join(",")' stdout)
succeed --nogui ellipse.xy "$examples/giraffe.wkt" --layers one-step-crust,medial-axis --formats "$formats" \
  --size 400x300 --output results
for stem in ellipse giraffe; do
  for layer in one-step-crust medial-axis; do
    for extension in $layer_extensions; do expect_file "results/$stem.$layer.$extension"; done
  done
  for extension in $picture_extensions; do expect_file "results/$stem.$extension"; done
done
[ "$(find results -type f -not -path '*/.*' | wc -l)" -eq \
  $((2 * (2 * $(wc -w <<<"$layer_extensions") + $(wc -w <<<"$picture_extensions")))) ] || fail "expected no other files"

# JSON: the promised members, and numbers that fit together.
crust=results/ellipse.one-step-crust.json
expect_json $crust '.[0] | .format == "mesecina-layer" and .version == 1 and .layer == "one-step-crust"
  and .dimension == 2 and .input == "ellipse.xy" and .settings["scale-limit"] == 1.1'
expect_json $crust '.[0] | (.segments | length) == 200 and (.vertices | length) == 200
  and ([.segments[][]] | min == 0 and max == 199 and (group_by(.) | all(length == 2)))'
expect_json $crust '.[0].vertices | map(length) | unique == [2]'
succeed --nogui ellipse.xy --layers scale-medial-axis --output results
expect_json results/ellipse.scale-medial-axis.json '.[0] | (.segments | length) as $n
  | $n > 0 and (.values.scale | length) == $n + (.points // [] | length)'

# Coordinates come back as they were given.
printf '0.1 0.2\n1e-300 3\n-4 12345678901234567\n' >exact.xy
succeed --nogui exact.xy --layers points --output results
expect_json results/exact.points.json '.[0].vertices == [[0.1, 0.2], [1e-300, 3], [-4, 12345678901234567]]'

# A layer that cannot be computed is written with its reason, and the others with their content.
printf '0 0\n1 1\n2 2\n' >line.xy
run --nogui line.xy --layers points,medial-axis --output results
expect_status 0
expect_json results/line.points.json '.[0].points | length == 3'
expect_json results/line.medial-axis.json '.[0].reason | length > 10'

# Pictures: what they claim to be, of the size asked for.
[ "$(identify -format '%m %w %h' results/giraffe.png)" = "PNG 400 300" ] || fail "expected a PNG of 400 x 300"
pdfinfo results/giraffe.pdf | grep -qE '^Pages: +1$' || fail "expected a PDF of one page"
rsvg-convert results/giraffe.svg -o giraffe_svg.png || fail "expected an SVG that others can read"
[ "$(identify -format '%w %h' giraffe_svg.png)" = "400 300" ] || fail "expected an SVG of 400 x 300"
expect_in results/giraffe.svg 'inkscape:groupmode="layer"'
expect_in results/giraffe.svg '>'
for picture in results/giraffe.png giraffe_svg.png; do
  [ "$(identify -format '%k' $picture)" -gt 2 ] || fail "expected something drawn in $picture"
done

# Every layer there is, on a file of each kind.
succeed --list layers --json
layers=$(jq -r 'map(.id) | join(",")' stdout)
run --nogui ellipse.xy "$examples/giraffe.wkt" --layers "$layers" --output all
expect_status 0
for layer in ${layers//,/ }; do
  for stem in ellipse giraffe; do
    expect_json all/$stem.$layer.json ".[0] | .layer == \"$layer\" and (has(\"reason\") or (.vertices | length) >= 0)"
  done
done
