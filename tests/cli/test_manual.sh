#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The manual as files, made without a display: every id is in it, every link leads somewhere, every picture is there.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
export XDG_CONFIG_HOME=$work/config

succeed --manual manual
for list in layers settings evolutions commands; do
  page=$list
  [ "$list" != evolutions ] || page=evolutions-list
  "$program" --list "$list" --json | jq -r '.[].id' >ids
  expect_file ids
  while read -r id; do
    grep -qF "name=\"${list%s}-$id\"" "manual/$page.html" || fail "expected $id in $page.html"
  done <ids
done
"$program" --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | while read -r option; do
  grep -qF "name=\"option-$option\"" manual/options.html || fail "expected $option in options.html"
done

links=0
for page in manual/*.html; do
  for link in $(grep -oE '(href|src)="[^"]*"' "$page" | sed 's/^[a-z]*="//; s/"$//'); do
    case $link in https:*) continue ;; esac
    links=$((links + 1))
    [ -s "manual/${link%%#*}" ] || fail "expected the file $link of $page"
    case $link in
      *'#'*) grep -qF "name=\"${link#*#}\"" "manual/${link%%#*}" || fail "expected the place $link of $page" ;;
    esac
  done
done
[ "$links" -gt 100 ] || fail "expected links, found $links"
for figure in $(grep -ohE 'src="[^"]*"' manual/*.html | sort -u | sed 's/^src="//; s/"$//'); do
  [ -n "$(identify -format '%[mesecina-figure]' "manual/$figure")" ] || fail "expected a recipe in $figure"
done
for file in manual/examples/*; do
  succeed --nogui "$file" --output read
done
[ "$(find manual/pictures -name '*.png' -size +3k | wc -l)" -ge 5 ] || fail "expected pictures"
! grep -lE '<only[23]d>|\{program\}|<figure name' manual/*.html || fail "expected no marks of the chapters"

run --manual /dev/null/manual
expect_status 2
expect_in stderr '--manual /dev/null/manual: cannot be made a directory'
run --manual ""
expect_status 2
expect_in stderr '--manual: expected the name of a directory'
expect_no_file pictures
