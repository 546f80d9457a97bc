#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Many files in one run: the summary, interruptions of all kinds, and what --resume makes of them.
. "$(dirname "$0")/common.sh" "$@"

# write_shape NAME NUMBER: shapes that differ, each some tenths of a second of work.
if [ "$(basename "$program")" = mesecina3d ]; then
  extension=off
  layers=balls,dual,scale-axis
  formats=ply,json
  settings=(--set delta=0.04)
  write_shape() {
    awk -v s="$2" 'BEGIN { n = 60; m = 24; turn = 8 * atan2(1, 1); print "OFF"; print n * m, n * m, 0
      for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
        u = turn * i / n; v = turn * j / m; r = 1 + (0.3 + s / 100) * cos(v)
        print r * cos(u), r * sin(u), 0.4 * sin(v) + 0.06 * cos(2 * u) }
      for (i = 0; i < n; ++i) for (j = 0; j < m; ++j)
        print 4, i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m }' >"$1.$extension"
  }
  extra_columns=repair,error,
  # What follows the time in the row of a good shape: a torus.
  expected_row='^none,0\.[0-9]+,,[0-9]+,,,,[0-9]+,1,1,0,[0-9]+,1,1,0$'
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' >bad.$extension
  printf 'OFF\n1 0 0\n0 0 0\n' >none.$extension
else
  extension=xy
  layers=medial-axis,union-medial-axis,scale-axis
  formats=json,png
  settings=()
  write_shape() {
    awk -v s="$2" 'BEGIN { n = 20000; for (i = 0; i < n; ++i) { a = (i + 0.3 * sin(7 * i)) * 8 * atan2(1, 1) / n
      print (3 + s) * cos(a), sin(a) } }' >"$1.$extension"
  }
  extra_columns=
  expected_row='^,[0-9]+,1,0,0,[0-9]+,1,0,0,[0-9]+,1,0,0$'
  printf '0 0\nbroken\n' >bad.$extension
  printf '0 0\n1 1\n2 2\n' >none.$extension
