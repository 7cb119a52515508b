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
run cube.xyz clean.ply --force --creases creases.DXF
check "lines as DXF" test "$status" -eq 0 \
  -a "$(grep -c '^POLYLINE$' creases.DXF) $(grep -c '^POINT$' creases.DXF)" = "12 8"
check "which ends" test "$(tail -1 creases.DXF)" = EOF

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

# A beam in two files, whose tiles need less than all of it around them
awk 'BEGIN { srand(3); for (i = 0; i < 66000; ++i) {
  k = i % 4; x = 672 * rand(); p[0] = 12 * rand(); p[1] = 12 * rand()
  if (rand() < .009) x = k < 2 ? 0 : 672
  else p[int(k / 2)] = 12 * (k % 2)
  printf "%.6f %.6f %.6f\n", x + .06 * (rand() - .5), p[0] + .06 * (rand() - .5),
         p[1] + .06 * (rand() - .5) } }' > beam.xyz
head -n 40000 beam.xyz > first.xyz
tail -n +40001 beam.xyz > second.xyz
memory=$(((96 << 20) + 17500000))
tiled=(first.xyz second.xyz --as-one --points 32000 --memory "$memory" --halo 50)
run beam.xyz whole.ply --points 32000 --creases whole.obj
check "twelve lines along a beam" test "$(grep -c '^l ' whole.obj) $(grep -c '^p ' whole.obj)" = \
  "12 8"
run "${tiled[@]}" --output-directory tiles --output merged.ply --creases tiles.obj --json tiles.json
check "creases by tiles" test "$status" -eq 0
check "of several tiles" test "$(find tiles -name 'tile_*.ply' | wc -l)" -ge 2
check "a phase finds them" grep -q '"name": "creases"' tiles.json
check "lines go on across seams: the file of a call in memory" cmp whole.obj tiles.obj
check "with as many points" test "$(number_of_points merged.ply)" -eq 32000
check "and the same property" test "$(properties merged.ply)" = "$(properties whole.ply)"
rows_of() { tail -c $((32000 * 49)) "$1" | od -An -v -w49 -t x1 | sort; }
check "and the same points, normals and marks" cmp <(rows_of whole.ply) <(rows_of merged.ply)
run "${tiled[@]}" --output-directory without --output without.ply
check "which are moved for creases only" test "$(comm -13 \
  <(tail -c $((32000 * 48)) without.ply | od -An -v -w48 -t x1 | sort) \
  <(rows_of merged.ply | cut -c 1-144 | sort) | wc -l)" -lt 16000
check_failure 2 "is the name of a tile" "${tiled[@]}" --output-directory other \
  --creases other/tile_0.ply
check_failure 2 "is named twice" "${tiled[@]}" --output-directory other --output a.ply \
  --creases a.ply
check_failure 4 "missing" "${tiled[@]}" --output-directory other --creases missing/creases.obj
for task in begin count:0 count:1 blocks shard:0 shard:1 scales; do
  run_plainly "${tiled[@]}" --output-directory tasks --creases again.obj --task $task
done
check_plain_failure 2 "--resume: the run began with --creases 1, now it is --creases 0" \
  "${tiled[@]}" --output-directory tasks --resume
run_plainly "${tiled[@]}" --output-directory tasks --creases again.obj --resume
check "a run with creases goes on" test "$status" -eq 0
check "with the same lines" cmp whole.obj again.obj

end_of_checks
