# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the tests: test_NAME.sh PROGRAM EXAMPLES. Each works in a fresh folder, deleted when it ends.
set -euo pipefail
program=$1
examples=$2
unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM
work=$(mktemp -d)
trap 'chmod -R u+rwx "$work"; rm -rf "$work"' EXIT
cd "$work"
# What the user of this machine keeps (bundles) is nobody's business here.
export XDG_DATA_HOME=$work/.data

fail() {
  echo "FAILED (line ${BASH_LINENO[*]}): $*" >&2
  if [ -n "${command_line-}" ]; then
    echo "command: $(basename "$program") $command_line; exit status $status; standard error:" >&2
    head -c 4000 stderr >&2
  fi
  exit 1
}

# run ARGUMENT...: the program; its exit status is in `status`, what it says in the files stdout and stderr.
run() {
  command_line=$*
  status=0
  "$program" "$@" >stdout 2>stderr || status=$?
}

expect_status() { [ "$status" -eq "$1" ] || fail "expected exit status $1"; }
expect_in() { grep -qF -- "$2" "$1" || fail "expected '$2' in $1"; }
expect_not_in() { ! grep -qF -- "$2" "$1" || fail "expected no '$2' in $1"; }
expect_lines() { [ "$(wc -l <"$1")" -eq "$2" ] || fail "expected $2 lines in $1, found $(wc -l <"$1")"; }
expect_empty() { [ ! -s "$1" ] || fail "expected nothing in $1"; }
expect_file() { [ -s "$1" ] || fail "expected the file $1"; }
expect_no_file() { [ ! -e "$1" ] || fail "expected no $1"; }
expect_json() { jq -es "$2" "$1" >/dev/null || fail "expected $2 of $1: $(head -c 1000 "$1")"; }
expect_same() { diff -r "${@:3}" "$1" "$2" >"$work/differences" || fail "expected the same in $1 and $2: $(head -5 "$work/differences")"; }
expect_different() { ! cmp -s "$1" "$2" || fail "expected $1 and $2 to differ"; }

# succeed ARGUMENT...: runs and expects exit status 0, and no noise: only lines of the program's own.
succeed() {
  run "$@"
  expect_status 0
  ! grep -v "^$(basename "$program"): " stderr >noise || fail "expected no other lines than the program's own"
}

# A sample of an ellipse: its crust is one closed curve and its medial axis is a tree.
write_ellipse() {  # write_ellipse FILE [COUNT]
  awk -v n="${2-200}" 'BEGIN { for (i = 0; i < n; ++i) { a = (i + 0.3 * sin(7 * i)) * 8 * atan2(1, 1) / n
    print 3 * cos(a), sin(a) } }' >"$1"
}