fi
arguments=(--layers "$layers" --formats "$formats" "${settings[@]}" --stats)
files_per_shape=0
for format in ${formats//,/ }; do
  if [ "$format" = png ]; then files_per_shape=$((files_per_shape + 1)); else files_per_shape=$((files_per_shape + 3)); fi
done
header="input,status,reason,seconds,${extra_columns}warnings"
for layer in ${layers//,/ }; do header="$header,$layer.elements,$layer.b0,$layer.b1,$layer.b2"; done

# without_time FOLDER: its summary but for what is not the same on every run.
without_time() {
  sed -E 's/,(done|skipped),,[^,]*,/,done,,,/; s/(,failed,("([^"]|"")*"|[^,]*)),[^,]*,/\1,,/' "$1/summary.csv"
}
results() { (cd "$1" && find . -type f -not -path './.mesecina/*' -not -name summary.csv -not -name stats.jsonl | sort); }

# ---- The summary: one row per file, whatever became of it.
write_shape 'a, "b"' 1
write_shape plain 2
run --nogui "a, \"b\".$extension" bad.$extension none.$extension plain.$extension "${arguments[@]}" --jobs 2 --output out
expect_status 1
expect_lines out/summary.csv 5
[ "$(head -n 1 out/summary.csv)" = "$header" ] || fail "expected the header $header: $(head -n 1 out/summary.csv)"
expect_in out/summary.csv "\"a, \"\"b\"\".$extension\",done,,"
expect_in out/summary.csv "bad.$extension,failed,"
[ "$(sed -n '4s/,.*//p' out/summary.csv)" = "none.$extension" ] || fail "expected the order of the inputs"
sed -n '5p' out/summary.csv | grep -qE "^plain\.$extension,done,,[0-9.e-]+," || fail "expected plain.$extension to be done"
sed -n '5p' out/summary.csv | cut -d, -f5- | grep -qE "$expected_row" || fail "expected $expected_row: $(sed -n 5p out/summary.csv)"
columns=$(tr -cd , <<<"$header" | wc -c)
[ "$(sed -n '5p' out/summary.csv | tr -cd , | wc -c)" -eq "$columns" ] || fail "expected as many cells as columns"
expect_json out/stats.jsonl 'map(.status) == ["ok", "failed", "ok", "ok"]'

# With --resume, the rows of results that were there, and those of the others.
without_time out >before
run --nogui "a, \"b\".$extension" bad.$extension none.$extension plain.$extension "${arguments[@]}" --output out --resume
expect_status 1
expect_in out/summary.csv "plain.$extension,skipped,"
[ "$(without_time out)" = "$(cat before)" ] || fail "expected the same rows: $(diff before <(without_time out))"
expect_json out/stats.jsonl 'length == 4 and (.[3] | .status == "ok" and (.layers | length) == 3)'

# Statistics of results that were made without them: computed, so that no row lacks them.
succeed --nogui plain.$extension --layers "$layers" --formats "$formats" "${settings[@]}" --output later
expect_no_file later/summary.csv
succeed --nogui plain.$extension "${arguments[@]}" --output later --resume
expect_in later/summary.csv "plain.$extension,done,"

# ---- Interruptions.
layers=${layers/balls/medial-axis}  # how far balls are from a mesh takes longer than all else
arguments=(--layers "$layers" --formats "$formats" "${settings[@]}" --stats)
shapes=()
for i in 1 2 3 4 5 6 7 8; do
  write_shape shape$i $i
  shapes+=("shape$i.$extension")
done
succeed --nogui "${shapes[@]}" "${arguments[@]}" --jobs 2 --output whole

# start FOLDER: a run in the background, `pid`, that has its first results.
start() {
  command_line="--nogui ${shapes[*]} ${arguments[*]} --jobs 2 --output $1"
  rm -rf "$1"
  "$program" --nogui "${shapes[@]}" "${arguments[@]}" --jobs 2 --output "$1" >stdout 2>stderr &
  pid=$!
  for _ in $(seq 600); do
    if [ -n "$(find "$1" -maxdepth 1 -name 'shape*.*' 2>/dev/null)" ]; then return; fi
    sleep 0.05
  done
  fail "expected first results within 30 s"
}
end_of_run() {
  status=0
  { wait "$pid" || status=$?; } 2>/dev/null
}
# expect_only_complete FOLDER: of each shape all files, or none, and nothing half done anywhere.
expect_only_complete() {
  local shape found
  complete=0
  for shape in 1 2 3 4 5 6 7 8; do
    found=$(find "$1" -maxdepth 1 -name "shape$shape.*" | wc -l)
    [ "$found" -eq 0 ] || [ "$found" -eq "$files_per_shape" ] || fail "expected all files of shape$shape or none: $(ls "$1")"
    [ "$found" -eq 0 ] || complete=$((complete + 1))
  done
  [ -z "$(find "$1" -name '*.part*' -o -name '*.unfinished')" ] || fail "expected nothing unfinished in $1"
}
# expect_resumes FOLDER: the rest is computed, and all is as if nothing had happened.
expect_resumes() {
  succeed --nogui "${shapes[@]}" "${arguments[@]}" --jobs 2 --output "$1" --resume
  [ "$(without_time "$1")" = "$(without_time whole)" ] || fail "expected the summary of an uninterrupted run"
  [ "$(results "$1")" = "$(results whole)" ] || fail "expected the files of an uninterrupted run"
  for file in $(results whole); do cmp -s "$1/$file" "whole/$file" || fail "expected $file as of an uninterrupted run"; done
}

for signal in INT TERM; do
  start stopped
  kill -$signal $pid
  end_of_run
  expect_status 130
  expect_only_complete stopped
  if [ "$complete" -eq 8 ]; then fail "expected to be stopped before the end"; fi
  expect_lines stopped/summary.csv $((complete + 1))
  expect_lines stopped/stats.jsonl "$complete"
  expect_in stderr "stopped: $complete of 8 done"
  expect_in stderr "--resume"
  expect_resumes stopped
  [ "$(grep -c ',skipped,' stopped/summary.csv)" -eq "$complete" ] || fail "expected $complete to be skipped"
done

# Results of another run stay as long as there are none of this one.
cp -r whole earlier
"$program" --nogui "${shapes[@]}" --layers "$layers" --formats "$formats" --output earlier --set scale=1.3 2>stderr &
pid=$!
sleep 0.1
kill -INT $pid
end_of_run
expect_status 130
expect_only_complete earlier
[ "$complete" -eq 8 ] || fail "expected the earlier results to stay"

# Killed, or crashed: nothing half done passes for a result; what it was at comes last and is told.
for signal in KILL SEGV; do
  start killed
  (ulimit -c 0; kill -$signal $pid)
  end_of_run
  [ "$status" -gt 128 ] || fail "expected it to be killed"
  unfinished=$(find killed/.mesecina -name '*.unfinished' | wc -l)
  expect_resumes killed
  [ "$(grep -c 'an earlier run was killed while it computed this' stderr)" -eq "$unfinished" ] ||
    fail "expected $unfinished lines on what the run was killed at"
  expect_only_complete killed
done

# A process that crashes: its shape fails, with the reason, and no other.
start crashed
worker=$(sed -n "s/^\([0-9]*\) (.*) [A-Z] $pid .*/\1/p" /proc/[0-9]*/stat 2>/dev/null | head -n 1 || true)
[ -n "$worker" ] || fail "expected the run to have processes that compute"
kill -SEGV "$worker"
end_of_run
expect_status 1
expect_only_complete crashed
[ "$complete" -eq 7 ] || fail "expected the seven other shapes"
expect_lines stderr 1
grep -qE "^$(basename "$program"): shape[1-8]\.$extension: the program crashed \(signal 11\) while it computed this$" stderr ||
  fail "expected the crash to be told"
[ "$(grep -cE "^shape[1-8]\.$extension,failed,[^,]*crashed \(signal 11\)" crashed/summary.csv)" -eq 1 ] ||
  fail "expected one row of a failure"
expect_resumes crashed

# ---- Progress: lines where they are asked for, and on a terminal one line that is written over.
run --nogui "${shapes[@]:0:3}" bad.$extension "${arguments[@]}" --output lines --log info
expect_status 1
[ "$(grep -c 'of 4 done' stderr)" -eq 4 ] || fail "expected four lines of progress"
expect_in stderr ": 4 of 4 done, 1 failed"
grep -qE ' of 4 done.*, about [0-9]+ (s|min) left$' stderr || fail "expected the time left"
run --nogui "${shapes[@]:0:3}" --layers "$layers" --output quiet "${settings[@]}"
expect_not_in stderr "done"
if command -v script >/dev/null; then
  quoted=$(printf '%q ' "$program" --nogui "${shapes[@]:0:3}" bad.$extension --layers "$layers" --output terminal)
  script -qefc "$quoted" /dev/null </dev/null >typescript || true
  expect_in typescript $'\r\033[K2 of 4 done'
  [ "$(grep -c 'of 4 done' typescript)" -le 2 ] || fail "expected one line that is written over"
  [ "$(tail -c 4 typescript)" = $'\r\033[K' ] || fail "expected the line of progress to be gone at the end"
  grep -qaE "^.*$(basename "$program"): bad\.$extension" typescript || fail "expected the failure to be told"
else
  echo "no script(1) here: progress on a terminal is not tried"
fi
