#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Good runs of the program l0_resample: what it writes and prints, and what changes the result.
# usage: test_tool_cli.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"
make_inputs attributes.ply inward.xyz viewed.xyz old.ply

# Properties of the points go along: of labels the nearest, of other numbers and of colors a mean
run attributes.ply carried.ply --source-index --feature-confidence --snapshot features.png
check "a run with properties" test "$status" -eq 0
check "all properties in order" test "$(properties carried.ply)" = \
  "$(printf '%s,' 'double x' 'double y' 'double z' 'double nx' 'double ny' 'double nz' \
    'uchar red' 'int label' 'float height' 'uint source_index' 'float feature_confidence')"
# red is byte 49 of a row of 65, and the label the four behind it
tail -c $((4800 * 65)) carried.ply | od -An -v -w65 -t u1 > rows.txt
check "labels of points, and colors between those of points" test "$(awk '
  { label = $50 " " $51 " " $52 " " $53
    wrong += label != "7 0 0 0" && label != "144 238 254 255" || $49 < 100 || $49 > 200
    mixed += $49 > 100 && $49 < 200 }
  END { print wrong + 0, (mixed > 10 && mixed < 480) }' rows.txt)" = "0 1"
run cube.xyz noises.ply --point-radius --point-noise
check "radius and noise of each point" test "$status" -eq 0 -a "$(properties noises.ply)" = \
  "$(printf '%s,' 'double x' 'double y' 'double z' 'double nx' 'double ny' 'double nz' \
    'float neighbor_radius' 'float noise')"
run cube.xyz deviations.ply --point-deviation
check "deviations of each point" test "$status" -eq 0 -a "$(properties deviations.ply)" = \
  "$(printf '%s,' 'double x' 'double y' 'double z' 'double nx' 'double ny' 'double nz' \
    'float position_deviation' 'float normal_deviation')"
run cube.xyz lor.ply --method lor --point-noise
check "no noise of LOR" test "$status" -ne 0 -a ! -e lor.ply
check "which says why" grep -q 'noise_map is given, expected the default method' stderr
run cube.xyz plain.ply
run carried.ply positions.xyz --convert-only
run plain.ply plain.xyz --convert-only
check "properties change no point" cmp -s positions.xyz plain.xyz
# Labels with digits behind the point too, and where there are no data, these are no numbers
{
  printf 'ply\nformat ascii 1.0\nelement vertex 9600\n'
  printf 'property %s\n' 'double x' 'double y' 'double z' 'float kind' 'float depth'
  printf 'end_header\n'
  awk '{ print $0, ($1 > 0 ? 0.5 : 1.5), (NR % 5 == 0 || $2 > 0.4 ? -9999 : 2 + $3) }' cube.xyz
} > measured.ply
run measured.ply measured_carried.ply
tail -c $((4800 * 56)) measured_carried.ply | od -An -v -w56 -t f4 \
  | awk '{ print $13, $14 }' > rows.txt
check "labels are no means" \
  test "$status" -eq 0 -a "$(cut -d ' ' -f 1 rows.txt | sort -u | tr '\n' ' ')" = "0.5 1.5 "
check "nor are what stands for no data" test "$(awk '
  { bad += $2 != -9999 && ($2 < 1 || $2 > 3); none += $2 == -9999 }
  END { print bad + 0, (none > 200 && none < 2400) }' rows.txt)" = "0 1"
# What was measured in two passes of a scanner is that of one of them: the last 12 bytes of a row
# of 60
{
  printf 'ply\nformat ascii 1.0\nelement vertex 9600\n'
  printf 'property %s\n' 'double x' 'double y' 'double z' 'double gps_time' 'float scan_angle'
  printf 'end_header\n'
  awk '{ print $0, ($1 > 0 ? "200 9" : "100 -9") }' cube.xyz
} > passes.ply
run passes.ply passes_carried.ply
check "times and angles of LAS are no means" test "$status" -eq 0 \
  -a "$(tail -c $((4800 * 60)) passes_carried.ply | od -An -v -w60 -t x1 | cut -c 145- \
    | sort -u | wc -l)" -eq 2
