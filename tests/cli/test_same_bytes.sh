#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The same bytes on every run, whatever the number of threads and jobs.
. "$(dirname "$0")/common.sh" "$@"
write_ellipse ellipse.xy 20000
inputs=("$examples/giraffe.wkt" "$examples/italy.wkt" "$examples/noisy_giraffe_0.3pc.xy" ellipse.xy)
arguments=(--nogui --formats json,svg,png,pdf,ply,csv,obj
  --layers delaunay,one-step-crust,medial-axis,lambda-medial-axis,angle-medial-axis,scale-medial-axis-disks)

succeed "${arguments[@]}" "${inputs[@]}" --output first --threads 1
cp stderr first_stderr
succeed "${arguments[@]}" "${inputs[@]}" --output second --threads 1
expect_same first second
succeed "${arguments[@]}" "${inputs[@]}" --output two_threads --threads 2
expect_same first two_threads
cmp -s stderr first_stderr || fail "expected the same warnings"
succeed "${arguments[@]}" "${inputs[@]}" --output jobs --jobs 3
expect_same first jobs

# Neither the order of the inputs nor their company matters.
inputs=(ellipse.xy "$examples/italy.wkt")
succeed "${arguments[@]}" "${inputs[@]}" --output alone
for file in alone/*; do cmp -s "$file" "first/${file#alone/}" || fail "expected $file as in the first run"; done
