#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the program l0_resample does but for resampling: conversions, facts of an input, dry runs.
# usage: test_tool_other_tasks.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"
make_inputs attributes.ply bad.xyz scans same.ply same.xyz old.ply

# Conversions: points as they are, with what the format can hold
printf '%s\n' ply 'format ascii 1.0' 'element vertex 2' \
  'property float x' 'property float y' 'property float z' \
  'property uchar red' 'property uchar green' 'property uchar blue' 'property double time' \
  end_header '0.1 2 3 255 128 0 1e9' '4 5 6 1 2 3 0.3' > rich.ply
run --convert-only rich.ply rich.pcd
check "a conversion" test "$status" -eq 0 -a ! -s stderr
check "the summary of a conversion" grep -qx 'rich.ply: 2 points in, 2 out, converted' stdout
check "fields of a conversion" grep -qax 'FIELDS x y z rgb time' rich.pcd
run --convert-only rich.pcd back.ply
run --convert-only rich.ply again.ply
check "there and back again" cmp back.ply again.ply
run --convert-only rich.pcd rich.off
check "what a format cannot hold is told" \
  grep -qxF "l0_resample: warning: rich.off: the format has no place for the property 'time'" stderr
check "colors of OFF" cmp rich.off <(printf 'COFF\n2 0 0\n0.1 2 3 255 128 0\n4 5 6 1 2 3\n')
run --convert-only rich.off rich.xyz --quiet
check "a quiet conversion" cmp rich.xyz <(printf '0.1 2 3\n4 5 6\n')
check "quiet means quiet" test ! -s stdout -a ! -s stderr
run --convert-only same.ply same_again.xyz
check "normals of a conversion" cmp same.xyz same_again.xyz
check_failure 3 "line 9601" --convert-only bad.xyz old.ply
run --convert-only bad.xyz good.xyz --drop-non-finite
check "points dropped by a conversion" \
  grep -qx 'bad.xyz: 9600 points in, 2 dropped, 9600 out, converted' stdout
check_failure 3 "--max-points" --convert-only cube.xyz old.ply --max-points 9599
check_failure 1 "--max-memory" --convert-only cube.xyz old.ply --max-memory 10kb
check_failure 4 "no/out.ply" --convert-only cube.xyz no/out.ply
for option in "--points 5" "--percentage 5" "--method lor" "--json report.json" --strict \
    --use-normals; do
  # shellcheck disable=SC2086
  check_failure 2 "--convert-only" --convert-only cube.xyz old.ply $option
done
check "a refused conversion writes nothing" is_old old.ply
run --convert-only scans --output-directory batch/converted --output-format ply
check "a batch of conversions" test "$status" -eq 3 \
  -a "$(number_of_points batch/converted/a.ply)" -eq 9600 \
  -a "$(ls batch/converted)" = "$(printf 'a.ply\nb.ply\nd.ply')"

# Normals get their side, and nothing else changes
awk '{ a = $1; b = $2; c = $3; for (k = 1; k <= 3; ++k) n[k] = 0
  m = a * a > b * b ? 1 : 2; if (c * c > $m * $m) m = 3
  n[m] = ($m > 0 ? 1 : -1) * (NR % 3 ? 1 : -1);
  print $0, n[1], n[2], n[3], NR }' cube.xyz > signs.csv
sed -i '1i x,y,z,nx,ny,nz,time' signs.csv && sed -i 's/ /,/g' signs.csv
run --orient-only signs.csv oriented.ply
check "normals are oriented" test "$status" -eq 0
check "the summary of an orientation" \
  grep -qE "^signs.csv: 9600 points in, 9600 out, oriented, .* s, [0-9]+ % of the normals expected \
on the right side" stdout
run --convert-only oriented.ply oriented.pcd
run --convert-only signs.csv signs.pcd
check "sizes and properties stay" cmp <(wc -c < oriented.pcd) <(wc -c < signs.pcd)
run --convert-only oriented.ply oriented.xyz
run --convert-only signs.csv signs.xyz
share_outwards='{ outwards += $1 * $4 + $2 * $5 + $3 * $6 > 0 } END { print outwards / NR, NR }'
check "points and their order stay, normals change their sign only" \
  cmp <(awk '{ print $1, $2, $3, $4 ^ 2, $5 ^ 2, $6 ^ 2 }' oriented.xyz) \
  <(awk '{ print $1, $2, $3, $4 ^ 2, $5 ^ 2, $6 ^ 2 }' signs.xyz)
