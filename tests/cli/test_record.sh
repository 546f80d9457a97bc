#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Films of the plane, made without a display and decoded again.
. "$(dirname "$0")/common.sh" "$@"
. "$(dirname "$0")/films.sh"
write_ellipse ellipse.xy 60

# Ten seconds of the scale axis of the giraffe, for s from 1 to 2.
succeed --nogui "$examples/giraffe.wkt" --layers outline,scale-axis --sweep scale=1:2:300 --size 320x240 \
  --record films/giraffe.mp4
expect_film films/giraffe.mp4 300 320x240 30/1
[ "$(length_of films/giraffe.mp4)" = 10.000000 ] || fail "expected 10 seconds, found $(length_of films/giraffe.mp4)"
decode films/giraffe.mp4 1 300
expect_painted_picture 001.png
expect_painted_picture 300.png
expect_different_pictures 001.png 300.png
# Nothing else is written.
expect_only films giraffe.mp4
expect_no_file out

# Frames are pictures as --formats png makes them: the first, one in the middle, the last.
sweep=(--nogui ellipse.xy --layers points,scale-medial-axis --style scale-medial-axis.value=scale
  --style scale-medial-axis.range-minimum=1 --style scale-medial-axis.range-maximum=3 --size 120x90)
succeed "${sweep[@]}" --sweep scale-limit=1:2:5 --record frames/f-%03d.png
expect_only frames f-001.png f-002.png f-003.png f-004.png f-005.png
for frame in 1:1 3:1.5 5:2; do
  succeed "${sweep[@]}" --set scale-limit="${frame#*:}" --formats png --output still
  expect_same still/ellipse.png "frames/f-00${frame%:*}.png"
done
expect_different frames/f-001.png frames/f-005.png
# The same bytes on every run and however many threads.
succeed "${sweep[@]}" --sweep scale-limit=1:2:5 --record again/f-%03d.png --threads 1
expect_same frames again

# There and back, and two at a time: the shorter one waits at its end.
succeed "${sweep[@]}" --sweep scale-limit=1:2:3:smooth:ping-pong --sweep angle-limit=1:2:2 --record pong/%d.png
expect_only pong 1.png 2.png 3.png 4.png 5.png
expect_same frames/f-001.png pong/5.png
expect_same pong/2.png pong/4.png
expect_same frames/f-005.png pong/3.png

# Ranges of colours that find themselves are the same in all frames: a bar does not change while the limit moves.
succeed --nogui ellipse.xy --layers scale-medial-axis --style scale-medial-axis.value=scale --size 200x150 \
  --sweep scale-limit=1:1.5:3 --record bars/%d.png
convert bars/1.png -gravity southeast -crop 100x50+0+0 +repage bar1.png
convert bars/3.png -gravity southeast -crop 100x50+0+0 +repage bar3.png
expect_same_pixels bar1.png bar3.png

# WebM keeps alpha; sizes that are odd get a row and a column of background.
succeed --nogui ellipse.xy --layers points --sweep angle-limit=1:2:6 --size 101x75 --fps 12.5 --transparent \
  --record clear.webm
expect_film clear.webm 6 102x76 25/2
ffmpeg -v error -y -c:v libvpx-vp9 -i clear.webm -frames:v 1 -pix_fmt rgba clear.png
case $(convert clear.png -format '%[hex:u.p{1,1}]' info:) in *00) ;; *) fail "expected nothing in the corner" ;; esac
[ "$(convert clear.png -alpha extract -format '%[fx:maxima]' info:)" = 1 ] || fail "expected points"
succeed --nogui ellipse.xy --layers points --sweep angle-limit=1:2:3 --size 101x75 --record odd.mp4
expect_film odd.mp4 3 102x76 30/1
decode odd.mp4 1
[ "$(convert 001.png -format '%[fx:p{101,75}.lightness>0.98]' info:)" = 1 ] || fail "expected a white border"

# GIF: exact size, loops for ever.
succeed --nogui ellipse.xy --layers points,scale-medial-axis --sweep scale-limit=1:2:4 --size 101x75 --fps 10 --record loop.gif
expect_film loop.gif 4 101x75 10/1
grep -qa NETSCAPE2.0 loop.gif || fail "expected a GIF that loops"

# Names that mean something to ffmpeg are only names.
for name in 'a:b/50%d.gif' 'a:b/50%d.mp4' '-d/c.webm'; do
  succeed --nogui ellipse.xy --layers points --sweep angle-limit=1:2:2 --size 32x32 --record="$name"
  probe "file:$name" >/dev/null || fail "expected a film $name"
done

# Several inputs: their stems come first. Other files only where --formats asks for them.
write_ellipse other.xy 40
succeed --nogui ellipse.xy other.xy --layers points --sweep angle-limit=1:2:2 --size 64x64 --record many/all.gif --jobs 2 \
  --formats json --output many
expect_file many/ellipse.all.gif
expect_file many/other.all.gif
expect_file many/other.points.json

