#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What the chapters of the manual say in <pre class="shell"> and <pre class="commands"> is carried out, in the order of the
# chapters, in the folder of examples that --manual makes; and the files that they promise are there.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
export XDG_CONFIG_HOME=$work/config XDG_DATA_HOME=$work/data MESECINA_CANVAS=painter
name=$(basename "$program")
mkdir bin
ln -s "$program" "bin/$name"
export PATH=$work/bin:$PATH

succeed --manual manual
expect_file manual/examples/"$([ "$name" = mesecina2d ] && echo giraffe.wkt || echo ring.off)"
cd manual/examples

count=0
for page in evolutions bundles recording sessions command-line many-shapes; do
  if [ "$page" = many-shapes ]; then  # the folder of shapes is that of the examples again
    mkdir kept
    mv step-3.* found-again.* kept
  fi
  csplit -sz -f "$work/part-" "$work/manual/$page.html" '/<pre class=/' '{*}'
  for part in "$work"/part-*; do
    kind=$(sed -nE '1s/.*<pre class="([a-z]+)">.*/\1/p' "$part")
    [ -n "$kind" ] || continue
    sed -E 's/.*<pre class="[a-z]+">//; /<\/pre>/q' "$part" |
      sed -E 's/<\/pre>.*//; s/<[^>]*>//g; s/&lt;/</g; s/&gt;/>/g; s/&quot;/"/g; s/&amp;/\&/g' >"$work/block"
    count=$((count + 1))
    status=0
    command_line="of the page $page: $(head -c 2000 "$work/block")"
    case $kind in
      shell) bash -euo pipefail "$work/block" >"$work/stdout" 2>"$work/stderr" </dev/null || status=$? ;;
      commands) QT_QPA_PLATFORM=offscreen "$name" --script "$work/block" >"$work/stdout" 2>"$work/stderr" || status=$? ;;
      *) fail "expected no class '$kind' in $page" ;;
    esac
    cp "$work/stdout" "$work/stderr" .
    [ "$status" = 0 ] || fail "expected exit status 0"
  done
  rm -f "$work"/part-*
done
[ "$count" -ge 15 ] || fail "expected commands in the chapters, found $count"

stem=$([ "$name" = mesecina2d ] && echo giraffe || echo ring)
for file in smooth/$stem.medial-axis.json smooth/$stem.png looks/$stem.png my-bundles.json scale-axis.png pictures/$stem.png \
  scale-axis.mp4 smoothing.gif with-scene.png again/with-scene.png other/$stem.png picture.png results/summary.csv \
  results/$stem.scale-axis.ply scale-1.05/summary.csv "$stem.png"; do
  expect_file "$file"
done
# What came back out of the picture is what went in.
if [ "$name" = mesecina2d ]; then
  expect_same <(tr -d ' ' <giraffe.wkt) <(tr -d ' ' <kept/found-again.wkt)
  expect_different giraffe.wkt kept/step-3.wkt
else
  "$name" --nogui ring.off kept/found-again.off --layers mesh --output meshes
  expect_same <(jq .vertices meshes/ring.mesh.json) <(jq .vertices meshes/found-again.mesh.json)
  expect_file turn.webm
fi
# The same look from a shipped bundle and from the file that a script wrote.
"$name" --nogui "$([ "$stem" = ring ] && echo ring.off || echo giraffe.wkt)" --bundle scale-axis --formats png --output shipped
expect_same "shipped/$stem.png" "mine/$stem.png"
