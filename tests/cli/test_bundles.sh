#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# --bundle: the same bytes each time, the same picture as what it stands for spelled out, and what wins over it.
. "$(dirname "$0")/common.sh" "$@"
giraffe=$examples/giraffe.wkt

succeed --list bundles --json
cp stdout bundles.json
[ "$(jq length bundles.json)" -ge 12 ] || fail "expected a dozen bundles"
[ "$(jq '[.[].id] | unique | length' bundles.json)" -eq "$(jq length bundles.json)" ] || fail "ids are not unique"
succeed --list bundles
expect_in stdout "scale-axis"

# Every one computes, and gives the same bytes each time.
jq -r '.[].id' bundles.json >ids
while read -r id; do
  succeed --nogui "$giraffe" --bundle "$id" --formats svg --output "first-$id" </dev/null
  expect_not_in stderr "no values"
  succeed --nogui "$giraffe" --bundle "$id" --formats svg --output "second-$id" </dev/null
  expect_same "first-$id/giraffe.svg" "second-$id/giraffe.svg"
done <ids

# A file with looks, settings and a view, against the same spelled out.
cat >mine.json <<'END'
{"format": "mesecina-bundles", "version": 1, "dimension": 2, "bundles": [
  {"name": "First", "layers": [{"id": "points"}]},
  {"name": "Mine", "layers": [{"id": "medial-axis", "style": {"color": "#0a64ff", "line-width": 4.25}},
    {"id": "outline", "style": {"filled": true}}, {"id": "grown-layer", "style": {}}],
   "settings": {"sampling-step": 0.01}, "view": {"center": [300, 200], "scale": 2.5}}]}
END
echo '{"center": [300, 200], "scale": 2.5}' >mine.view.json
succeed --nogui "$giraffe" --bundle mine.json#mine --formats svg,json --output bundle
expect_in stderr "there is no layer 'grown-layer'"
succeed --nogui "$giraffe" --layers medial-axis,outline --as-listed --set sampling-step=0.01 --view mine.view.json \
  --style medial-axis.color=#0a64ff --style medial-axis.line-width=4.25 --style outline.filled=true \
  --formats svg,json --output spelled
expect_same bundle/giraffe.svg spelled/giraffe.svg
expect_same bundle/giraffe.medial-axis.json spelled/giraffe.medial-axis.json

# What is said beside it wins.
succeed --nogui "$giraffe" --bundle mine.json#Mine --set sampling-step=0.02 --style medial-axis.line-width=1 \
  --layers medial-axis --view fit --formats svg --output changed
succeed --nogui "$giraffe" --layers medial-axis --set sampling-step=0.02 --style medial-axis.color=#0a64ff \
  --style medial-axis.line-width=1 --view mine.view.json --formats svg --output expected
expect_same changed/giraffe.svg expected/giraffe.svg

# The background: that of the bundle, unless it is said otherwise; on a dark one dark lines are lightened.
echo '[{"name": "Night", "background": "dark", "layers": [{"id": "voronoi", "visible": false},
  {"id": "outline", "style": {"color": "#000000"}}]}]' >night.json
sed 's/dark/none/' night.json >nothing.json
succeed --nogui "$giraffe" --bundle night.json --formats svg --output night
expect_in night/giraffe.svg "#181a1e"
expect_in night/giraffe.svg "#ffffff"
expect_not_in night/giraffe.svg "#000000"
succeed --nogui "$giraffe" --layers outline --style outline.color=#000000 --background dark --formats svg --output spelled-night
expect_same night/giraffe.svg spelled-night/giraffe.svg
succeed --nogui "$giraffe" --bundle night.json --background paper --formats svg --output day
expect_not_in day/giraffe.svg "#181a1e"
expect_in day/giraffe.svg "#000000"
succeed --nogui "$giraffe" --bundle nothing.json --formats png --output nothing
succeed --nogui "$giraffe" --bundle nothing.json --background paper --transparent --formats png --output transparent
expect_same nothing/giraffe.png transparent/giraffe.png
succeed --nogui "$giraffe" --bundle night.json --background window --formats svg --output window
expect_in window/giraffe.svg "#f4f5f7"
rm nothing.json