# Under other names too, and what has several values in its bits: columns of 8 and 4 bytes, of which
# there are too many values for labels
for names in "scalar_GpsTime ScanAngleRank" "Timestamp rgb"; do
  # shellcheck disable=SC2086
  set -- $names
  sed "s/gps_time/$1/; s/scan_angle/$2/" passes.ply \
    | awk 'NF == 5 { $4 += NR % 1000 / 1024; $5 += NR % 1000 / 1024 } { print }' > named_passes.ply
  run named_passes.ply of_points.ply --convert-only
  run named_passes.ply named_carried.ply
  tail -c $((9600 * 36)) of_points.ply | od -An -v -w36 -t x1 | cut -c 73- | sort -u > of_points
  tail -c $((4800 * 60)) named_carried.ply | od -An -v -w60 -t x1 | cut -c 145- | sort -u > carried
  check "no means of $names" test "$status" -eq 0 -a "$(wc -l < of_points)" -gt 1900 \
    -a "$(wc -l < carried)" -gt 1000 -a -z "$(comm -13 of_points carried)"
done
run carried.ply carried.off --convert-only --quiet
run attributes.ply attributes.xyz --quiet
check "a format without room for properties" test "$status" -eq 0
run attributes.ply attributes.xyz
check "a warning of what is left out" grep -q "no place for the property 'label'" stderr

# Where normals point to
run cube.xyz cube.pcd --convert-only
LC_ALL=C sed 's/^VIEWPOINT 0 0 0 /VIEWPOINT 0 0 0.1 /' cube.pcd > seen.pcd
for options in "cube.xyz in.xyz --viewpoint 0,0,0.1" "inward.xyz in.xyz --orient-by-normals" \
    "seen.pcd in.xyz" \
    "viewed.xyz in.xyz --columns x,y,z,view --viewpoints views.txt --view-property view"; do
  # shellcheck disable=SC2086
  run $options --json in.json
  check "all normals inwards: $options" \
    test "$(awk '$1 * $4 + $2 * $5 + $3 * $6 > 0' in.xyz | wc -l)" -eq 0
  check "the report says so" grep -q '"hinted_share": 1' in.json
done
# Without a property that says from where, it is the place that sees best
run cube.xyz in.xyz --viewpoints views.txt
check "all normals to the viewpoints that see them" \
  test "$(awk '$1 * $4 + $2 * $5 + $3 * $6 > 0' in.xyz | wc -l)" -eq 0
check "a note says so" grep -q "that of the 2 viewpoints which sees it best" stderr
# A list of places, as other programs write one, is read as points are
cp in.xyz by_list.xyz
grep -v '#' views.txt > places.txt
head -n 1 places.txt > place.txt
run cube.xyz one.xyz --viewpoints place.txt
check "of one place there is no choice" grep -q "seen from the only viewpoint$" stderr
sed 's/ /,/g' places.txt > places.csv
{ printf '\xef\xbb\xbf'; sed 's/$/\r/' places.txt; } > windows.txt
{ echo 'Station;X;Y;Z'; awk '{ print "S" NR ";" $1 ";" $2 ";" $3 }' places.txt; } > stations.csv
{ echo '//X Y Z'; wc -l < places.txt; cat places.txt; } > counted.pts
awk '{ print "S" NR, $0 }' places.txt > named.txt
{ echo '# id x y z'; awk '{ print NR, $0 }' places.txt; } > numbered.txt
run --convert-only places.txt places.ply
{ echo 'x;y;z'; sed 's/ /;/g; s/\./,/g' places.txt; } > commas.csv
for places in places.csv windows.txt stations.csv counted.pts named.txt numbered.txt places.ply \
    "commas.csv --decimal-comma"; do
  rm -f in.xyz
  # shellcheck disable=SC2086
  run cube.xyz in.xyz --viewpoints $places
  check "the places of $places" cmp -s by_list.xyz in.xyz
done
printf '2,0 1,5 1,2\n6,0 1,5 1,3\n' > unread.txt
check_failure 3 "can name them; --decimal-comma reads numbers such as 0,5" \
  cube.xyz in.xyz --viewpoints unread.txt
awk '{ print NR, $0 }' places.txt > unnamed.txt
check_failure 3 "which of the columns are x, y and z is not told; a line before them" \
  cube.xyz in.xyz --viewpoints unnamed.txt
rm -f in.xyz
run --convert-only cube.xyz cube.ply
run cube.ply in.xyz --viewpoints commas.csv --decimal-comma
check "a decimal comma in the places alone" cmp -s by_list.xyz in.xyz
{ awk '{ print $1, $2, $3 }' cube.xyz; awk '{ print $1 + 9, $2, $3 }' cube.xyz; } > two.xyz
printf '0 0 0\n8 0 0\n' > two.txt
run two.xyz two_seen.xyz --viewpoints two.txt
check "one cube from within" \
  test "$(awk '$1 < 4 && $1 * $4 + $2 * $5 + $3 * $6 > 0' two_seen.xyz | wc -l)" -eq 0
