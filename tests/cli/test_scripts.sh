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
