#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The option --page of the program l0_resample: a page that shows input and result.
# usage: test_tool_page.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"

{ cat cube.xyz; for place in '9 0 0' '0 20 1' '0 -2 40'; do echo "$place"; done; } > scan.xyz
name=$'\x3c!-- \x3cscript>.xyz'   # a page that has it as it is would end there
cp scan.xyz "$name"

data()   # of the page: the name of a block
{
  sed -n "s|^<script type=\"[a-z/]*\" id=\"$1\">\\(.*\\)</script>\$|\\1|p" page.html
}
bytes() { data "$1" | base64 -d | wc -c; }

run scan.xyz clean.ply --points 2000 --page page.html
check "a run that writes a page" test "$status" -eq 0
check "all points of the input but those that are left out" test "$(bytes input_points)" -eq 115200
check "no normals of an input without" test "$(bytes input_normals)" -eq 0
check "those that are left out" test "$(bytes left_out_points)" -eq 36
check "how far these are off" test "$(bytes left_out_distances)" -eq 12
check "all points of the result" test "$(bytes result_points)" -eq 24000
check "their normals" test "$(bytes result_normals)" -eq 6000
check "six numbers of each point" test "$(grep -c 'id="values_' page.html)" -eq 6
check "a number of each point" test "$(bytes values_5)" -eq 8000
check "nothing is asked of a network" test \
  "$(grep -cE 'src=|href=|@import|fetch\(' page.html)" -eq 0
check "no temporary files" no_temporary_files
run scan.xyz plain.ply --points 2000
check "the result is the same" cmp clean.ply plain.ply
run scan.xyz noise.ply --points 2000 --point-noise --page page.html
check "it has what was asked for" test "$(properties noise.ply | grep -o noise,)" = noise,
check "and nothing else" test "$(properties noise.ply | tr -cd , | wc -c)" -eq 7

make_inputs inward.xyz
run inward.xyz clean.ply --points 2000 --page page.html --method lor
check "a page of another method" test "$status" -eq 0
check "three numbers of each point" test "$(grep -c 'id="values_' page.html)" -eq 3
check "normals of the input" test "$(bytes input_normals)" -eq 28800

run "$name" clean.ply --points 20 --page page.html
check "a name that looks like an end of the script" test "$(grep -c '</script>' page.html)" \
  -eq "$(grep -c '<script' page.html)"

check_failure 2 "the extension of a page" cube.xyz other.ply --page page.txt
check_failure 2 "--page" cube.xyz --output-directory all --page page.html
check_failure 2 "--page" cube.xyz --as-one --memory 1GB --output-directory all --page page.html
check_failure 2 "--page" cube.xyz other.ply --convert-only --page page.html
check_failure 4 "missing" cube.xyz other.ply --page missing/page.html
check "nothing is written then" test ! -e other.ply -a ! -e all

end_of_checks