check "normals were of both signs" \
  test "$(awk "$share_outwards" signs.xyz)" = "0.666667 9600"
check "they point outwards" \
  test "$(awk "$share_outwards" oriented.xyz | awk '{ print ($1 > 0.995), $2 }')" = "1 9600"
# What is written are unit vectors, whatever the length was
awk -F , 'NR > 1 { print $1, $2, $3, 3 * $4, 3 * $5, 3 * $6, $7 }' signs.csv > long.txt
run --orient-only long.txt long.xyz --columns x,y,z,nx,ny,nz,time
check "a warning counts the others" grep -qx "l0_resample: warning: long.txt: 9600 normals are no \
unit vectors, and are scaled to length 1" stderr
check "unit vectors" cmp long.xyz oriented.xyz
run --orient-only cube.xyz estimated.xyz --viewpoint 0,0,0 --json orient.json
check "normals are estimated, and face the viewpoint" \
  test "$(awk "$share_outwards" estimated.xyz | awk '{ print ($1 < 0.005), $2 }')" = "1 9600"
check "the report of an orientation" grep -q '"hinted_share": 1.0' orient.json
run --orient-only signs.csv turned.xyz --orient-by-normals --neighbor-radius 0.1 --threads 1
check "the side of most normals" test "$status" -eq 0
run_plainly --orient-only cube.xyz nothing.ply --dry-run
check "a dry orientation" test "$(cat stdout)" = \
  "cube.xyz: 9600 points in, 9600 would be written to nothing.ply, oriented" -a ! -e nothing.ply
check_failure 3 "has no normals" --orient-only cube.xyz old.ply --orient-by-normals
check_failure 3 "line 9601" --orient-only bad.xyz old.ply
check_failure 1 "--max-memory" --orient-only cube.xyz old.ply --max-memory 1mb
check_failure 4 "no/out.ply" --orient-only cube.xyz no/out.ply
CUDA_VISIBLE_DEVICES=-1 check_failure 1 "--device cuda" --orient-only cube.xyz old.ply --device cuda
CUDA_VISIBLE_DEVICES=-1 run --orient-only cube.xyz estimated.xyz --device auto --json orient.json
check "an orientation falls back to the processor" grep -q '"used": "cpu"' orient.json
for option in "--points 5" "--percentage 5" "--method lor" --use-normals --convert-only \
    --keep-outliers "--solver cholesky" "--snapshot x.png"; do
  # shellcheck disable=SC2086
  check_failure 2 "--orient-only" --orient-only cube.xyz old.ply $option
done
check "a refused orientation writes nothing" is_old old.ply
run --orient-only scans --output-directory batch/oriented --output-format ply
check "a batch of orientations" test "$status" -eq 3 \
  -a "$(number_of_points batch/oriented/a.ply)" -eq 9600

# What an input is
fact() { sed -n "s/^$1: *//p" stdout; }
run_plainly --info cube.xyz
check "facts of an input" test "$status" -eq 0 -a ! -s stderr -a "$(wc -l < stdout)" -eq 11
check "its name and format" test "$(fact file)" = "cube.xyz, xyz"
check "its number of points" test "$(fact points)" = 9600
numbers=$(fact extent | grep -oE '[-0-9.]+')
check "its extent" test "$(awk '{ $1 = $1 < 0 ? -$1 : $1 }
  NR < 7 { wrong += $1 < .49 || $1 > .52 } NR == 7 { wrong += $1 < 1.7 || $1 > 1.8 }
  END { print wrong + 0, NR }' <<< "$numbers")" = "0 7"
is_between() { awk "BEGIN { exit !($1 > $2 && $1 < $3) }"; }   # three numbers
check "its normals, properties and viewpoint" \
  test "$(fact normals), $(fact properties), $(fact viewpoint)" = "no, none, not told"
