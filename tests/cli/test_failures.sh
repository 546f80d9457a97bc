#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Bad inputs: one clear line each, and nothing else suffers.
. "$(dirname "$0")/common.sh" "$@"
write_ellipse good.xy
giraffe=$examples/giraffe.wkt
mkdir bad

# refuse FILE TEXT: the file fails with one line that begins with its name and holds the text; the good input beside it
# is computed as ever, and of the bad one nothing is left.
refuse() {
  local file=$1 text=$2 stem
  stem=$(basename "${file%.*}")
  rm -rf out
  run --nogui "$file" good.xy --layers one-step-crust --formats json,svg --stats stats.jsonl
  expect_status 1
  expect_lines stderr 1
  expect_in stderr "mesecina2d: $file"
  expect_in stderr "$text"
  [ "$(tr -d '[:print:]\n' <stderr | LC_ALL=C tr -d '\200-\377' | wc -c)" -eq 0 ] ||
    fail "expected a line fit for a terminal"
  [ "$(wc -c <stderr)" -le 500 ] || fail "expected a short line"
  expect_file out/good.one-step-crust.json
  expect_file out/good.svg
  [ -z "$(find out -name "$stem.*" -o -name '*.part*')" ] || fail "expected nothing of $stem in the results"
  expect_json stats.jsonl "length == 2 and .[0].input == \"$file\" and .[0].status == \"failed\"
    and (.[0].reason | length > 0) and .[1].status == \"ok\""
}

head -c 9000 "$giraffe" >bad/truncated.wkt
refuse bad/truncated.wkt "expected"
printf '{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1,' >bad/truncated.geojson
refuse bad/truncated.geojson "expected"
printf 'POFF 5 0 0\n0 0\n1 0\n' >bad/truncated.poff
refuse bad/truncated.poff "expected"
printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M 0 0 L 10 0 L 10 10 Z"' >bad/truncated.svg
refuse bad/truncated.svg "expected"
printf '\211PNG\r\n\032\n\0\0\0\rIHDR\0\0\1\0' >bad/truncated.png
refuse bad/truncated.png ""

# The same garbage on every run, with zeros, control characters and broken UTF-8 in it.
LC_ALL=C awk 'BEGIN { for (i = 0; i < 4096; ++i) { s = (s * 1103 + 12345) % 65536; printf "%c", int(s / 256) } }' \
  >garbage
for extension in xy xyz csv txt poff wpoff wkt svg geojson png gif bmp; do
  cp garbage bad/garbage.$extension
  refuse bad/garbage.$extension ""
done

printf '0 0\nnan 1\n1 1\n' >bad/nan.xy
refuse bad/nan.xy "bad/nan.xy:2:"
printf '0 0\n1 0\n1 -inf\n' >bad/infinite.xy
refuse bad/infinite.xy "bad/infinite.xy:3:"
printf '0 0\n1 0\n1 1e999\n' >bad/huge.xy
refuse bad/huge.xy "bad/huge.xy:3:"
printf 'POLYGON ((0 0, 1 0,\n1 nan, 0 0))' >bad/nan.wkt
refuse bad/nan.wkt "bad/nan.wkt:2:"
printf '0 0\n1 0\n1 2 3 4 5\n' >bad/columns.xy
refuse bad/columns.xy "bad/columns.xy:3:"
printf '0 0\n1 0 1\n' >bad/mixed.xy
refuse bad/mixed.xy "bad/mixed.xy:2:"
printf '0 0\n1\n' >bad/one_column.xy
refuse bad/one_column.xy "bad/one_column.xy:2:"
printf '0 0\n1 zero\n' >bad/word.xy
refuse bad/word.xy "bad/word.xy:2:"
printf 'TRIANGLE ((0 0, 1 0, 1 1, 0 0))' >bad/unknown.wkt
refuse bad/unknown.wkt "TRIANGLE"
: >bad/empty.xy
refuse bad/empty.xy "empty"
: >bad/empty.wkt
refuse bad/empty.wkt "empty"
: >bad/empty.png
refuse bad/empty.png ""
mkdir bad/folder.xy
refuse bad/folder.xy "folder"
refuse bad/missing.xy ""
cp good.xy bad/unknown.extension
refuse bad/unknown.extension ".wkt"
cp good.xy bad/without_extension
refuse bad/without_extension ".wkt"

# A header that lies about a huge number of points costs neither time nor memory.
printf 'POFF 100000000 0 0\n0 0\n1 0\n' >bad/lying.poff
started=$SECONDS
refuse bad/lying.poff "100000000"
[ $((SECONDS - started)) -le 5 ] || fail "expected an answer at once"
expect_json stats.jsonl '.[0].peak_rss_bytes < 300000000'

# Files that may not be read. Root may read all, so then it is tried as somebody else.
cp good.xy bad/secret.xy
chmod 000 bad/secret.xy
if [ "$(id -u)" -ne 0 ]; then
  refuse bad/secret.xy ""
elif setpriv --reuid=65534 --regid=65534 --clear-groups "$program" --version >/dev/null 2>&1; then
  chmod 777 .
  chmod 755 bad
  rm -rf out stderr stdout stats.jsonl
  real_program=$program
  as_nobody() { setpriv --reuid=65534 --regid=65534 --clear-groups "$real_program" "$@"; }
  program=as_nobody
  refuse bad/secret.xy ""
  program=$real_program
else
  echo "a file that may not be read is not tried: nobody may run $program"
fi

# Odd, but with a meaning: computed, with one line that says what was found.
accept() {  # accept FILE TEXT
  rm -rf out
  run --nogui "$1" --layers outline --formats json
  expect_status 0
  expect_lines stderr 1
  expect_in stderr "$1"
  expect_in stderr "$2"
  expect_json "out/$(basename "${1%.*}").outline.json" '.[0].polygons | length > 0'
}
printf 'POLYGON ((0 0, 2 0, 2 2, 0 2))' >bad/unclosed.wkt
accept bad/unclosed.wkt "closed"
printf 'POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))' >bad/crossing.wkt
accept bad/crossing.wkt "cross"

# Several bad ones among several at a time: the good ones are all there, each bad one has its line.
rm -rf out
run --nogui bad/nan.xy good.xy bad/empty.wkt "$giraffe" bad/missing.xy --jobs 3 --layers one-step-crust \
  --formats json,png --stats stats.jsonl
expect_status 1
expect_lines stderr 3
expect_file out/good.one-step-crust.json
expect_file out/giraffe.one-step-crust.json
expect_file out/giraffe.png
expect_json stats.jsonl 'map(.status) == ["failed", "ok", "failed", "ok", "failed"]'

# Results that cannot be written.
: >occupied
run --nogui good.xy --output occupied/here
[ "$status" -ne 0 ] && [ "$status" -lt 126 ] || fail "expected a failure, and no crash"
expect_lines stderr 1
expect_in stderr "occupied"
