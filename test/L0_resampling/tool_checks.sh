# shellcheck shell=bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Helpers of the tests that run the program l0_resample. Sourced with the program as argument: makes an
# empty folder, the working folder from then on, which is gone at the end, and cube.xyz in it.

set -u -m   # job control, since a script's background jobs ignore SIGINT without it
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'chmod -R u+w "$folder"; rm -rf "$folder"' EXIT
cd "$folder" || exit 1
checks=0 failures=0

check()   # what is checked, then a command that must succeed
{
  local what=$1
  shift
  checks=$((checks + 1))
  "$@" && return
  failures=$((failures + 1))
  echo "failed: $what: $*; stderr: $(head -c 500 stderr)" >&2
}

run_plainly()   # the program's arguments; leaves status, stdout and stderr
{
  "$program" "$@" > stdout 2> stderr < /dev/null
  status=$?
}

run() { run_plainly --force "$@"; }   # replaces files, as many runs of a test have the same output

# A failure has its status, says one line on stderr that begins with the program's name, and nothing on stdout.
check_failure()   # expected status, expected part of the message, the program's arguments
{
  run "${@:3}"
  check_failed "$@"
}

check_plain_failure()   # the same without --force
{
  run_plainly "${@:3}"
  check_failed "$@"
}

check_failed()   # as check_failure, after the run
{
  local expected=$1 message=$2
  shift 2
  check "status $expected of: $*" test "$status" -eq "$expected"
  check "one line on stderr of: $*" test "$(wc -l < stderr)" -eq 1
  check "the name of the program on stderr of: $*" grep -q '^l0_resample: ' stderr
  check "'$message' on stderr of: $*" grep -qF -- "$message" stderr
  check "nothing on stdout of: $*" test ! -s stdout
}

no_temporary_files() { test -z "$(find "$folder" -name '*.tmp')"; }
number_of_points()   { sed -n '/^element vertex /{s///p;q}' "$1"; }
properties()         { sed -n '/^end_header/q; s/^property //p' "$1" | tr '\n' ','; }   # of a PLY file
is_old()             { cmp -s "$1" <(echo old); }

end_of_checks()
{
  echo "$checks checks, $failures failed"
  test "$failures" -eq 0
}

# The faces of a cube, 40 x 40 points each, moved by up to 0.01
awk 'BEGIN { srand(1); for (f = 0; f < 6; ++f) for (i = 0; i < 40; ++i) for (j = 0; j < 40; ++j) {
  a = i / 39 - .5; b = j / 39 - .5; c = (f % 2) - .5
  p[0] = int(f / 2) == 0 ? c : a; p[1] = int(f / 2) == 1 ? c : (int(f / 2) == 0 ? a : b); p[2] = int(f / 2) == 2 ? c : b
  for (k = 0; k < 3; ++k) printf "%.6f%s", p[k] + .02 * (rand() - .5), k < 2 ? " " : "\n" } }' > cube.xyz