# Where frames are numbered, % in a name of an input has no meaning; else it stays.
cp ellipse.xy 50%d.xy
succeed --nogui 50%d.xy other.xy --layers points --sweep angle-limit=1:2:2 --size 32x32 --record numbered/f-%02d.png
expect_file numbered/50_d.f-01.png
expect_file numbered/50_d.f-02.png
expect_file numbered/other.f-02.png
succeed --nogui 50%d.xy other.xy --layers points --sweep angle-limit=1:2:2 --size 32x32 --record numbered/all.gif
expect_file numbered/50%d.all.gif

# Steps of evolutions are frames, and the state before them is the first.
succeed --nogui ellipse.xy --layers points --evolve laplacian-smoothing=4 --size 160x120 --record smooth.mp4
expect_film smooth.mp4 5 160x120 30/1
decode smooth.mp4 1 5
expect_different_pictures 001.png 005.png

# Layers that cannot be computed are told once.
printf '0 0\n1 1\n' >two.xy
run --nogui two.xy --layers points,medial-axis --sweep angle-limit=1:2:3 --size 64x64 --record two.gif
expect_status 0
[ "$(grep -c 'layer medial-axis' stderr)" = 1 ] || fail "expected one warning"

# Without ffmpeg there are numbered pictures, and the command that makes the film of them.
mkdir bin
run_without_ffmpeg() { PATH=$work/bin run "$@"; }
run_without_ffmpeg --nogui ellipse.xy --layers points --sweep angle-limit=1:2:3 --size 64x48 --record "no film.mp4"
expect_status 1
expect_no_file "no film.mp4"
expect_file "no film-00003.png"
expect_in stderr "no film-%05d.png"
grep -o "ffmpeg -framerate.*" stderr >command
bash command 2>/dev/null || fail "expected the command to work: $(cat command)"
expect_film "no film.mp4" 3 64x48 30/1

run_without_ffmpeg --nogui ellipse.xy --layers points --sweep angle-limit=1:2:2 --size 64x48 --record 50%d.mp4
expect_status 1
expect_file 50_d-00001.png
expect_file 50_d-00002.png

# The command of such names works as well, in such folders too.
mkdir 'c:d 7%d'
run_without_ffmpeg --nogui ellipse.xy --layers points --sweep angle-limit=1:2:3 --size 64x48 --record 'c:d 7%d/9%d.mp4'
expect_status 1
grep -o "ffmpeg -framerate.*" stderr >command
bash command 2>/dev/null || fail "expected the command to work: $(cat command)"
expect_film 'file:c:d 7%d/9%d.mp4' 3 64x48 30/1

# What ffmpeg complains of is told; nothing stays.
cat >bin/ffmpeg <<'END'
#!/bin/sh
echo 'no such encoder' >&2
exit 1
END
chmod +x bin/ffmpeg
PATH=$work/bin:$PATH run --nogui ellipse.xy --layers points --sweep angle-limit=1:2:9 --size 640x480 --record broken/film.mp4
expect_status 1
expect_in stderr 'no such encoder'
expect_only broken

# Stopped, by a signal to all that a terminal would stop: nothing stays, and an older film stays as it was.
mkdir stopped
echo old >stopped/film.mp4
setsid "$program" --nogui "$examples/giraffe.wkt" --layers outline --sweep scale=1:2:100000 --size 320x240 \
  --record stopped/film.mp4 2>stderr &
process=$!
for ((i = 0; i < 200; ++i)); do [ -d stopped/.film.mp4.unfinished ] && break; sleep 0.05; done
[ -d stopped/.film.mp4.unfinished ] || fail "expected a film to begin"
sleep 0.5
kill -INT -- "-$process"
status=0
wait "$process" || status=$?
expect_status 130
expect_only stopped film.mp4
[ "$(cat stopped/film.mp4)" = old ] || fail "expected the older film"

# Wrong usage, before anything is computed.
refuse() {
  local text=$1
  shift
  run "$@"
  expect_status 2
  expect_in stderr "$text"
}
refuse 'name of a file' --nogui ellipse.xy --evolve noise=2 --record ''
refuse 'moves already' --nogui ellipse.xy --sweep scale-limit=1:2:3 --sweep scale-limit=1:3:3 --record film.mp4
refuse 'nothing moves' --nogui ellipse.xy --record film.mp4
refuse 'add --record' --nogui ellipse.xy --sweep angle-limit=1:2:3
refuse "did you mean 'scale-limit'" --nogui ellipse.xy --sweep scale-limt=1:2:3 --record film.mp4
refuse 'no transparency' --nogui ellipse.xy --sweep scale-limit=1:2:3 --record film.mp4 --transparent
refuse '.mp4, .webm or .gif' --nogui ellipse.xy --sweep scale-limit=1:2:3 --record film.avi
refuse 'needs --nogui' ellipse.xy --sweep scale-limit=1:2:3 --record film.mp4
cp loop.gif input.gif
refuse 'is an input' --nogui input.gif --sweep scale-limit=1:2:3 --record input.gif