check "the other one from the left" \
  test "$(awk '$1 > 9.4 && $2 ^ 2 < .1 && $3 ^ 2 < .1 && $4 > 0' two_seen.xyz | wc -l)" -eq 0
# The place next to a wall, but behind it, did not see it: two rooms with a wall of 0.3 between them
awk 'function face(axis, at, low_b, end_b, low_c, end_c,   b, c, p) {
       for (b = low_b + 0.05; b < end_b; b += 0.1)
         for (c = low_c + 0.05; c < end_c; c += 0.1) {
           p[axis] = at; p[(axis + 1) % 3] = b; p[(axis + 2) % 3] = c
           print p[0], p[1], p[2]
         }
     }
     function room(low, end,   side) {
       for (side = 0; side < 2; ++side) {
         face(0, side ? end : low, 0, 2, 0, 2)
         face(1, 2 * side, 0, 2, low, end)
         face(2, 2 * side, low, end, 0, 2)
       }
     }
     BEGIN { room(-5, 0); room(0.3, 2.3) }' > rooms.xyz
printf -- '-4.5 1 1\n0.8 1 1\n' > stations.txt
run --orient-only rooms.xyz rooms_seen.xyz --viewpoints stations.txt
check "a wall from its own room" \
  test "$(awk '$1 == 0 && $2 > 0.2 && $2 < 1.8 && $3 > 0.2 && $3 < 1.8' rooms_seen.xyz | wc -l)" \
       -eq 256 \
  -a "$(awk '$1 == 0 && $2 > 0.2 && $2 < 1.8 && $3 > 0.2 && $3 < 1.8 && $4 > 0' rooms_seen.xyz \
        | wc -l)" -eq 0
echo '# nothing' > none.txt
check_failure 3 "none.txt: line 2: the file has no points" cube.xyz in.xyz --viewpoints none.txt
awk 'BEGIN { print "ply\nformat ascii 1.0\nelement vertex 9600"
             for (k = 0; k < 3; ++k) print "property float " substr("xyz", k + 1, 1)
             print "element camera 1"
             for (k = 0; k < 3; ++k) print "property float view_p" substr("xyz", k + 1, 1)
             print "end_header" } { print } END { print "0 0 0.1" }' cube.xyz > camera.ply
run camera.ply in.xyz
check "all normals to the camera" \
  test "$(awk '$1 * $4 + $2 * $5 + $3 * $6 > 0' in.xyz | wc -l)" -eq 0

# What a closed surface alone tells is said to be taken for right
outwards="taking outwards for right (--viewpoint for a room seen from within)"
run cube.xyz out.xyz --json out.json
check "outwards is assumed" grep -qF "$outwards" stdout
check "the report says so" grep -q '"outwards_assumed": true' out.json
check "what was found of the points" grep -qE '"estimated_noise": [0-9.e-]*[1-9]' out.json
check "and how far they are apart" grep -qE '"estimated_spacing": [0-9.e-]*[1-9]' out.json
for options in "--viewpoint 0,0,0.1 cube.xyz" "--viewpoint none cube.xyz" "--up 0,0,1 cube.xyz" \
    seen.pcd; do
  # shellcheck disable=SC2086
  run $options out.xyz --json out.json
  check "and not said beside: $options" \
    test "$status" -eq 0 -a "$(grep -cF "$outwards" stdout)" -eq 0
  check "nor in the report" grep -q '"outwards_assumed": false' out.json
done

run cube.xyz down.xyz --up 0,0,-3
check "all normals down, but of the sides" test "$(awk '$6 > 0.2' down.xyz | wc -l)" -eq 0
run seen.pcd seen.xyz
note="seen.pcd: normals face the viewpoint of the file, 0,0,0.1, unless --viewpoint none is given"
check "a note on the viewpoint of the file" grep -qx "l0_resample: note: $note" stderr
run seen.pcd outward.xyz --viewpoint none
check "no viewpoint if none is asked for" test "$status" -eq 0 -a ! -s stderr
run cube.pcd plain.xyz
check "which is as if the file had none" cmp -s outward.xyz plain.xyz
run seen.pcd up.xyz --up 0,0,1 --json up.json
check "no note beside another side" test "$status" -eq 0 -a ! -s stderr
check "nor a viewpoint in the report" grep -q '"viewpoint": null' up.json

