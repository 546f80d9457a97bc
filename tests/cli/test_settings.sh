#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What --set changes, and that locales change nothing.
. "$(dirname "$0")/common.sh" "$@"
giraffe=$examples/giraffe.wkt
size_of() { jq '.segments | length' "$1"; }

succeed --nogui "$giraffe" --layers scale-medial-axis,one-step-crust --output low --set scale-limit=1.05
succeed --nogui "$giraffe" --layers scale-medial-axis,one-step-crust --output high --set scale-limit=1.5
expect_json low/giraffe.scale-medial-axis.json '.[0].settings["scale-limit"] == 1.05'
[ "$(size_of low/giraffe.scale-medial-axis.json)" -gt "$(size_of high/giraffe.scale-medial-axis.json)" ] ||
  fail "expected fewer segments at the higher limit"
[ "$(size_of low/giraffe.one-step-crust.json)" -eq "$(size_of high/giraffe.one-step-crust.json)" ] ||
  fail "expected the limit to leave the crust alone"

# Repeatable, and the last one of the same setting counts.
succeed --nogui "$giraffe" --layers angle-medial-axis --output several --set angle-limit=10 \
  --set topology-preserving=false --set angle-limit=90
expect_json several/giraffe.angle-medial-axis.json \
  '.[0] | .settings["angle-limit"] == 90 and .settings["topology-preserving"] == false
   and (.values.angle | min) >= 90'

# A coarser sampling of the outline has fewer samples.
succeed --nogui "$giraffe" --layers one-step-crust --output coarse --set sampling-step=0
succeed --nogui "$giraffe" --layers one-step-crust --output fine --set sampling-step=0.001
[ "$(jq '.vertices | length' fine/giraffe.one-step-crust.json)" -gt \
  "$(jq '.vertices | length' coarse/giraffe.one-step-crust.json)" ] || fail "expected more samples"

if locale -a | grep -qix 'de_DE\.utf-\?8'; then
  export LC_ALL=de_DE.UTF-8
  [ "$(printf '%.1f' 2>/dev/null)" = "0,0" ] || fail "expected a locale with decimal commas"
  succeed --nogui "$giraffe" --layers scale-medial-axis,one-step-crust --output comma --set scale-limit=1.05 \
    --formats json,svg,csv,obj,ply --stats comma.jsonl
  unset LC_ALL
  succeed --nogui "$giraffe" --layers scale-medial-axis,one-step-crust --output point --set scale-limit=1.05 \
    --formats json,svg,csv,obj,ply
  grep -qE '^[^,]*,done,,[0-9.e-]+,' comma/summary.csv || fail "expected a decimal point in the summary"
  rm -r comma/summary.csv {comma,point}/.mesecina
  expect_same comma point
  expect_json comma.jsonl '.[0].seconds.total >= 0'
else
  echo "no de_DE.UTF-8 locale here: decimal commas are not tried"
fi
