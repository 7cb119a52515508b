#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The option --outliers of the program l0_resample: a file of the points that are left out.
# usage: test_tool_outliers.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"

cp cube.xyz scan.xyz
for place in '9 0 0' '0 20 1' '0 -2 40'; do echo "$place" >> scan.xyz; done

run scan.xyz clean.ply --outliers outliers.xyz --json report.json
check "a run that writes outliers" test "$status" -eq 0
check "they are the points that are off" test \
  "$(awk '{ print $1, $2, $3 }' outliers.xyz)" = "$(tail -3 scan.xyz)"
check "as many as are counted" grep -q '"outliers": 3' report.json
run scan.xyz plain.ply
check "the result is the same" cmp clean.ply plain.ply

run scan.xyz clean.ply --outliers outliers.ply
check "as PLY" grep -q '^element vertex 3' <(head -c 300 outliers.ply)
run cube.xyz clean.ply --outliers outliers.ply
check "no points where none is left out" grep -q '^element vertex 0' <(head -c 300 outliers.ply)

awk '{ print $0, NR }' scan.xyz | sed '1i x y z number' | tr ' ' ',' > numbered.csv
run numbered.csv clean.ply --outliers outliers.ply
check "properties are those of the points" grep -q ' number' <(head -c 400 outliers.ply)

check_failure 2 "--outliers" cube.xyz other.ply --outliers outliers.stl
check_failure 2 "not written" cube.xyz other.ply --outliers outliers.csv
check_failure 2 "" cube.xyz other.ply --outliers other.ply
check_failure 2 "leaves none out" cube.xyz other.ply --outliers outliers.ply --method lor
check_failure 2 "--keep-outliers" cube.xyz other.ply --outliers outliers.ply --keep-outliers
check_failure 2 "--outliers" cube.xyz --output-directory all --outliers outliers.ply
check_failure 4 "missing" cube.xyz other.ply --outliers missing/outliers.ply
check "nothing is written then" test ! -e other.ply -a ! -e all
tiles=(scan.xyz --as-one --memory 4GB --output-directory)
run "${tiles[@]}" tiles --outliers outliers.xyz
check "those of a run by tiles" test "$status" -eq 0 -a \
  "$(awk '{ print $1, $2, $3 }' outliers.xyz | sort)" = "$(tail -3 scan.xyz | sort)"
check_failure 2 "is the name of a tile" "${tiles[@]}" other \
  --outliers other/tile_0.xyz --output-format xyz
check_failure 4 "missing" "${tiles[@]}" other --outliers missing/o.ply
run scan.xyz other.ply --outliers outliers.ply --method lor --outlier-sensitivity 1
check "those of LOR" grep -q '^element vertex 3' <(head -c 300 outliers.ply)

end_of_checks