# PCD keeps the single viewpoint of a call
check_viewpoint()   # the one expected, and the program's arguments but for the output
{
  run "${@:2}" written.pcd
  check "the viewpoint of: ${*:2}" grep -qax "VIEWPOINT $1 1 0 0 0" written.pcd
}
check_viewpoint "0 0 0.1" seen.pcd
check_viewpoint "0 0 0.1" --convert-only seen.pcd
check_viewpoint "1 -2 0.5" --viewpoint 1,-2,0.5 cube.xyz
check_viewpoint "1 -2 0.5" --viewpoint 1,-2,0.5 seen.pcd
for options in "cube.xyz" "--viewpoint none seen.pcd" "--up 0,0,1 seen.pcd" \
    "--columns x,y,z,view --viewpoints views.txt --view-property view viewed.xyz"; do
  # shellcheck disable=SC2086
  check_viewpoint "0 0 0" $options
done

run plain.ply plain.xyz --convert-only
run cube.xyz kept.xyz --keep-density
check "an even result is another one" test "$(cmp -s kept.xyz plain.xyz; echo $?)" -eq 1

# Good runs
run cube.xyz out.ply
check "a good run" test "$status" -eq 0
check "half of the points by default" test "$(number_of_points out.ply)" -eq 4800
check "nothing on stderr" test ! -s stderr
check "one line on stdout" test "$(wc -l < stdout)" -eq 1
summary="9600 points in, 4800 out, method default, [0-9.]+ s, [0-9]+ % of the normals expected \
on the right side, taking outwards for right \(--viewpoint for a room seen from within\)"
check "the summary" grep -qE "^cube.xyz: $summary\$" stdout
run cube.xyz out.ply --neighbor-radius 0.0001 --json small.json
check "a radius with hardly a point in it warns" \
  test "$status" -eq 0 -a "$(grep -c warning: stderr)" -ge 1
check "the warning says why" \
  grep -q '^l0_resample: warning: cube.xyz: 100.0 % of the points have fewer than six' stderr
check "the report says so too" grep -q '^ *"small_radius"' small.json
run cube.xyz out.ply --neighbor-radius 0.0001 --quiet
check "quiet warns nobody" test ! -s stderr
run inward.xyz out.ply
note="inward.xyz: the file has normals, which --orient-by-normals lets decide the side"
check "normals that could decide the side" grep -qx "l0_resample: note: $note" stderr
for options in --orient-by-normals "--viewpoint 0,0,9" "--up 0,0,1"; do
  # shellcheck disable=SC2086
  run inward.xyz out.ply $options
  check "no note with $options" test "$status" -eq 0 -a ! -s stderr
done
run cube.xyz out.ply --points 123 --method alor --quiet
check "quiet" test "$status" -eq 0 -a ! -s stdout -a ! -s stderr
check "exact number of points" test "$(number_of_points out.ply)" -eq 123
run cube.xyz out.ply --percentage 12.5 --method lor
check "percentage" test "$(number_of_points out.ply)" -eq 1200
check "method in the summary" grep -q 'method lor' stdout
run cube.xyz out.ply --percentage 12.51   # of 9600: 1200.96
check "a percentage is rounded down" test "$(number_of_points out.ply)" -eq 1200
run -V
check "the short name of version" test "$status" -eq 0 -a "$(wc -l < stdout)" -eq 1
run cube.xyz out.ply --percentage 150
check "more points than there are" test "$status" -eq 0 -a "$(number_of_points out.ply)" -eq 14400
run -n 77 -o out.ply cube.xyz --method LOR --device Cpu --solver Block-CG --output-format PLY
check "short names, and choices in any case" test "$status" -eq 0 \
  -a "$(number_of_points out.ply)" -eq 77
check "the method in any case" grep -q 'method lor' stdout
run --version
check "version" test "$status" -eq 0 -a "$(grep -cE '^l0_resample [0-9]+\.[0-9]+' stdout)" -eq 1
run --help
check "help" test "$status" -eq 0 -a "$(grep -c -- '--neighbor-radius' stdout)" -ge 1

