#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The figures in docs/figures: the script makes each that is there, and no other.
. "$(dirname "$0")/common.sh" "$@"
root=$(cd "$examples/../.." && pwd)

"$root/scripts/make-figures" "$program" "$work/figures" >stdout 2>stderr || fail "expected figures: $(tail -3 stderr)"
expect_empty stderr
list() { find "$1" -maxdepth 1 -type f -printf '%f\n' | LC_ALL=C sort; }
list "$root/docs/figures" >there
list "$work/figures" >made
expect_same there made
for picture in $(grep -oE '\]\([0-9][^)]+' figures/README.md | cut -c3-); do expect_file "figures/$picture"; done

# The commands of the sheet are those that made the pictures.
cd "$root"
mesecina2d() { "$program" "$@" --output "$work/again" --log error; }
script=$(sed -n '/^```$/,/^```$/p' "$work/figures/README.md" | grep -v '^```$' |
  sed 's/^# \(.*\)\.\(svg\|png\)$/picture \1.\2/')
picture() {
  [ -z "${name-}" ] || mv "$work"/again/*."${name##*.}" "$work/repeated/$name"
  name=$1
}
mkdir "$work/repeated"
eval "$script"
picture end
rm "$work/figures/README.md"
expect_same "$work/figures" "$work/repeated"
