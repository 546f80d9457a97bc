#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# --resume: what is complete is left alone, all else is computed.
. "$(dirname "$0")/common.sh" "$@"
write_ellipse first.xy
write_ellipse second.xy 300
arguments=(--nogui first.xy second.xy --layers one-step-crust,medial-axis --formats json,svg --resume)
identity() { stat -c '%n %i %y' out/*; }

run "${arguments[@]}"
expect_status 0
cp -r out complete
identity >before
run "${arguments[@]}"
expect_status 0
identity >after
cmp -s before after || fail "expected complete results to be left alone"

# One file is missing: its input is computed again, the other is not.
rm out/second.medial-axis.json
run "${arguments[@]}"
expect_status 0
expect_same complete out
identity | grep ' *out/first\.' >after
grep ' *out/first\.' before | cmp -s - after || fail "expected the results of the other input to be left alone"

# Another setting, another layer, a changed input: all make the results incomplete.
identity >before
run "${arguments[@]}" --set sampling-step=0.01
expect_status 0
identity >after
! cmp -s before after || fail "expected results of another setting to be computed"
cp after before
run "${arguments[@]}" --set sampling-step=0.01 --layers points
expect_status 0
expect_file out/first.points.json
run "${arguments[@]}"
write_ellipse first.xy 250
run "${arguments[@]}"
expect_status 0
expect_json out/first.one-step-crust.json '.[0].segments | length == 250'

# A failed input is tried again.
printf '0 0\nbroken\n' >second.xy
run "${arguments[@]}"
expect_status 1
write_ellipse second.xy 120
run "${arguments[@]}"
expect_status 0
expect_json out/second.one-step-crust.json '.[0].segments | length == 120'

# Without --resume everything is written anew.
identity >before
run --nogui first.xy second.xy --layers one-step-crust,medial-axis --formats json,svg
expect_status 0
identity >after
! cmp -s before after || fail "expected all to be written anew"

# Results of one setting, then a run of another that does not come to its end: what lies there is not complete.
run "${arguments[@]}"
expect_status 0
rm -rf out/second.medial-axis.json && mkdir out/second.medial-axis.json
run "${arguments[@]}" --set sampling-step=0.02
expect_status 1
rmdir out/second.medial-axis.json
cp out/second.one-step-crust.json out/second.medial-axis.json
run "${arguments[@]}"
expect_status 0
expect_json out/second.medial-axis.json '.[0].layer == "medial-axis"'