# The written formats hold the same points, and each can be read again
make_inputs same.ply same.off same.xyz same.xyzn same.pcd same.npy same.las
check "XYZ and XYZN agree" cmp same.xyz same.xyzn
run cube.xyz same.bin --output-format pcd --points 500
check "the format by its name" cmp same.bin same.pcd
check "OFF and XYZ agree" cmp <(tail -n +3 same.off) same.xyz
for format in ply off xyz npy; do
  run "same.$format" "again_$format.xyz" --points 100 --use-normals
done
check "PLY and XYZ agree" cmp again_ply.xyz again_xyz.xyz
check "OFF and XYZ agree when read" cmp again_off.xyz again_xyz.xyz
check "NPY and XYZ agree when read" cmp again_npy.xyz again_xyz.xyz
for format in pcd las; do
  run "same.$format" "again_$format.xyz" --points 100 --use-normals
  check "$format has normals" test "$status" -eq 0 -a "$(wc -l < "again_$format.xyz")" -eq 100
done

# What changes the result and what does not
run cube.xyz a.xyz --threads 1
run cube.xyz b.xyz --threads 2
check "threads do not matter" cmp a.xyz b.xyz
run cube.xyz b.xyz --seed 1
check "the seed matters" test "$(cmp -s a.xyz b.xyz; echo $?)" -eq 1
run cube.xyz b.xyz --neighbor-radius 0.2
check "the radius matters" test "$(cmp -s a.xyz b.xyz; echo $?)" -eq 1
run cube.xyz b.xyz --normal-weight 0
check "the normal weight matters" test "$(cmp -s a.xyz b.xyz; echo $?)" -eq 1
check "a weight that matters needs no note" test ! -s stderr

# In the default method the weight has a limit, and a note says so
run cube.xyz b.xyz --normal-weight 0.999
check "a weight beyond the limit acts as the default" cmp a.xyz b.xyz
check "a note says that" grep -qE \
  '^l0_resample: note: cube.xyz: --normal-weight 0.999 acts as 0\.[0-9]+ does, the largest' stderr
limit=$(sed -n 's/.* acts as \([0-9.]*\) does.*/\1/p' stderr)
run cube.xyz b.xyz --normal-weight "$(awk "BEGIN { print 1.02 * $limit }")"
check "a weight just beyond the limit" test "$(cmp a.xyz b.xyz)$(grep -c note: stderr)" = 1
run cube.xyz b.xyz --normal-weight "$(awk "BEGIN { print 0.9 * $limit }")"
check "a weight just below the limit" test "$(cmp -s a.xyz b.xyz; echo $?)" -eq 1 -a ! -s stderr
run cube.xyz a.xyz --normal-weight 0.9 --method lor
check "other methods have no limit" test ! -s stderr
run cube.xyz a.xyz --threads 1
run cube.xyz b.xyz --sharpness-angle 60
check "the sharpness angle matters" test "$(cmp -s a.xyz b.xyz; echo $?)" -eq 1
for solver in chebyshev block-cg cholesky rows-cg; do
  run cube.xyz solved.ply --points 300 --solver "$solver" --json solved.json
  check "solver $solver" test "$status" -eq 0 -a "$(number_of_points solved.ply)" -eq 300
  check "solver $solver in the report" grep -q "\"solver\": \"$solver\"" solved.json
done

# Where numbers are written with a comma: in a locale that is made for this, as few machines have
# one
mkdir locales
if localedef -i de_DE -f UTF-8 locales/de_DE.UTF-8 2> /dev/null; then
  german=(env LOCPATH="$folder/locales" LC_ALL=de_DE.UTF-8)
  check "the locale writes a comma" test "$("${german[@]}" /usr/bin/printf %.1f 1)" = 1,0
  for format in xyz ply pcd off; do
    run cube.xyz "point.$format" --points 200
    "${german[@]}" "$program" --force cube.xyz "comma.$format" --points 200 --json comma.json \
      > stdout 2> stderr < /dev/null
    check "the locale changes no $format" cmp "point.$format" "comma.$format"
    check "the summary has points" grep -qE ' [0-9]+\.[0-9]+ s, ' stdout
  done
  check "the locale changes no report" test "$(grep -c '[0-9],[0-9]' comma.json)" -eq 0
  "${german[@]}" "$program" --force attributes.ply comma.xyz --convert-only > stdout 2> stderr
  run attributes.ply point.xyz --convert-only
  check "the locale changes no reading" cmp comma.xyz point.xyz
  "${german[@]}" "$program" cube.xyz german.ply --neighbor-radius 0,2 > stdout 2> stderr
  check "an option with a comma is no number, whatever the locale" test $? -eq 2 -a ! -e german.ply
  "${german[@]}" "$program" cube.xyz german.ply --neighbor-radius 0.2 > stdout 2> stderr
  check "an option with a point is one" test $? -eq 0
