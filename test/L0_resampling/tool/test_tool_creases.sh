#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The option --creases of the program l0_resample: files of lines in three formats.
# usage: test_tool_creases.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"

run cube.xyz clean.ply --creases creases.obj --snapshot picture.png --json report.json
check "a run with creases" test "$status" -eq 0
check "a property says which points are on them" test "$(properties clean.ply)" = \
  "$(printf '%s,' 'double x' 'double y' 'double z' 'double nx' 'double ny' 'double nz' \
    'uchar crease')"
check "as many points as ever" grep -q '^element vertex 4800$' <(head -c 400 clean.ply | tr -d '\r')
# the mark is the last byte of a row of 49
tail -c $((4800 * 49)) clean.ply | od -An -v -w49 -t u1 | awk '{ print $49 }' > marks.txt
check "eight corners are marked" test "$(grep -c '^2$' marks.txt)" -eq 8
check "vertices of the lines are the marked points" test \
  "$(grep -c '^v ' creases.obj)" -eq "$(grep -c -v '^0$' marks.txt)"
check "twelve lines and eight corners" test \
  "$(grep -c '^l ' creases.obj) $(grep -c '^p ' creases.obj)" = "12 8"
check "what kind of crease each is" test "$(grep -c '^# convex angle ' creases.obj)" -eq 12
check "lines of vertices that there are" test "$(awk '
  /^v / { n++ } /^[lp] / { for (k = 2; k <= NF; k++) if ($k < 1 || $k > n) bad++ }
  END { print bad + 0 }' creases.obj)" -eq 0
# the cube is that of [-0.5, 0.5]: two coordinates of a place on an edge are near half
check "vertices on the edges" test "$(awk '
  function off(x) { x = x < 0 ? -x : x; return x > 0.5 ? x - 0.5 : 0.5 - x }
  /^v / { near = (off($2) < 0.02) + (off($3) < 0.02) + (off($4) < 0.02); bad += near < 2 }
  END { print bad + 0 }' creases.obj)" -eq 0

run cube.xyz clean.ply --force --creases creases.ply
check "lines as PLY" test "$status" -eq 0 -a "$(head -1 creases.ply)" = ply
check "all rows that the header says" test "$(awk '
  /^element/ { rows += $3 } header_is_over { rows-- } /^end_header/ { header_is_over = 1 }
  END { print rows }' creases.ply)" -eq 0
run cube.xyz clean.ply --force --creases creases.dxf
check "lines as DXF" test "$status" -eq 0 \
  -a "$(grep -c '^POLYLINE$' creases.dxf) $(grep -c '^POINT$' creases.dxf)" = "12 8"
check "which ends" test "$(tail -1 creases.dxf)" = EOF

run cube.xyz other.ply --creases creases.stl
check "no other format" test "$status" -eq 2 -a ! -e other.ply
check "which says which there are" grep -q '\.obj, \.ply or \.dxf' stderr
run cube.xyz other.ply --creases other.ply
check "no file of two things" test "$status" -eq 2 -a ! -e other.ply
run cube.xyz other.ply --creases creases.obj --method lor
check "no creases of LOR" test "$status" -eq 2 -a ! -e other.ply
run cube.xyz other.ply --creases creases.obj --keep-density
check "none where the density is kept" test "$status" -eq 2 -a ! -e other.ply
run cube.xyz --output-directory all --creases creases.obj
check "none of a batch" test "$status" -eq 2 -a ! -e all
run cube.xyz other.ply --creases missing/creases.obj
check "a file that cannot be written is found before the work" test "$status" -eq 4 \
  -a ! -e other.ply

end_of_checks
