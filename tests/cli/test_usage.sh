#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Help, lists, and what wrong usage is answered with.
. "$(dirname "$0")/common.sh" "$@"
write_ellipse ellipse.xy

succeed --help
for option in --nogui --layers --set --style --as-listed --output --formats --size --view --stats --jobs --resume --list --json --seed \
  --threads --log --version --help; do
  grep -qE -- "^ +(-.,)?$option( |$)" stdout || fail "expected the option $option"
done
succeed --version
grep -qE '^mesecina2d [0-9]+\.[0-9]+\.[0-9]+$' stdout || fail "expected a name and a version"

layers="points outline image delaunay voronoi voronoi-disks inner-voronoi-disks outer-voronoi-disks
  inner-voronoi-vertices outer-voronoi-vertices one-step-crust curve-normals label-conflicts full-medial-axis
  medial-axis lambda-medial-axis angle-medial-axis scale-medial-axis lambda-medial-axis-disks
  angle-medial-axis-disks scale-medial-axis-disks"
settings="sampling-step lambda-limit angle-limit scale-limit topology-preserving"
succeed --list layers
for layer in $layers; do grep -qE "^ *$layer " stdout || fail "expected the layer $layer"; done
succeed --list layers --json
for layer in $layers; do
  expect_json stdout ".[0][] | select(.id == \"$layer\") | (.label, .stage, .help) | length > 0"
done
expect_json stdout '.[0] | map(.id) | (length == (unique | length)) and all(test("^[a-z0-9]+(-[a-z0-9]+)*$"))'
succeed --list settings
for setting in $settings; do grep -qE "^$setting " stdout || fail "expected the setting $setting"; done
succeed --list settings --json
for setting in $settings; do
  expect_json stdout ".[0][] | select(.id == \"$setting\") | (.label, .help, .type | length > 0), has(\"default\")"
done
succeed --list formats
succeed --list formats --json
expect_json stdout '.[0] | map(select(.use == "write layers").name) | contains(["json", "csv", "obj", "ply"])'
expect_json stdout '.[0] | map(select(.use == "write pictures").name) | contains(["svg", "png", "pdf"])'
expect_json stdout '.[0] | map(select(.use == "read").extensions[])
  | contains(["xy", "xyz", "csv", "txt", "poff", "wpoff", "wkt", "svg", "geojson", "png", "gif", "bmp"])'

# refuse TEXT ARGUMENT...: wrong usage, answered on one or two lines that hold the text; nothing is computed.
refuse() {
  local text=$1
  shift
  run "$@"
  expect_status 2
  expect_empty stdout
  expect_in stderr "$text"
  [ "$(wc -l <stderr)" -le 2 ] || fail "expected at most two lines"
  expect_no_file out
}
refuse "did you mean 'medial-axis'" --nogui ellipse.xy --layers medial-axes
refuse "did you mean 'one-step-crust'" --nogui ellipse.xy --layers medial-axis,one-step-crest
refuse "did you mean 'scale-limit'" --nogui ellipse.xy --set scale-limt=1.2
refuse "did you mean 'json'" --nogui ellipse.xy --formats jsn
refuse "scale-limit" --nogui ellipse.xy --set scale-limit=large
refuse "scale-limit" --nogui ellipse.xy --set scale-limit=0.5
refuse "scale-limit" --nogui ellipse.xy --set scale-limit=1,5
refuse "angle-limit" --nogui ellipse.xy --set angle-limit=181
refuse "topology-preserving" --nogui ellipse.xy --set topology-preserving=perhaps
refuse "ID=VALUE" --nogui ellipse.xy --set scale-limit
refuse "--nogui" --nogui
refuse "--size" --nogui ellipse.xy --size 400
refuse "--size" --nogui ellipse.xy --size 0x300
refuse "--jobs" --nogui ellipse.xy --jobs 0
refuse "--threads" --nogui ellipse.xy --threads many
refuse "--list" --list everything
refuse "--view" --nogui ellipse.xy --view missing.view
refuse "--view: line 1: expected JSON" --nogui ellipse.xy --view '{"center": '
refuse "--view: the view.scale: expected a positive number, found 0" --nogui ellipse.xy \
  --view '{"center": [0, 1], "scale": 0}'
refuse "--view: the view.center: expected two finite numbers [x, y], found [0]" --nogui ellipse.xy \
  --view '{"center": [0], "scale": 1}'
expect_not_in stderr json.exception
refuse "--no-such-option" --nogui ellipse.xy --no-such-option

# Two inputs that would write the same files.
mkdir other
cp ellipse.xy other/
refuse "ellipse" --nogui ellipse.xy other/ellipse.xy

# A window cannot be opened here: one line that says what to do instead, and no crash.
run ellipse.xy
expect_status 2
expect_in stderr "--nogui"
expect_lines stderr 1
