#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Films of space, made without a display and decoded again.
. "$(dirname "$0")/common.sh" "$@"
. "$(dirname "$0")/films.sh"
printf '%s\n' '-1 0 0 1' '0.2 0.3 0 0.6' '1 0 0 1' '1.5 1 0.5 0.4' >row.cin

# A turntable of the scale axis of balls, twice.
for name in one two; do
  succeed --nogui row.cin --layers given-balls,scale-axis --style given-balls.opacity=0.4 --size 160x120 --turntable 12 \
    --record "$name.mp4"
done
expect_film one.mp4 12 160x120 30/1
expect_same one.mp4 two.mp4
decode one.mp4 1 4 12
expect_painted_picture 001.png
expect_painted_picture 012.png
expect_different_pictures 001.png 004.png
expect_different_pictures 001.png 012.png

# A whole turn ends one frame before it begins again; frames are pictures as --formats png makes them.
cat >view.json <<'END'
{"camera": {"position": [6, 3, 0], "target": [0, 0, 0], "up": [0, 1, 0], "projection": "perspective", "field-of-view": 40},
 "camera-path": [
  {"position": [6, 3, 0], "target": [0, 0, 0], "up": [0, 1, 0], "projection": "perspective", "field-of-view": 40},
  {"position": [0, 3, 8], "target": [0, 0, 0], "up": [0, 1, 0], "projection": "perspective", "field-of-view": 40}]}
END
look=(--nogui row.cin --layers given-balls --size 120x90)
succeed "${look[@]}" --view view.json --formats png --output still
succeed "${look[@]}" --view view.json --turntable 4 --record turn/%d.png
expect_only turn 1.png 2.png 3.png 4.png
expect_same still/row.png turn/1.png
sed 's/\[6, 3, 0\], "target"/[0, 3, -6], "target"/' view.json >quarter.json
succeed "${look[@]}" --view quarter.json --formats png --output quarter
awk -v d="$(difference quarter/row.png turn/2.png)" 'BEGIN { exit !(d < 0.01) }' || fail "expected a quarter of a turn"
expect_different_pictures turn/1.png turn/2.png

# Through key frames, both ends exactly.
sed '1s/.*/{"camera": {"position": [0, 3, 8], "target": [0, 0, 0], "up": [0, 1, 0], "projection": "perspective", "field-of-view": 40}}/; 2,$d' \
  view.json >last.json
succeed "${look[@]}" --view last.json --formats png --output last
succeed "${look[@]}" --view view.json --camera-path 5 --record path/%d.png
expect_only path 1.png 2.png 3.png 4.png 5.png
expect_same still/row.png path/1.png
expect_same last/row.png path/5.png

# A number that moves during a turn; without a background; the table goes on turning.
succeed --nogui row.cin --layers scale-axis --sweep scale=1:2:6 --turntable 3 --size 90x60 --transparent --record both.webm
expect_film both.webm 6 90x60 30/1
ffmpeg -v error -y -c:v libvpx-vp9 -i both.webm -frames:v 1 -pix_fmt rgba clear.png
case $(convert clear.png -format '%[hex:u.p{1,1}]' info:) in *00) ;; *) fail "expected nothing in the corner" ;; esac
[ "$(convert clear.png -alpha extract -format '%[fx:maxima>0.9]' info:)" = 1 ] || fail "expected a scale axis"

# Wrong usage.
run "${look[@]}" --camera-path 5 --record path.mp4
expect_status 2
expect_in stderr 'camera-path'
run "${look[@]}" --record path.mp4
expect_status 2
expect_in stderr '--turntable'

# Without OpenGL there is a reason and no film.
export __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null
run "${look[@]}" --turntable 4 --record none.mp4
expect_status 1
expect_in stderr 'no pictures:'
expect_no_file none.mp4
