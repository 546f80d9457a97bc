#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# --stats: one JSON object per input and line, in the order of the inputs.
. "$(dirname "$0")/common.sh" "$@"
write_ellipse ellipse.xy
printf '0 0\n1 0\n1 0\n0 1\n' >duplicate.xy
inputs=(ellipse.xy "$examples/italy.wkt" missing.xy duplicate.xy "$examples/switzerland.wkt")

for jobs in 1 3; do
  run --nogui "${inputs[@]}" --layers points,one-step-crust,medial-axis --stats stats.jsonl --jobs $jobs \
    --output out$jobs
  expect_status 1
  expect_lines stats.jsonl ${#inputs[@]}
  while IFS= read -r line; do
    jq -e 'type == "object"' <<<"$line" >/dev/null || fail "expected a JSON object: $line"
  done <stats.jsonl
  [ "$(jq -r .input stats.jsonl)" = "$(printf '%s\n' "${inputs[@]}")" ] || fail "expected the order of the inputs"
done

expect_json stats.jsonl 'map(.status) == ["ok", "ok", "failed", "ok", "ok"]'
expect_json stats.jsonl 'all(.[]; (.input | type) == "string" and (.seconds.total | type) == "number"
  and .seconds.total >= 0 and .peak_rss_bytes > 1000000 and (.counts | type) == "object"
  and (.layers | type) == "object" and (.warnings | type) == "array")'
expect_json stats.jsonl '[.[] | select(.status == "failed")] | all(.reason | length > 0)'
expect_json stats.jsonl '[.[] | select(.status == "ok")] | all((.seconds | keys | length) > 2)'
expect_json stats.jsonl '.[0].counts.points == 200'
expect_json stats.jsonl '.[1].counts.rings == 31'

# Topology of what is a complex: a closed curve, and a tree.
expect_json stats.jsonl '.[0].layers["one-step-crust"]
  | .vertices == 200 and .segments == 200 and .euler == 0 and .betti == [1, 1, 0]'
expect_json stats.jsonl '.[0].layers["medial-axis"] | .euler == 1 and .betti == [1, 0, 0]'
# Why a layer is missing, and what was odd.
expect_json stats.jsonl '.[1].layers.points.reason | length > 0'
expect_json stats.jsonl '.[3].warnings | map(select(test("1 of 4"))) | length == 1'

succeed --nogui ellipse.xy --output unnamed --stats
expect_json unnamed/stats.jsonl 'length == 1 and .[0].input == "ellipse.xy"'

# Memory is that of the input, not of a larger one before it.
if [ -w /proc/self/clear_refs ]; then
  write_ellipse large.xy 60000
  succeed --nogui large.xy ellipse.xy --layers voronoi --stats memory.jsonl --output memory
  expect_json memory.jsonl '.[1].peak_rss_bytes < .[0].peak_rss_bytes * 0.8'
fi

run --nogui ellipse.xy --stats no/such/folder.jsonl --output out9
[ "$status" -ne 0 ] && [ "$status" -lt 126 ] || fail "expected a failure, and no crash"
expect_in stderr "no/such/folder.jsonl"