fi

# On a terminal, progress is drawn on stderr and taken away at the end
if command -v script > /dev/null; then
  script -qec "'$program' cube.xyz terminal.ply --neighbor-radius 0.3" /dev/null \
    < /dev/null > terminal
  check "reading on a terminal" grep -qE '\[[#-]*\] +[0-9]+ %  read' terminal
  check "the summary alone stays" \
    test "$(tr -d '\r' < terminal | sed 's/.*\x1b\[K//' | grep -c .)" -eq 1
  check "the summary stays" grep -q 'cube.xyz: 9600 points in' terminal
  script -qec "'$program' --force cube.xyz terminal.ply --quiet" /dev/null < /dev/null > terminal
  check "quiet on a terminal" test ! -s terminal
fi

# Report and picture
CUDA_VISIBLE_DEVICES=-1 run cube.xyz out.ply --json report.json --snapshot picture.png --device auto
check "report and picture" test "$status" -eq 0
check "why the processor was taken" grep -qE '"reason": "[^"]*(CUDA|device|driver)' report.json
for key in '"exit_status": 0' '"points": 9600' '"points": 4800' '"used": "cpu"' \
           '"name": "filter normals"' '"penalty": 0.1,'; do
  check "$key in the report" grep -qF "$key" report.json
done
check "a PNG of 1600 x 800" test "$(head -c 24 picture.png | od -An -tx1 | tr -d ' \n')" = \
  89504e470d0a1a0a0000000d494844520000064000000320
for colors in shaded normals; do
  run cube.xyz out.ply --snapshot "$colors.png" --snapshot-colors "$colors"
done
check "a snapshot is shaded by default" cmp -s shaded.png picture.png
run cube.xyz out.ply --snapshot UPPER.PNG --page UPPER.HTML
check "extensions in capitals" cmp -s UPPER.PNG picture.png
check "a page of them" grep -qiF '<!doctype html' UPPER.HTML
run cube.xyz out.ply --snapshot rows.png --snapshot-views 4
check "a PNG of four rows" test "$(head -c 24 rows.png | od -An -tx1 | tr -d ' \n')" = \
  89504e470d0a1a0a0000000d494844520000064000000c80
check "colors of normals are others" test "$(cmp -s normals.png picture.png; echo $?)" = 1
run cube.xyz out.ply --json /dev/stdout
check "the report alone on stdout" test "$(head -n 1 stdout)" = "{" -a "$(tail -n 1 stdout)" = "}"

# Names and places
run cube.xyz "a name with blanks é.ply"
check "blanks and accents" \
  test "$status" -eq 0 -a "$(number_of_points "a name with blanks é.ply")" -eq 4800
cp cube.xyz ./-cube.xyz
run --points 10 -- -cube.xyz -out.ply
check "a leading dash" test "$status" -eq 0 -a "$(number_of_points ./-out.ply)" -eq 10
cp cube.xyz both.xyz
run both.xyz both.xyz --points 20
check "input and output are one file" test "$status" -eq 0 -a "$(wc -l < both.xyz)" -eq 20
run cube.xyz /dev/stdout --output-format xyz --points 30
check "points alone on stdout" test "$status" -eq 0 -a "$(wc -l < stdout)" -eq 30
check "then the summary is on stderr" grep -q '30 out' stderr
"$program" cube.xyz /dev/stdout --output-format xyz --points 30 --quiet 2> stderr | cat > piped.xyz
check "a pipe as output" cmp stdout piped.xyz
check_failure 3 "/dev/stdin: line 1: the file has no points" /dev/stdin old.ply --input-format xyz
"$program" --force /dev/stdin out.ply --input-format xyz --points 40 < <(cat cube.xyz) > /dev/null
check "a pipe as input" test $? -eq 0 -a "$(number_of_points out.ply)" -eq 40
(
  ulimit -n 16
  run cube.xyz out.ply --points 50
  check "few open files" test "$status" -eq 0
  exit "$failures"
) || failures=$((failures + 1))
check "nothing is left behind" no_temporary_files

end_of_checks