check "its spacing, 1 / 39 and the noise" is_between "$(fact spacing)" .022 .029
check "its noise, 0.02 / sqrt(12) across" is_between "$(fact noise)" .004 .008
check "the defaults" test "$(fact method), $(fact 'points to write')" = "default, 4800"
radius=$(fact 'neighbor radius')
run cube.xyz out.ply --json info.json
of_run=$(sed -n 's/ *"neighbor_radius": \(.*\),/\1/p' info.json)
check "the radius is that of a run" is_between "$radius" ".9999 * $of_run" "1.0001 * $of_run"
run_plainly --info cube.xyz --method lor --percentage 10 --quiet --force
check "the defaults of another method" \
  test "$(fact 'points to write')" = 960 -a "$(fact 'neighbor radius')" != "$radius"
sed 's/^VIEWPOINT .*/VIEWPOINT 1 -2 0.5 1 0 0 0/' same.pcd > seen.pcd
run_plainly --info seen.pcd
check "a viewpoint and normals" test "$(fact viewpoint), $(fact normals)" = "1,-2,0.5, yes"
run_plainly --info attributes.ply
check "properties" test "$(fact properties)" = "red, label, height"
run_plainly --info bad.xyz --drop-non-finite
check "points that are not finite" test "$(fact points)" = "9600, and 2 that are not finite"
echo 0 > zero.xyz
run_plainly --info zero.xyz
check "facts of no points" test "$status" -eq 0 -a "$(fact points)" = 0
printf '1 2 3\n1 2 3\n' > place.xyz
run_plainly --info place.xyz
check "facts of one place" test "$status" -eq 0 \
  -a "$(fact spacing)" = "all points are at one place" \
  -a "$(fact extent)" = "from 1,2,3 to 1,2,3, diagonal 0"
check_plain_failure 3 "missing.ply" --info missing.ply
check_plain_failure 2 "--info: one INPUT expected, found 2 files" --info cube.xyz old.ply
for option in "-o x.ply" "--json x.json" --dry-run "--output-directory x"; do
  # shellcheck disable=SC2086
  check_plain_failure 2 "--info" --info cube.xyz $option
done

# All but the work
mkdir dry
run_plainly cube.xyz dry/out.ply --dry-run --json dry/out.json --snapshot dry/out.png
check "a dry run" test "$status" -eq 0 -a ! -s stderr
plan="4800 would be written to dry/out.ply, method default, neighbor radius $radius"
check "what it would do" test "$(cat stdout)" = "cube.xyz: 9600 points in, $plan"
check "it writes nothing" test -z "$(ls dry)"
run_plainly bad.xyz dry/out.ply --dry-run --convert-only --drop-non-finite
plan="9600 would be written to dry/out.ply, converted"
check "a dry conversion" test "$(cat stdout)" = "bad.xyz: 9600 points in, 2 dropped, $plan" \
  -a -z "$(ls dry)"
run_plainly scans --dry-run --output-directory dry/a/b --snapshot dry/c --json dry/out.json
check "a dry batch" test "$status" -eq 3 -a -z "$(ls dry)" \
  -a "$(grep -c 'would be written to dry/a/b/' stdout)" -eq 3
check_plain_failure 4 "old.ply: the file exists" cube.xyz old.ply --dry-run
check_failure 4 "no/out.ply" cube.xyz no/out.ply --dry-run
check_failure 4 "no/out.png" cube.xyz dry/out.ply --snapshot no/out.png --dry-run
check_failure 4 "cube.xyz/inside: cannot be made" \
  scans/a.xyz --output-directory cube.xyz/inside --dry-run
check_failure 3 "bad.xyz: line 9601" bad.xyz old.ply --dry-run
check_failure 3 "has no normals" cube.xyz old.ply --dry-run --use-normals
CUDA_VISIBLE_DEVICES=-1 check_failure 1 "--device cuda" cube.xyz old.ply --device cuda --dry-run
check "dry failures write nothing" test -z "$(ls dry)" -a "$(cat old.ply)" = old

end_of_checks
