#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Scripts of commands, and the lists of what they may say, without a display.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
export XDG_CONFIG_HOME=$work/config MESECINA_CANVAS=painter

succeed --list commands
expect_in stdout 'export-picture FILE [WxH] [transparent]'
expect_in stdout '[Ctrl+Z]'
succeed --list commands --json
expect_json stdout '.[0] | map(.id) | contains(["open", "fit", "set", "wait", "quit"]) and (length == (unique | length))'
expect_json stdout '.[0] | map(select(.help == "" or .name == "" or .group == "")) | length == 0'
[ ! -e "$work/config" ] || fail "expected that listing changes no preferences"

run --nogui --script x "$examples/giraffe.wkt"
expect_status 2

export QT_QPA_PLATFORM=offscreen
run --script missing.txt
expect_status 1
expect_in stderr 'missing.txt'
cat >script.txt <<END
# writes what --nogui writes
open "$examples/giraffe.wkt"
solo medial-axis
wait
export-layers 'from script' json
quit
END
succeed --script script.txt
expect_file 'from script/giraffe.medial-axis.json'
expect_json 'from script/giraffe.medial-axis.json' '.[0].segments | length > 100'

printf 'new\nadd-point 1 2\nsave-points points.xy\nquit\n' >standard_input
status=0
"$program" --script - <standard_input >stdout 2>stderr || status=$?
expect_status 0
[ "$(cat points.xy)" = "1 2" ] || fail "expected the point of the script"

printf 'new\nshow medial-axsi\nquit\n' >bad.txt
run --script bad.txt
expect_status 1
expect_in stderr "bad.txt:2: show: unknown LAYER 'medial-axsi'; did you mean 'medial-axis'?"

# Sessions and films, in the words of the command line.
printf '0 0\n100 0\n100 60\n0 60\n40 33.3\n' >few.xy
cat >films.txt <<END
open few.xy
solo points voronoi
set lambda-limit=2
record swept/%02d.png --sweep lambda-limit=0:9:4 --size 64x48 --fps 5
record made/%02d.png --evolve noise=2 --size 64x48
record steps/%02d.png --evolution
save-session 'all of it.mesecina'
new
reset lambda-limit
open-session 'all of it.mesecina'
save-session again.mesecina
record again/%02d.png
quit
END
succeed --script films.txt
for film in swept:4 made:3 steps:3 again:3; do
  [ "$(ls "${film%:*}" | wc -l)" -eq "${film#*:}" ] || fail "expected ${film#*:} frames in ${film%:*}"
done
for film in made steps; do expect_different $film/01.png $film/02.png; done
expect_json 'all of it.mesecina' '.[0] | (.evolution.steps | length == 3) and .settings["lambda-limit"] == 9
  and .recording.source == "evolution" and .recording.size == [64, 48] and .recording["frames-per-second"] == 5'
for part in inputs evolution settings layers; do
  expect_same <(jq ".$part" 'all of it.mesecina') <(jq ".$part" again.mesecina)
done
succeed --list commands
for command in 'open-session FILE' 'save-session FILE' 'record FILE [OPTION]...' 'evolve ID [N]'; do
  expect_in stdout "$command"
done
refuse() {  # refuse COMMAND MESSAGE
  printf 'open few.xy\n%s\nquit\n' "$1" >bad.txt
  run --script bad.txt
  expect_status 1
  expect_in stderr "bad.txt:2: $2"
}
refuse 'open-session few.xy' "few.xy: expected a session, or a picture with one within"
refuse 'open-session none.mesecina' "expected a file, found none"
refuse 'save-session x.xy' "save-session: expected a name that ends in .mesecina, found 'x.xy'"
refuse 'save-session none/x.mesecina' "none/x.mesecina: expected to create a file here"
refuse 'record x.mp4 --sweep scael=1:2:3' "record: --sweep scael=1:2:3: "
refuse 'record x.mp4 --evolution' 'record: expected steps of an evolution, found none'
refuse 'record x.mp4 --evolve noize=3' "record: unknown evolution 'noize'; did you mean 'noise'?"
refuse 'record x.mp4 --sweep lambda-limit=0:9:4 --evolution' 'record: expected one of --sweep'
refuse 'record x.mp4 --turntable 3' "record: unknown OPTION '--turntable'"
refuse 'record x.mp4 --fps' 'record: expected a value of --fps, found nothing'
refuse 'record x.mp4 --fps 0' "record: expected a positive number for --fps, found '0'"
refuse 'record x.mp4 --size 3' "record: expected WIDTHxHEIGHT in pixels for --size, found '3'"
refuse 'record x.avi --sweep lambda-limit=0:9:4' "$work/x.avi"
