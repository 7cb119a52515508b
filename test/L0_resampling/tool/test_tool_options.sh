#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Options of the program l0_resample: which it refuses, and those that a file may hold.
# usage: test_tool_options.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"
make_inputs viewed.xyz old.ply

# Wrong usage: 2
check_failure 2 "INPUT"
check_failure 2 "OUTPUT" cube.xyz
check_failure 2 "--nonsense" cube.xyz old.ply --nonsense
for value in 0 -5 1.5 x 99999999999999999999 4294967295; do
  check_failure 2 "--points" cube.xyz old.ply --points "$value"
done
for value in 0 1000001 0,5 nan -1; do
  check_failure 2 "--percentage" cube.xyz old.ply --percentage "$value"
done
for value in 0 -1 inf 1,5; do
  check_failure 2 "--neighbor-radius" cube.xyz old.ply --neighbor-radius "$value"
done
for value in -1 nan; do
  check_failure 2 "--normal-weight" cube.xyz old.ply --normal-weight "$value"
done
for value in 1,2 1,2,inf 1,2,3,4 1,2,3, 1,,3 "1 2 3"; do
  check_failure 2 "--viewpoint: '$value' is not three numbers separated by commas" \
    cube.xyz old.ply --viewpoint "$value"
done
check_failure 2 "--orient-by-normals" cube.xyz old.ply --viewpoint 0,0,9 --orient-by-normals
check_failure 2 "--up: '0,0,0' is not a direction" cube.xyz old.ply --up 0,0,0
check_failure 2 "--up: '0,1' is not three numbers" cube.xyz old.ply --up 0,1
check_failure 2 "--viewpoint" cube.xyz old.ply --viewpoint 0,0,9 --up 0,0,1
check_failure 2 "--view-property" cube.xyz old.ply --view-property view
check_failure 2 "--viewpoints" cube.xyz old.ply --viewpoints views.txt --up 0,0,1
awk '{ print $0, .01 }' cube.xyz > measured.xyz
columns=(--columns x,y,z,accuracy)
run measured.xyz each.ply "${columns[@]}" --noise-property accuracy --json each.json
check "the noise of each point" grep -q '"noise_property": "accuracy"' each.json
run measured.xyz all.ply "${columns[@]}" --noise .01
check "which is that of all where it is the same" cmp each.ply all.ply
awk '{ print $0, (NR % 2 ? .02 : .01) }' cube.xyz > measured.xyz
run measured.xyz each.ply "${columns[@]}" --noise-property accuracy
check "and is not where it differs" test "$(cmp each.ply all.ply > cmp.out; echo $?)" = 1
check_failure 2 "--noise" cube.xyz old.ply --noise-property accuracy --noise 0.1
check_failure 3 "--noise-property is given, but the points have no property 'accuracy'" \
  cube.xyz old.ply --noise-property accuracy
check_failure 3 "point_noise_map is given, expected the default method" \
  viewed.xyz old.ply --columns x,y,z,accuracy --noise-property accuracy --method lor
check_failure 2 "--noise-property" --as-one cube.xyz --output-directory old_tiles --memory 1G \
  --noise-property accuracy
by_views=(--viewpoints views.txt --view-property view)
check_failure 2 "--viewpoint" cube.xyz old.ply "${by_views[@]}" --viewpoint 0,0,9
check_failure 2 "--viewpoints" cube.xyz old.ply "${by_views[@]}" --up 0,0,1
check_failure 3 "the points have no property 'view'" cube.xyz old.ply "${by_views[@]}"
check_failure 3 "nowhere.txt" viewed.xyz old.ply --columns x,y,z,view --viewpoints nowhere.txt \
  --view-property view
check_misplaced()   # the message, and the line
{
  printf '# two viewpoints\n\n1 2 3\n%s\n' "$2" > misplaced.txt
  check_failure 3 "misplaced.txt: $1" \
    viewed.xyz old.ply --columns x,y,z,view --viewpoints misplaced.txt --view-property view
}
check_misplaced "line 4: 3 columns expected as in the lines before, found 2" "0 0"
check_misplaced "line 4: 3 columns expected as in the lines before, found 4" "0 0 0 1"
check_misplaced "line 4: '0,5' is not a number; --decimal-comma reads numbers such as 0,5" "0 0,5 0"
check_misplaced "a viewpoint is not finite" "0 inf 0"
printf 'S1 north 2 3\n' > named.txt
check_failure 3 \
  "named.txt: line 1: which of the columns are x, y and z is not told; a line before them" \
  cube.xyz old.ply --viewpoints named.txt
for view in 2 -1 0.5 nan; do
  awk -v view="$view" '{ print $0, (NR == 3 ? view : 1) }' cube.xyz > misviewed.xyz
  check_failure 3 \
    "the property 'view' of point 2 is $view, but --viewpoints has 2, counted from 0" \
    misviewed.xyz old.ply --columns x,y,z,view "${by_views[@]}"
