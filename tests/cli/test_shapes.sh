#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every planar shape of the folder $MESECINA_DATA: computed, or refused with a reason, and the same bytes every time.
. "$(dirname "$0")/common.sh" "$@"
if [ ! -d "${MESECINA_DATA-}/2d" ]; then
  echo "skipped: MESECINA_DATA names no folder with 2d shapes"
  exit 77
fi
shopt -s nullglob
inputs=("$MESECINA_DATA"/2d/*.{wkt,xy})
[ ${#inputs[@]} -gt 0 ] || fail "expected shapes in $MESECINA_DATA/2d"

compute() {
  run --nogui "${inputs[@]}" --set scale=1.3 --formats json,svg \
    --layers one-step-crust,medial-axis,scale-medial-axis,dual,dual-faces,union-boundary,union-medial-axis,scale-axis,scale-axis-disks \
    "$@"
}
compute --output first --threads 1 --stats stats.jsonl
expect_lines stats.jsonl ${#inputs[@]}
expect_json stats.jsonl 'all(.[]; .status == "ok" or (.status == "failed" and (.reason | length) > 0))'
if jq -es 'all(.[]; .status == "ok")' stats.jsonl >/dev/null; then expect_status 0; else expect_status 1; fi

while IFS=$'\t' read -r input state; do
  stem=$(basename "${input%.*}")
  for name in one-step-crust.json medial-axis.json scale-medial-axis.json union-medial-axis.json scale-axis.json svg; do
    if [ "$state" = ok ]; then expect_file "first/$stem.$name"; else expect_no_file "first/$stem.$name"; fi
  done
done < <(jq -r '[.input, .status] | @tsv' stats.jsonl)
[ "$(jq -s 'map(select(.status == "ok")) | length' stats.jsonl)" -ge $((${#inputs[@]} - 1)) ] ||
  fail "expected all shapes but the one that is broken on purpose"

# The medial axis of a union has the topology of its dual complex, and so have its boundary curves: one around each
# component and one in each hole.
expect_json stats.jsonl 'map(select(.status == "ok").layers) | all(.[]; .["union-medial-axis"].betti == .dual.betti)'
expect_json stats.jsonl \
  'map(select(.status == "ok").layers) | all(.[]; .["union-boundary"].betti[0] == .dual.betti[0] + .dual.betti[1])'

compute --output second --threads 2 --jobs 2
# Records and the summary have the times.
expect_same first second --exclude=.mesecina --exclude=summary.csv
