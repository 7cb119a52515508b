# shellcheck shell=bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Helpers of the tests that run the program l0_resample. Sourced with the program as argument: makes
# an empty folder, the working folder from then on, which is gone at the end, and cube.xyz in it.

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

# A failure has its status, says one line on stderr that begins with the program's name, and nothing
# on stdout.
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
is_old()             { cmp -s "$1" <(echo old); }
properties()   # of a PLY file
{
  sed -n '/^end_header/q; s/^property //p' "$1" | tr '\n' ','
}

# Passes signals on, and ends a program that is deaf to them.
# shellcheck disable=SC2034   # it is for those that source this
patient=(timeout --foreground -s KILL 60)

end_of_checks()
{
  echo "$checks checks, $failures failed"
  test "$failures" -eq 0
}

# The faces of a cube, 40 x 40 points each, with noise of 0.02 / sqrt(12), about Gaussian
awk 'BEGIN { srand(1); for (f = 0; f < 6; ++f) for (i = 0; i < 40; ++i) for (j = 0; j < 40; ++j) {
  a = i / 39 - .5; b = j / 39 - .5; c = (f % 2) - .5; axis = int(f / 2)
  p[0] = axis == 0 ? c : a; p[1] = axis == 1 ? c : (axis == 0 ? a : b); p[2] = axis == 2 ? c : b
  for (k = 0; k < 3; ++k) {
    noise = .01 * (rand() + rand() + rand() + rand() - 2)
    printf "%.6f%s", p[k] + noise, k < 2 ? " " : "\n" } } }' \
  > cube.xyz

# Inputs that are made of the cube, for the tests that ask for them.
make_inputs()   # their names
{
  local name
  for name in "$@"; do
    case $name in
      attributes.ply)   # with properties
        {
          printf 'ply\nformat ascii 1.0\nelement vertex 9600\n'
          printf 'property %s\n' 'double x' 'double y' 'double z' 'uchar red' 'int label' \
            'float height'
          printf 'end_header\n'
          awk '{ print $0, ($1 > 0 ? 200 : 100), ($1 > 0 ? -70000 : 7), $3 }' cube.xyz
        } > attributes.ply ;;
      inward.xyz)   # with normals
        awk '{ r = -sqrt($1 * $1 + $2 * $2 + $3 * $3); print $0, $1 / r, $2 / r, $3 / r }' \
          cube.xyz > inward.xyz ;;
      viewed.xyz)   # and the places that it was seen from
        awk '{ print $0, NR % 2 }' cube.xyz > viewed.xyz
        printf '0 0 0.1\n# another\n0.1 -0.1 0\n' > views.txt ;;
      bad.xyz)   # two points are not finite
        { cat cube.xyz; echo 'nan 0 0'; echo '0 inf 0'; } > bad.xyz ;;
      comma.xyz)
        printf '1 2 3\n1 0,5 3\n' > comma.xyz ;;
      long.xyz)   # with a radius of 1, work for minutes
        awk '{ for (i = 0; i < 40; ++i)
          print $1 + i % 7 * .01, $2 + i % 5 * .01, $3 + i % 3 * .01 }' cube.xyz > long.xyz ;;
      same.*)   # 500 points of the cube, in the format that the extension names
        run cube.xyz "$name" --points 500
        check "writing ${name#*.}" test "$status" -eq 0 ;;
      scans)   # a folder with three good files, a bad one, and two of no known format
        mkdir scans
        make_inputs comma.xyz same.npy same.pcd
        cp cube.xyz scans/a.xyz; cp same.npy scans/b.npy
        cp comma.xyz scans/c.xyz; cp same.pcd scans/d.pcd
        echo nothing > scans/notes.txt; echo old > scans/old.e57 ;;
      old.ply)   # an output that nothing may harm
        echo old > old.ply ;;
      *)
        check "an input that can be made" test "$name" = "" ;;
    esac
  done
}