done
for value in -1 3.1 much; do
  check_failure 2 "--outlier-sensitivity" cube.xyz old.ply --outlier-sensitivity "$value"
done
check_failure 2 "--outlier-sensitivity" \
  cube.xyz old.ply --outlier-sensitivity 1 --keep-outliers
for value in 0 91; do
  check_failure 2 "--sharpness-angle" cube.xyz old.ply --sharpness-angle "$value"
done
for value in 0 -1 two; do check_failure 2 "--threads" cube.xyz old.ply --threads "$value"; done
check_failure 2 "--seed" cube.xyz old.ply --seed -1
for value in 0,0,0 1,2 1,2,nan; do
  check_failure 2 "--view: '$value' is not" cube.xyz old.ply --view $value --snapshot picture.png
done
check_failure 2 "--method" cube.xyz old.ply --method best
check_failure 2 "--solver" cube.xyz old.ply --solver magic
check_failure 2 "--device" cube.xyz old.ply --device tpu
check_failure 2 "--percentage" cube.xyz old.ply --points 5 --percentage 5
for method in lor alor; do
  check_failure 2 "--keep-outliers: $method keeps all" \
    cube.xyz old.ply --method $method --keep-outliers
done
check_failure 2 "--solver-iterations: cholesky has none" \
  cube.xyz old.ply --solver cholesky --solver-iterations 5
check_failure 2 "--view: there is no --snapshot" cube.xyz old.ply --view 1,2,3
check_failure 2 "--snapshot-views: there is no --snapshot" cube.xyz old.ply --snapshot-views 2
for value in 0 5 two; do
  check_failure 2 "--snapshot-views: '$value' is not a whole number from 1 to 4" \
    cube.xyz old.ply --snapshot p.png --snapshot-views $value
done
check_failure 2 "--snapshot-colors: there is no --snapshot" \
  cube.xyz old.ply --snapshot-colors normals
check_failure 2 "--snapshot-colors" cube.xyz old.ply --snapshot p.png --snapshot-colors red
check_failure 2 "--output: one INPUT expected, found 2" cube.xyz old.ply -o out.ply
check_failure 2 "excludes" cube.xyz -o old.ply --output-directory batch
check_failure 2 "INPUT is required" -o old.ply
check_failure 2 "cube.doc: the extension" cube.doc old.ply
check_failure 2 "old.dat: the extension" cube.xyz old.dat
check_failure 2 "the extension of a snapshot" cube.xyz old.ply --snapshot picture.jpg
check_failure 2 "is named twice" cube.xyz old.ply --json ./old.ply
check_failure 2 "is named twice" cube.xyz old.ply --json cube.xyz
check "wrong usage writes nothing" is_old old.ply

# Options of a file, which the command line goes before
printf '%s\n' '# as always' '' 'points = 40' ' method=LOR ' 'quiet = false' 'force = true' \
  'keep-outliers = true' 'view = 1,2,3' > options.txt
run_plainly cube.xyz out.ply --config options.txt
check "options of a file" test "$status" -eq 0 -a "$(number_of_points out.ply)" -eq 40
check "a choice of a file" grep -q 'method lor' stdout
run_plainly cube.xyz out.ply --config options.txt -n 50 --method default
check "the command line goes before a file" test "$(number_of_points out.ply)" -eq 50
check "each option of it" grep -q 'method default' stdout
run_plainly --config options.txt --percentage 1 -- cube.xyz out.ply
check "also with what excludes an option of the file" test "$(number_of_points out.ply)" -eq 96
run_plainly cube.xyz out.ply --config options.txt --convert-only
check "a task without options of the file" test "$(number_of_points out.ply)" -eq 9600
echo 'quiet = true' > quiet.txt
run cube.xyz out.ply --points 5 --config quiet.txt
check "a flag of a file" test "$status" -eq 0 -a ! -s stdout
check_failure 2 "--config: none.txt: cannot be opened" cube.xyz old.ply --config none.txt
check_config()   # a line, and what is wrong with it
{
  printf 'seed = 1\n%s\n' "$1" > wrong.txt
  check_failure 2 "--config: wrong.txt: line 2: $2" cube.xyz old.ply --config wrong.txt
}
check_config "points 5" "option = value expected, found 'points 5'"
check_config "point = 5" "'point' is no option that a file may have"
check_config "n = 5" "'n' is no option"
check_config " = 5" "'' is no option"
check_config "FILES = old.ply" "'FILES' is no option"
for name in config output help version; do check_config "$name = x" "'$name' is no option"; done
check_config "points = 0" "--points: '0' is not a whole number"
check_config "points =" "--points"
check_config "method = best" "--method: best not in"
check_config "columns = x,y" "--columns x,y: x, y and z have"
check_config "quiet = yes" "quiet is true or false, found 'yes'"
check_config "seed = 2" "a second line seed"
printf 'points = 5\npercentage = 5\n' > wrong.txt
check_failure 2 "excludes" cube.xyz old.ply --config wrong.txt

end_of_checks
