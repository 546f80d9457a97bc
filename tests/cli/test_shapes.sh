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
  run --nogui "${inputs[@]}" --layers one-step-crust,medial-axis,scale-medial-axis --formats json,svg "$@"
}
compute --output first --threads 1 --stats stats.jsonl
expect_lines stats.jsonl ${#inputs[@]}
expect_json stats.jsonl 'all(.[]; .status == "ok" or (.status == "failed" and (.reason | length) > 0))'
if jq -es 'all(.[]; .status == "ok")' stats.jsonl >/dev/null; then expect_status 0; else expect_status 1; fi

while IFS=$'\t' read -r input state; do
  stem=$(basename "${input%.*}")
  for name in one-step-crust.json medial-axis.json scale-medial-axis.json svg; do
    if [ "$state" = ok ]; then expect_file "first/$stem.$name"; else expect_no_file "first/$stem.$name"; fi
  done
done < <(jq -r '[.input, .status] | @tsv' stats.jsonl)
[ "$(jq -s 'map(select(.status == "ok")) | length' stats.jsonl)" -ge $((${#inputs[@]} - 1)) ] ||
  fail "expected all shapes but the one that is broken on purpose"

compute --output second --threads 2 --jobs 2
expect_same first second
