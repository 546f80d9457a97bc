# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by tests of films, after common.sh: decodes them with ffmpeg.
command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null || fail "expected ffmpeg; scripts/setup installs it"

probe() { ffprobe -v error -select_streams v:0 -of default=nw=1:nk=1 "$@"; }
length_of() { probe -show_entries format=duration "$1"; }

# expect_film FILE FRAMES WIDTHxHEIGHT FRAMES/SECONDS
expect_film() {
  local found
  found=$(probe -count_frames -show_entries stream=width,height,avg_frame_rate,nb_read_frames "$1" | paste -sd ' ')
  [ "$found" = "${3/x/ } $4 $2" ] || fail "expected $1 of ${3/x/ } $4 $2 (width, height, rate, frames), found $found"
}

# decode FILE FRAME...: each into 001.png etc., counted from 1.
decode() {
  local frame
  for frame in "${@:2}"; do
    ffmpeg -v error -y -i "$1" -vf "select=eq(n\,$((frame - 1)))" -frames:v 1 "$(printf %03d "$frame").png"
  done
}

deviation() { convert "$1" -colorspace gray -format '%[fx:standard_deviation]' info:; }
expect_painted_picture() {
  awk -v d="$(deviation "$1")" 'BEGIN { exit !(d > 0.02) }' || fail "expected $1 not to be blank"
}
difference() { compare -metric RMSE "$1" "$2" null: 2>&1 | sed 's/.*(\(.*\))/\1/'; }
expect_different_pictures() {
  awk -v d="$(difference "$1" "$2")" 'BEGIN { exit !(d > 0.005) }' || fail "expected $1 and $2 to differ"
}
expect_same_pixels() {
  [ "$(compare -metric AE "$1" "$2" null: 2>&1)" = 0 ] || fail "expected the same pixels in $1 and $2"
}

# expect_only FOLDER NAME...: these and nothing else, hidden files included.
expect_only() {
  local found
  found=$(ls -A "$1" | sort | paste -sd ' ')
  [ "$found" = "$(printf '%s\n' "${@:2}" | sort | sed '/^$/d' | paste -sd ' ')" ] || fail "expected only ${*:2} in $1, found $found"
}
