#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The files of stream_scene: test_stream_scene_files.sh L0_RESAMPLE STREAM_SCENE MEASURE.
generator=$(realpath "$2") measure=$(realpath "$3")
# shellcheck source=test/L0_resampling/tool/tool_checks.sh
source "$(dirname "$0")/../tool/tool_checks.sh" "$1"

scan()   # options; a scan of 20001 points in 4 cells
{
  "$generator" --points 20001 --density 6 --truth "$@" > stdout 2> stderr
}

body()   # the bytes behind the header of a PLY
{
  LC_ALL=C sed '1,/^end_header$/d' "$1"
}

refused()   # a word of the reason, options
{
  local word=$1
  shift
  ! scan "$@" && grep -q -- "$word" stderr
}

check "a whole scan" scan whole.ply
check "blocks in one run" scan block.ply --blocks 12 --block 0-11
for block in 11 3 7; do
  check "a block alone" scan "alone_$block.ply" --blocks 12 --block "$block"
done
check "as in one run" cmp alone_11.ply block_11.ply
check "as in one run" cmp alone_3.ply block_03.ply
body whole.ply > whole
for file in block_*.ply; do body "$file"; done > blocks
check "20001 points" test "$(wc -c < whole)" = $((20001 * (6 * 8 + 1 + 4 + 3 * 4)))
check "blocks are the whole" cmp whole blocks

# LAS: all blocks are on one lattice, that of the coordinates
check "a whole scan in LAS" scan whole.las
check "blocks in LAS" scan block.las --blocks 3 --block 0-2
for name in whole block_0 block_1 block_2; do
  check "read" "$program" --convert-only "$name.las" "las_$name.ply" --quiet
done
body las_whole.ply > whole
for file in las_block_*.ply; do body "$file"; done > blocks
check "blocks are the whole in LAS" cmp whole blocks

# what the tool makes of it
check "stations" scan whole.ply --stations stations.txt
check "a station and the aircraft" test "$(wc -l < stations.txt)" = 2
check "resampled" "$program" --force whole.ply clean.ply --points 5000 --quiet \
  --viewpoints stations.txt --view-property view --keep-classes 2,5,6,64,65

# how good that is
measured()   # a line of measure_in_scene, the least and the largest number in it, files
{
  local line=$1 low=$2 high=$3
  shift 3
  "$measure" --points 20001 --density 6 "$@" > stdout 2> stderr || return 1
  awk -v line="$line" -v low="$low" -v high="$high" \
    'index($0, line) == 1 { n = substr($0, 18) + 0; found = n >= low && n <= high }
     END { exit !found }' stdout
}

check "the scan without outliers" scan exact.ply --outliers 0 --noise 0
check "all points are there" measured points 20001 20001 block_*.ply
check "outliers are off" measured farther 0.1 0.3 whole.ply
check "nothing is off" measured farther 0 0 exact.ply
check "the lattice alone" measured largest 0.00001 0.0001 exact.ply
check "true normals" measured "mean angle" 0 0.1 exact.ply
check "on their sides" measured "on wrong" 0 0.1 exact.ply
check "noise along rays" measured "mean distance" 0.0005 0.01 whole.ply
check "the result is on the scene" measured "mean distance" 0.001 0.1 clean.ply

check "few are on wrong sides" measured "on wrong" 0 8 clean.ply

check "a block too many" refused "--block 4" x.ply --blocks 4 --block 4
check "blocks in the wrong order" refused "--block 2-1" x.ply --blocks 4 --block 2-1
check "no block" refused "--block 1-" x.ply --blocks 4 --block 1-
check "a format without a lattice" refused "x.xyz" x.xyz
check "a share of 2" refused "share of outliers" x.ply --outliers 2

end_of_checks
