#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of mesecina3d without a display.
. "$(dirname "$0")/common.sh" "$@"

printf '%s\n' '-1 0 0 1' '1 0 0 1' >two.cin
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n' >tetrahedron.off
pixel() { convert "$1" -depth 8 -crop 1x1+"$2"+"$3" -format '%[hex:u.p{0,0}]' info: 2>/dev/null; }  # pixel FILE COLUMN ROW
size_of() { identify -format '%wx%h' "$1"; }
expect_size() { [ "$(size_of "$1")" = "$2" ] || fail "expected $1 to be $2, found $(size_of "$1")"; }
expect_white() { case $(pixel "$@") in FFFFFF*) ;; *) fail "expected $1 white at $2 $3, found $(pixel "$@")" ;; esac; }
expect_painted() { case $(pixel "$@") in FFFFFF*) fail "expected $1 painted at $2 $3" ;; *) ;; esac; }

# One picture with all layers, beside the other formats, the same bytes every time.
succeed --nogui two.cin --layers given-balls,medial-axis --formats json,png --size 320x240 --output one
expect_file one/two.given-balls.json
expect_size one/two.png 320x240
expect_painted one/two.png 120 120
expect_white one/two.png 3 3
succeed --nogui two.cin --layers given-balls,medial-axis --formats png --size 320x240 --output two
expect_same one/two.png two/two.png

# The view: along the row the one ball hides the other.
cat >along.json <<'END'
{"camera": {"position": [10, 0, 0], "target": [0, 0, 0], "up": [0, 1, 0], "projection": "orthographic", "height": 4}}
END
succeed --nogui two.cin --layers given-balls --formats png --size 200x200 --view along.json --output along
expect_painted along/two.png 100 56
expect_white along/two.png 100 44
expect_painted along/two.png 144 100
expect_white along/two.png 156 100
expect_different one/two.png along/two.png

succeed --nogui two.cin --layers given-balls --formats png --size 200x200 --view "$(cat along.json)" --output text
expect_same along/two.png text/two.png

# Cut open, and without a background.
sed 's/}$/, "cutting-plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}}/' along.json >cut.json
succeed --nogui two.cin --layers given-balls --formats png --size 200x200 --view cut.json --transparent --output cut
[ "$(pixel cut/two.png 100 70)" = 00000000 ] || fail "expected nothing above the plane, found $(pixel cut/two.png 100 70)"
case $(pixel cut/two.png 100 130) in *FF) ;; *) fail "expected the ball below the plane" ;; esac

# Looks, of several inputs at a time, larger than a tile.
succeed --nogui two.cin tetrahedron.off --layers mesh,given-balls --style mesh.edges=true --style mesh.opacity=0.5 \
  --style given-balls.filled=false --formats png --size 2600x300 --jobs 2 --log error --output wide
expect_size wide/tetrahedron.png 2600x300
expect_painted wide/tetrahedron.png 1300 150

# A bad view is refused before anything is computed.
run --nogui two.cin --formats png --view '{"camera": 1}' --output bad
expect_status 2
expect_in stderr '--view: expected'
for text in '{}' 'nonsense' '{"camera": {"position": [0, 0, 0], "target": [0, 0, 0], "up": [0, 1, 0]}}'; do
  echo "$text" >bad.json
  run --nogui two.cin --formats png --view bad.json --output bad
  expect_status 2
  expect_in stderr '--view bad.json: expected'
  expect_no_file bad
done

# Vectors: circles in a group named by the layer; too much of them is refused with its number.
succeed --nogui two.cin --layers given-balls --formats svg,pdf --size 200x200 --view along.json --output vectors
expect_file vectors/two.pdf
expect_in vectors/two.svg 'data-layer="given-balls"'
expect_in vectors/two.svg '<circle cx="'
awk 'BEGIN { for (i = 0; i < 20001; ++i) print i, 0, 0, 1 }' >many.cin
run --nogui many.cin two.cin --layers given-balls --formats json,svg,png,pdf --size 60x60 --output many \
  --stats many.jsonl
expect_status 1
expect_lines stderr 2
expect_in stderr 'many/many.pdf: '
expect_in stderr 'many/many.svg: '
expect_in stderr 'found 20001; choose png'

# All else of that input is there, and nothing of an earlier run in place of what is refused.
expect_file many/many.given-balls.json
expect_size many/many.png 60x60
expect_no_file many/many.svg
expect_file many/two.svg
expect_json many.jsonl 'map(.status) == ["incomplete", "ok"]'
expect_json many.jsonl '.[0].refused.svg | test("^many/many.svg: .*found 20001")'
expect_in many/summary.csv 'many.cin,incomplete,'
echo earlier >many/many.svg
run --nogui many.cin two.cin --layers given-balls --formats json,svg,png,pdf --size 60x60 --output many --resume
expect_status 1
expect_lines stderr 2
expect_no_file many/many.svg

# Workers are copies of the first process, which therefore makes no context of graphics itself.
"$program" --nogui two.cin --layers given-balls --formats png --size 900x900 --output apart >/dev/null &
first=$!
while maps=$(cat "/proc/$first/maps" 2>/dev/null) && [ -n "$maps" ]; do
  case $maps in *libEGL_*) fail "expected the first process to leave EGL alone" ;; *) ;; esac
done
wait "$first"
expect_painted apart/two.png 450 450

# Without OpenGL there is a reason, and everything else is written.
export __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null
run --nogui two.cin --layers given-balls --formats json,png --output without
expect_status 1
expect_in stderr 'no pictures:'
expect_file without/two.given-balls.json
expect_no_file without/two.png
