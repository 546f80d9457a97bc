#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# --style and --as-listed: the looks and the order of layers in pictures, and nothing else.
. "$(dirname "$0")/common.sh" "$@"
write_ellipse ellipse.xy
giraffe=$examples/giraffe.wkt

# group LAYER FILE: what an SVG file holds of a layer.
group() { sed -n "/<g id=\"layer-$1\"/,/^<\/g>\$/p" "$2" | sed '/<g id=/!{/<g id="layer-/q}' >group; }
# order FILE: the layers of an SVG file, from bottom to top.
order() { grep -oE 'id="layer-[a-z-]+"' "$1" | sed 's/id="layer-//; s/"//' | paste -sd ' '; }

succeed --nogui ellipse.xy --layers medial-axis,one-step-crust,points --formats svg,json --output plain
succeed --nogui ellipse.xy --layers medial-axis,one-step-crust,points --formats svg,json --output styled \
  --style medial-axis.color=#0A64ff --style medial-axis.line-width=4.25 --style medial-axis.opacity=0.5 \
  --style points.color=#f80 --style points.point-size=9
expect_empty stderr
for layer in medial-axis one-step-crust points; do
  expect_same plain/ellipse.$layer.json styled/ellipse.$layer.json
done
group medial-axis styled/ellipse.svg
for text in 'stroke="#0a64ff"' 'stroke-width="4.25"' 'stroke-opacity="0.5"'; do expect_in group "$text"; done
group points styled/ellipse.svg
for text in 'fill="#ff8800"' 'r="4.5"'; do expect_in group "$text"; done
group one-step-crust plain/ellipse.svg
mv group plain_crust
group one-step-crust styled/ellipse.svg
expect_same plain_crust group
expect_different plain/ellipse.svg styled/ellipse.svg

# Filled or not, colours by value with a map and its range, thresholds; the last of two changes counts.
succeed --nogui "$giraffe" --layers outline --formats svg --output filled --style outline.filled=true
expect_in filled/giraffe.svg 'fill-rule="evenodd"'
succeed --nogui "$giraffe" --layers outline --formats svg --output hollow --style outline.filled=true \
  --style outline.filled=false
expect_not_in hollow/giraffe.svg 'fill-rule="evenodd"'
by_value=(--nogui ellipse.xy --layers medial-axis --formats svg --style medial-axis.value=lambda)
succeed "${by_value[@]}" --output by_value
expect_in by_value/ellipse.svg 'id="colour-bars"'
succeed "${by_value[@]}" --output other --style medial-axis.color-map=plasma
expect_different by_value/ellipse.svg other/ellipse.svg
succeed "${by_value[@]}" --output reversed --style medial-axis.color-map-reversed=true
expect_different by_value/ellipse.svg reversed/ellipse.svg
succeed "${by_value[@]}" --output ranged --style medial-axis.range-minimum=-2.5 --style medial-axis.range-maximum=12
expect_different by_value/ellipse.svg ranged/ellipse.svg
succeed "${by_value[@]}" --output above --style medial-axis.threshold-minimum=1e9
group medial-axis above/ellipse.svg
expect_not_in group "<path"
succeed "${by_value[@]}" --output all --style medial-axis.threshold-minimum=1e9 --style medial-axis.threshold-minimum=
expect_same by_value/ellipse.svg all/ellipse.svg

# Values that a layer does not have: its own colour, and a warning that says which it has.
succeed --nogui ellipse.xy --layers medial-axis --formats svg --output unknown --style medial-axis.value=lamda
expect_lines stderr 1
expect_in stderr "layer medial-axis: no values 'lamda'"
expect_in stderr "lambda"

# The order.
[ "$(order plain/ellipse.svg)" = "points one-step-crust medial-axis" ] || fail "expected the order of the registry"
succeed --nogui ellipse.xy --layers medial-axis,one-step-crust,medial-axis,points --formats svg --output listed --as-listed
[ "$(order listed/ellipse.svg)" = "medial-axis one-step-crust points" ] || fail "expected the order given"

# --resume: pictures of another look are not complete.
resumed=(--nogui ellipse.xy --layers medial-axis,points --formats svg --output resumed --resume)
succeed "${resumed[@]}"
cp resumed/ellipse.svg before.svg
succeed "${resumed[@]}" --style points.color=#123456
expect_in resumed/ellipse.svg "#123456"
succeed "${resumed[@]}"
expect_same before.svg resumed/ellipse.svg
succeed "${resumed[@]}" --as-listed
expect_different before.svg resumed/ellipse.svg

# refuse TEXT ARGUMENT...: wrong usage, answered on one line that holds the text; nothing is computed.
refuse() {
  local text=$1
  shift
  run --nogui ellipse.xy --output refused "$@"
  expect_status 2
  expect_empty stdout
  expect_lines stderr 1
  expect_in stderr "$text"
  expect_no_file refused
}
refuse "LAYER.PROPERTY=VALUE" --style points
refuse "LAYER.PROPERTY=VALUE" --style points=3
refuse "LAYER.PROPERTY=VALUE" --style points.color
refuse "did you mean 'medial-axis'" --style medial-axes.color=#000000
refuse "did you mean 'color'" --style points.colour=#000000
refuse "did you mean 'line-width'" --style points.linewidth=3
refuse "did you mean 'viridis'" --style points.color-map=virids
refuse "threshold-maximum" --style points.zzzzzzzzzzzzzz=3
for value in red '#12345' '#gggggg' '#1234567' '' '#-1-1-1' '#+1+1+1'; do refuse "#rrggbb" --style "points.color=$value"; done
for value in 1.5 -0.1 nan 0,5 half ''; do refuse "from 0 to 1" --style "points.opacity=$value"; done
for value in 101 -1 inf wide ''; do
  refuse "from 0 to 100" --style "points.point-size=$value"
  refuse "from 0 to 100" --style "points.line-width=$value"
done
refuse "true or false" --style points.filled=perhaps
refuse "true or false" --style points.color-map-reversed=
refuse "decimal point" --style points.range-minimum=1,5
refuse "decimal point" --style points.threshold-maximum=none
refuse "--layers" --as-listed