# What a bundle has nothing to show of is told.
echo "1 2 3" >disk.xy
succeed --nogui disk.xy --bundle power-crust --formats svg --output needs
expect_in stderr "disk.xy: bundle power-crust: needs points or an outline"
succeed --nogui disk.xy --bundle union-1-balls --formats svg --output needs
expect_empty stderr

# --resume: another bundle is another picture.
succeed --nogui "$giraffe" --bundle points --formats svg --output resumed --resume
cp resumed/giraffe.svg before.svg
succeed --nogui "$giraffe" --bundle voronoi-and-delaunay --formats svg --output resumed --resume
expect_different before.svg resumed/giraffe.svg

# refuse TEXT BUNDLE: wrong usage on one line that holds the text.
refuse() {
  run --nogui "$giraffe" --output refused --bundle "$2"
  expect_status 2
  expect_lines stderr 1
  expect_in stderr "$1"
  expect_no_file refused
}
echo '{"format": "mesecina-bundles", "version": 9, "bundles": []}' >future.json
echo '{"format": "mesecina-bundles", "version": 1, "bundles": []}' >empty.json
head -c 30 empty.json >cut.json
printf 'abcdefgh' >old.bnd
refuse "did you mean 'scale-axis'" scale-axs
refuse "there is no such file" nothing.json
refuse "did you mean 'mine'" mine.json#min
refuse "at most 1" future.json
refuse "no bundle in it" empty.json
refuse "cut.json: line 1: expected JSON" cut.json
refuse "byte 0: expected the mark of a file of bundles 0xB3" old.bnd

# The user's own list: its bundles go by their names, before those of the program, and what is taken from it is known
# still.
mkdir -p "$XDG_DATA_HOME/mesecina"
list=$XDG_DATA_HOME/mesecina/mesecina2d-bundles.json
cat >"$list" <<'END'
{"format": "mesecina-bundles", "version": 1, "dimension": 2, "bundles": [
  {"name": "Figure 3", "layers": [{"id": "outline", "style": {"color": "#ff0000"}}]},
  {"name": "Scale axis", "layers": [{"id": "outline", "style": {"color": "#00ff00"}}]}]}
END
succeed --list bundles --json
[ "$(jq length stdout)" -eq "$(($(jq length bundles.json) + 1))" ] || fail "expected all bundles and one more"
expect_json stdout '.[0][0] | .id == "figure-3" and .origin == "own"'
expect_json stdout '.[0][1] | .id == "scale-axis" and .origin == "changed"'
expect_json stdout '.[0][2:] | all(.origin == "shipped")'
succeed --list bundles
expect_in stdout "(yours) Figure 3"
succeed --nogui "$giraffe" --bundle "Figure 3" --formats svg --output own
expect_in own/giraffe.svg "#ff0000"
expect_empty stderr
succeed --nogui "$giraffe" --bundle scale-axis --formats svg --output own
expect_in own/giraffe.svg "#00ff00"
expect_in stderr "is yours, from $list; the one of the program is 'shipped:scale-axis'"
succeed --nogui "$giraffe" --bundle shipped:scale-axis --formats svg --output own
expect_same own/giraffe.svg first-scale-axis/giraffe.svg
expect_not_in stderr "yours"
succeed --nogui "$giraffe" --bundle points --formats svg --output own
expect_same own/giraffe.svg first-points/giraffe.svg
refuse "did you mean 'figure-3'" figure-33
refuse "unknown bundle 'figure-3'" shipped:figure-3
# A broken list is told, stays as it is, and the shipped bundles go on.
cp cut.json "$list"
succeed --nogui "$giraffe" --bundle scale-axis --formats svg --output own
expect_same own/giraffe.svg first-scale-axis/giraffe.svg
expect_in stderr "$list: line 1: expected JSON"
expect_same cut.json "$list"
succeed --list bundles
expect_in stdout "Yours are missing: $list"
rm "$list"
