#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The program l0_resample as a user meets it: exit statuses, what is printed where, and that no failure harms a file.
# usage: test_tool_cli.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"

# Properties of the points go along: of labels the nearest, of other numbers and of colors a mean
{ printf 'ply\nformat ascii 1.0\nelement vertex 9600\n'
  printf 'property %s\n' 'double x' 'double y' 'double z' 'uchar red' 'int label' 'float height'
  printf 'end_header\n'; awk '{ print $0, ($1 > 0 ? 200 : 100), ($1 > 0 ? -70000 : 7), $3 }' cube.xyz; } > attributes.ply
run attributes.ply carried.ply --source-index --feature-confidence --snapshot features.png
check "a run with properties" test "$status" -eq 0
check "all properties in order" test "$(properties carried.ply)" = \
  "double x,double y,double z,double nx,double ny,double nz,uchar red,int label,float height,uint source_index,float feature_confidence,"
# red is byte 49 of a row of 65, and the label the four behind it
check "labels of points, and colors between those of points" test "$(tail -c $((4800 * 65)) carried.ply | od -An -v -w65 -t u1 | awk '
  { label = $50 " " $51 " " $52 " " $53; wrong += label != "7 0 0 0" && label != "144 238 254 255" || $49 < 100 || $49 > 200
    mixed += $49 > 100 && $49 < 200 } END { print wrong + 0, (mixed > 10 && mixed < 480) }')" = "0 1"
run cube.xyz plain.ply
run carried.ply positions.xyz --convert-only
run plain.ply plain.xyz --convert-only
check "properties change no point" cmp -s positions.xyz plain.xyz
run carried.ply carried.off --convert-only --quiet
run attributes.ply attributes.xyz --quiet
check "a format without room for properties" test "$status" -eq 0
run attributes.ply attributes.xyz
check "a warning of what is left out" grep -q "no place for the property 'label'" stderr

# Where normals point to
awk '{ r = -sqrt($1 * $1 + $2 * $2 + $3 * $3); print $0, $1 / r, $2 / r, $3 / r }' cube.xyz > inward.xyz
awk '{ print $0, NR % 2 }' cube.xyz > viewed.xyz
printf '0 0 0.1\n# another\n0.1 -0.1 0\n' > views.txt
run cube.xyz cube.pcd --convert-only
LC_ALL=C sed 's/^VIEWPOINT 0 0 0 /VIEWPOINT 0 0 0.1 /' cube.pcd > seen.pcd
for options in "cube.xyz in.xyz --viewpoint 0,0,0.1" "inward.xyz in.xyz --orient-by-normals" "seen.pcd in.xyz" \
    "viewed.xyz in.xyz --columns x,y,z,view --viewpoints views.txt --view-property view"; do
  # shellcheck disable=SC2086
  run $options --json in.json
  check "all normals inwards: $options" test "$(awk '$1 * $4 + $2 * $5 + $3 * $6 > 0' in.xyz | wc -l)" -eq 0
  check "the report says so" grep -q '"hinted_share": 1' in.json
done
run cube.xyz down.xyz --up 0,0,-3
check "all normals down, but of the sides" test "$(awk '$6 > 0.2' down.xyz | wc -l)" -eq 0
run seen.pcd seen.xyz
check "a note on the viewpoint of the file" grep -qx \
  'l0_resample: note: seen.pcd: normals face the VIEWPOINT of the file, 0,0,0.1, unless --viewpoint none is given' stderr
run seen.pcd outward.xyz --viewpoint none
check "no viewpoint if none is asked for" test "$status" -eq 0 -a ! -s stderr
run cube.pcd plain.xyz
check "which is as if the file had none" cmp -s outward.xyz plain.xyz
run seen.pcd up.xyz --up 0,0,1 --json up.json
check "no note beside another side" test "$status" -eq 0 -a ! -s stderr
check "nor a viewpoint in the report" grep -q '"viewpoint": null' up.json
run plain.ply plain.xyz --convert-only
run cube.xyz kept.xyz --keep-density
check "an even result is another one" test "$(cmp -s kept.xyz plain.xyz; echo $?)" -eq 1

# Good runs
run cube.xyz out.ply
check "a good run" test "$status" -eq 0
check "half of the points by default" test "$(number_of_points out.ply)" -eq 4800
check "nothing on stderr" test ! -s stderr
check "one line on stdout" test "$(wc -l < stdout)" -eq 1
check "the summary" \
  grep -qE '^cube.xyz: 9600 points in, 4800 out, method default, [0-9.]+ s, one sign propagated to [0-9.]+ %$' stdout
run cube.xyz out.ply --neighbor-radius 0.0001 --json small.json
check "a radius with hardly a point in it warns" test "$status" -eq 0 -a "$(grep -c warning: stderr)" -ge 1
check "the warning says why" grep -q '^l0_resample: warning: cube.xyz: 100.0 % of the points have fewer than six' stderr
check "the report says so too" grep -q '^ *"small_radius"' small.json
run cube.xyz out.ply --neighbor-radius 0.0001 --quiet
check "quiet warns nobody" test ! -s stderr
run inward.xyz out.ply
check "normals that could decide the side" \
  grep -qx 'l0_resample: note: inward.xyz: the file has normals, which --orient-by-normals lets decide the side' stderr
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
for format in ply off xyz xyzn pcd npy; do
  run cube.xyz "same.$format" --points 500
  check "writing $format" test "$status" -eq 0
done
check "XYZ and XYZN agree" cmp same.xyz same.xyzn
run cube.xyz same.bin --output-format pcd --points 500
check "the format by its name" cmp same.bin same.pcd
check "OFF and XYZ agree" cmp <(tail -n +3 same.off) same.xyz
for format in ply off xyz npy; do run "same.$format" "again_$format.xyz" --points 100 --use-normals; done
check "PLY and XYZ agree" cmp again_ply.xyz again_xyz.xyz
check "OFF and XYZ agree when read" cmp again_off.xyz again_xyz.xyz
check "NPY and XYZ agree when read" cmp again_npy.xyz again_xyz.xyz
run same.pcd again_pcd.xyz --points 100 --use-normals
check "PCD has normals" test "$status" -eq 0 -a "$(wc -l < again_pcd.xyz)" -eq 100

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
for solver in block-cg cholesky rows-cg; do
  run cube.xyz solved.ply --points 300 --solver "$solver" --json solved.json
  check "solver $solver" test "$status" -eq 0 -a "$(number_of_points solved.ply)" -eq 300
  check "solver $solver in the report" grep -q "\"solver\": \"$solver\"" solved.json
done

# Where numbers are written with a comma: in a locale that is made for this, as few machines have one
mkdir locales
if localedef -i de_DE -f UTF-8 locales/de_DE.UTF-8 2> /dev/null; then
  german=(env LOCPATH="$folder/locales" LC_ALL=de_DE.UTF-8)
  check "the locale writes a comma" test "$("${german[@]}" /usr/bin/printf %.1f 1)" = 1,0
  for format in xyz ply pcd off; do
    run cube.xyz "point.$format" --points 200
    "${german[@]}" "$program" --force cube.xyz "comma.$format" --points 200 --json comma.json > stdout 2> stderr < /dev/null
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
  script -qec "'$program' cube.xyz terminal.ply --neighbor-radius 0.3" /dev/null < /dev/null > terminal
  check "reading on a terminal" grep -qE '\[[#-]*\] +[0-9]+ %  read' terminal
  check "the summary alone stays" test "$(tr -d '\r' < terminal | sed 's/.*\x1b\[K//' | grep -c .)" -eq 1
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
check "a PNG of 1600 x 800" test \
  "$(head -c 24 picture.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a0000000d494844520000064000000320
run cube.xyz out.ply --json /dev/stdout
check "the report alone on stdout" test "$(head -n 1 stdout)" = "{" -a "$(tail -n 1 stdout)" = "}"

# Wrong usage: 2
echo old > old.ply
check_failure 2 "INPUT" 
check_failure 2 "OUTPUT" cube.xyz
check_failure 2 "--nonsense" cube.xyz old.ply --nonsense
for value in 0 -5 1.5 x 99999999999999999999 4294967295; do
  check_failure 2 "--points" cube.xyz old.ply --points "$value"
done
for value in 0 1000001 0,5 nan -1; do
  check_failure 2 "--percentage" cube.xyz old.ply --percentage "$value"
done
for value in 0 -1 inf 1,5; do check_failure 2 "--neighbor-radius" cube.xyz old.ply --neighbor-radius "$value"; done
for value in -1 nan; do check_failure 2 "--normal-weight" cube.xyz old.ply --normal-weight "$value"; done
check_failure 2 "--viewpoint" cube.xyz old.ply --viewpoint 1,2
check_failure 2 "--viewpoint" cube.xyz old.ply --viewpoint 1,2,inf
check_failure 2 "--orient-by-normals" cube.xyz old.ply --viewpoint 0,0,9 --orient-by-normals
check_failure 2 "--up" cube.xyz old.ply --up 0,0,0
check_failure 2 "--up" cube.xyz old.ply --up 0,1
check_failure 2 "--viewpoint" cube.xyz old.ply --viewpoint 0,0,9 --up 0,0,1
check_failure 2 "--viewpoints" cube.xyz old.ply --viewpoints views.txt
check_failure 2 "--view-property" cube.xyz old.ply --view-property view
check_failure 2 "--viewpoint" cube.xyz old.ply --viewpoints views.txt --view-property view --viewpoint 0,0,9
check_failure 2 "--viewpoints" cube.xyz old.ply --viewpoints views.txt --view-property view --up 0,0,1
check_failure 3 "the points have no property 'view'" cube.xyz old.ply --viewpoints views.txt --view-property view
check_failure 3 "nowhere.txt" viewed.xyz old.ply --columns x,y,z,view --viewpoints nowhere.txt --view-property view
for line in "0 0" "0 0 0 1" "0 0,5 0" "0 inf 0"; do
  printf '# two viewpoints\n\n1 2 3\n%s\n' "$line" > misplaced.txt
  check_failure 3 "misplaced.txt: line 4" viewed.xyz old.ply --columns x,y,z,view --viewpoints misplaced.txt \
    --view-property view
done
for view in 2 -1 0.5 nan; do
  awk -v view="$view" '{ print $0, (NR == 3 ? view : 1) }' cube.xyz > misviewed.xyz
  check_failure 3 "the property 'view' of point 2 is $view, but --viewpoints has 2, counted from 0" \
    misviewed.xyz old.ply --columns x,y,z,view --viewpoints views.txt --view-property view
done
for value in 0 91; do check_failure 2 "--sharpness-angle" cube.xyz old.ply --sharpness-angle "$value"; done
for value in 0 -1 two; do check_failure 2 "--threads" cube.xyz old.ply --threads "$value"; done
check_failure 2 "--seed" cube.xyz old.ply --seed -1
for value in 0,0,0 1,2 1,2,nan; do
  check_failure 2 "--view: $value is not" cube.xyz old.ply --view $value --snapshot picture.png
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
check_failure 2 "--output: one INPUT expected, found 2" cube.xyz old.ply -o out.ply
check_failure 2 "excludes" cube.xyz -o old.ply --output-directory batch
check_failure 2 "INPUT is required" -o old.ply
check_failure 2 "cube.txt: the extension" cube.txt old.ply
check_failure 2 "old.las: the extension" cube.xyz old.las
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
check_config "points = 0" "--points: 0 is not a whole number"
check_config "points =" "--points"
check_config "method = best" "--method: best not in"
check_config "columns = x,y" "--columns x,y: x, y and z have"
check_config "quiet = yes" "quiet is true or false, found 'yes'"
check_config "seed = 2" "a second line seed"
printf 'points = 5\npercentage = 5\n' > wrong.txt
check_failure 2 "excludes" cube.xyz old.ply --config wrong.txt

# Input refused: 3
check_failure 3 "missing.ply: cannot be opened: No such file" missing.ply old.ply
check_failure 3 "Is a directory" . old.ply --input-format ply
printf '1 2 3\n1 0,5 3\n' > comma.xyz
check_failure 3 "comma.xyz: line 2: '0,5' is not a number" comma.xyz old.ply
check_failure 3 "--max-points" cube.xyz old.ply --max-points 9599
check_failure 3 "has no normals" cube.xyz old.ply --use-normals
check_failure 3 "has no normals" cube.xyz old.ply --orient-by-normals
printf '%s\n' ply 'format binary_little_endian 1.0' 'element vertex 1000000000000000' 'property double x' \
  'property double y' 'property double z' end_header > huge.ply
check_failure 3 "huge.ply: line 7: 1000000000000000 points are announced" huge.ply old.ply
(cat cube.xyz; echo 'nan 0 0'; echo '0 inf 0') > bad.xyz
check_failure 3 "bad.xyz: line 9601: a coordinate is not finite" bad.xyz old.ply
check_failure 3 "line 9601" bad.xyz old.ply --json failed.json
check "the report of a failure" grep -q '"exit_status": 3' failed.json
check "refused input writes nothing" is_old old.ply
run bad.xyz dropped.xyz --drop-non-finite --points 50 --json dropped.json
check "dropping non-finite points" test "$status" -eq 0 -a "$(wc -l < dropped.xyz)" -eq 50
check "dropped points in the report" grep -q '"dropped_points": 2' dropped.json
check "dropped points in the summary" grep -q '9600 points in, 2 dropped, 50 out' stdout
echo 0 > empty.xyz
run empty.xyz empty.ply
check "no points in, none out" test "$status" -eq 0 -a "$(number_of_points empty.ply)" -eq 0

# Failed at run time: 1
CUDA_VISIBLE_DEVICES=-1 check_failure 1 "--device cuda" cube.xyz old.ply --device cuda   # also where there is a device
check_failure 1 "--max-memory" cube.xyz old.ply --max-memory 10kb
check_failure 1 "--max-memory" cube.xyz old.ply --max-memory 300kb
check_failure 1 "--timeout" cube.xyz old.ply --timeout 0.001 --neighbor-radius 0.5
mkfifo silent.xyz
sleep 60 > silent.xyz &   # an input that never comes
sleeper=$!
check_failure 1 "--timeout" silent.xyz old.ply --timeout 0.2
(
  ulimit -v 150000   # in units of 1 KiB: less than the points of the result would take
  "$program" --version > /dev/null 2>&1 || exit "$failures"   # the shadow memory of a sanitizer alone is more
  check_failure 1 "not enough memory" cube.xyz old.ply --points 20000000 --device cpu
  exit "$failures"
) || failures=$((failures + 1))
check "a failed run writes nothing" is_old old.ply

# Output not written: 4
check_failure 4 "no/out.ply" cube.xyz no/out.ply
check_failure 4 "no/report.json" cube.xyz old.ply --json no/report.json
check_failure 4 "no/picture.png" cube.xyz old.ply --snapshot no/picture.png
mkdir folder.ply
check_failure 4 "it is a directory" cube.xyz folder.ply
ln -s /dev/full full.ply
check_failure 4 "No space left on device" cube.xyz full.ply
check "an output that cannot be written leaves the others" is_old old.ply
(
  ulimit -f 50   # in units of 1 KiB
  check_failure 4 "File too large" cube.xyz old.ply
  exit "$failures"
) || failures=$((failures + 1))
check "a full disk leaves the old file" is_old old.ply
check "a full disk leaves no temporary file" no_temporary_files

# A disk that is really full, where one can be mounted
cat > disk.sh <<'EOF'
mkdir disk && mount -t tmpfs -o size=64k tmpfs disk && echo old > disk/old.ply || exit 77
"$1" --force cube.xyz disk/old.ply > stdout 2> stderr
echo "$? $(cat disk/old.ply) $(ls -A disk)"
EOF
if unshare --user --map-root-user --mount true 2> /dev/null; then
  answer=$(unshare --user --map-root-user --mount bash disk.sh "$program")
  if test $? -ne 77; then
    check "a full disk has its status, leaves the old file and nothing else" test "$answer" = "4 old old.ply"
    check "a full disk is named" grep -q '^l0_resample: disk/old.ply: cannot be written: about [0-9]* bytes are needed, the disk has room for [0-9]*$' stderr
  fi
fi

# Write-protected files stop nobody who is root
unprivileged=()
test "$(id -u)" -ne 0 || unprivileged=(setpriv --reuid 65534 --regid 65534 --clear-groups)
chmod 755 "$folder"; mkdir -m 777 protected; echo old > protected/old.ply; chmod 444 protected/old.ply
mkdir -m 555 closed
for target in protected/old.ply closed/out.ply; do
  "${unprivileged[@]}" "$program" --force cube.xyz "$target" > stdout 2> stderr
  check "status of a write to $target" test $? -eq 4
  check "reason of a write to $target" grep -q "^l0_resample: $target: cannot be written: .*Permission denied" stderr
done
check "a write-protected file is not replaced" is_old protected/old.ply

# Not converged: 5
run cube.xyz loose.ply --solver-iterations 1
check "without --strict an unconverged solve is an answer" \
  test "$status" -eq 0 -a "$(number_of_points loose.ply)" -eq 4800
check "an unconverged solve in the summary" grep -q 'not converged' stdout
check_failure 5 "did not converge" cube.xyz old.ply --solver-iterations 1 --strict
check "--strict writes nothing" is_old old.ply
run cube.xyz loose.ply --strict
check "--strict lets a converged result pass" test "$status" -eq 0

# Cancelled: 130 and 143, while the input is waited for and in the midst of the work. The copies of the cube and the
# large radius make that work last for minutes, were it not cancelled.
awk '{ for (i = 0; i < 40; ++i) print $1 + i % 7 * .01, $2 + i % 5 * .01, $3 + i % 3 * .01 }' cube.xyz > long.xyz
patient=(timeout --foreground -s KILL 60)   # passes the signals on, and ends a program that is deaf to them
awk '{ for (i = 0; i < 50; ++i) print }' cube.xyz > more.xyz
check_failure 3 "--percentage asks for more than 4294967294" more.xyz old.ply --percentage 1000000
for signal in INT TERM; do
  expected=130; test $signal = INT || expected=143
  "${patient[@]}" "$program" --force silent.xyz old.ply > stdout 2> stderr & job=$!
  sleep 0.3; kill -$signal $job; wait $job
  check "status after SIG$signal while reading" test $? -eq $expected
  "${patient[@]}" "$program" --force long.xyz old.ply --neighbor-radius 1 > stdout 2> stderr & job=$!
  sleep 1.5; kill -$signal $job; wait $job
  check "status after SIG$signal while computing" test $? -eq $expected
  check "one line after SIG$signal" test "$(wc -l < stderr)" -eq 1 -a ! -s stdout
done
kill $sleeper; wait $sleeper 2> /dev/null
check "a cancelled run leaves the old file" is_old old.ply
check "a cancelled run leaves no temporary file" no_temporary_files

# A batch: failures at the end, the others unharmed. Its status is the one that all failures have, else 1.
mkdir scans other; cp cube.xyz scans/a.xyz; cp same.npy scans/b.npy; cp comma.xyz scans/c.xyz; cp same.pcd scans/d.pcd
echo nothing > scans/notes.txt; echo old > scans/old.las
run scans/a.xyz scans/c.xyz scans/b.npy missing.ply --output-directory batch/new --points 30 --output-format ply
check "status of a batch with failures of one kind" test "$status" -eq 3
check "files of a batch" test "$(ls batch/new)" = "$(printf 'a.ply\nb.ply')"
check "a result of a batch" test "$(number_of_points batch/new/b.ply)" -eq 30
check "a line for each success" test "$(grep -c '30 out' stdout)" -eq 2 -a "$(wc -l < stdout)" -eq 2
check "a line for each failure, and their number" cmp <(grep -v ': note: ' stderr) <(printf '%s\n' \
  "l0_resample: scans/c.xyz: line 2: '0,5' is not a number" \
  "l0_resample: missing.ply: cannot be opened: No such file or directory" "l0_resample: 2 of 4 files failed")
run scans/a.xyz batch_alone.ply --points 30 --quiet
check "a batch gives what single runs give" cmp batch/new/a.ply batch_alone.ply
run scans --output-directory batch/folder --points 30 --json batch.json
check "a folder, each in its format" test "$status" -eq 3 -a "$(ls batch/folder)" = "$(printf 'a.xyz\nb.npy\nd.pcd')"
check "the report of a batch" test "$(head -n 1 batch.json)" = "[" -a "$(grep -c '"exit_status": 0' batch.json)" -eq 3 \
  -a "$(grep -c '"exit_status": 3' batch.json)" -eq 1 -a "$(tail -n 1 batch.json)" = "]"
mkdir -p batch/mixed/a.xyz
run scans/a.xyz scans/c.xyz --output-directory batch/mixed --quiet
check "status of a batch with failures of two kinds" test "$status" -eq 1 -a "$(wc -l < stderr)" -eq 3
run scans/a.xyz scans/b.npy --output-directory batch/good --points 30 --quiet
check "a quiet batch" test "$status" -eq 0 -a ! -s stdout -a ! -s stderr
cp a.xyz scans/same.xyz; cp same.ply scans/same.ply; cp scans/notes.txt notes.txt
run notes.txt scans/same.xyz scans/same.ply --output-directory batch/seen --points 30 \
  --snapshot batch/pictures/new
check "pictures of a batch" test "$status" -eq 3 \
  -a "$(ls batch/pictures/new)" = "$(printf 'same.ply.png\nsame.xyz.png')"
check "each is a picture" \
  test "$(head -c 4 batch/pictures/new/same.ply.png | od -An -tx1)" = " 89 50 4e 47"
rm scans/same.*
check_failure 4 "cube.xyz/inside: cannot be made" scans/a.xyz --output-directory batch/same2 \
  --snapshot cube.xyz/inside
cp scans/a.xyz other/a.xyz
check_failure 2 "both scans/a.xyz and other/a.xyz" scans/a.xyz other/a.xyz --output-directory batch/same
check_failure 2 "both scans/a.xyz and ./scans/a.xyz" scans/a.xyz ./scans/a.xyz --output-directory batch/same
check_failure 2 "would take the place of the input scans/a.xyz" scans/a.xyz --output-directory other/../scans
check_failure 2 "--snapshot: in a batch a folder expected" \
  scans/a.xyz --output-directory batch/same --snapshot picture.png
check_failure 2 "3 files" scans/a.xyz scans/b.npy out.ply
check_failure 2 "INPUT" --output-directory batch/same
check "a refused batch makes nothing" test ! -e batch/same
check_failure 4 "cannot be made" scans/a.xyz --output-directory cube.xyz/inside
run scans/notes.txt --output-directory batch/named --input-format xyz --output-format off
check "the input format of a batch" grep -qF 'scans/notes.txt: line 1: a point needs 3 numbers' stderr
"${patient[@]}" "$program" scans/a.xyz long.xyz scans/b.npy --output-directory batch/cut --neighbor-radius 1 \
  > stdout 2> stderr & job=$!
sleep 2.5; kill -INT $job; wait $job
check "status of an interrupted batch" test $? -eq 130
check "an interrupted batch says what was not done" \
  grep -q '^l0_resample: 1 of 3 files failed, [12] not begun$' stderr
check "an interrupted batch leaves no temporary file" no_temporary_files
run long.xyz scans/b.npy --output-directory batch/slow --neighbor-radius 1 --timeout 0.2
check "the time of a batch is over" test "$status" -eq 1 -a ! -e batch/slow/b.npy
check "where the time was over" grep -q '^l0_resample: long.xyz: the time given by --timeout is over$' stderr

# Conversions: points as they are, with what the format can hold
printf '%s\n' ply 'format ascii 1.0' 'element vertex 2' 'property float x' 'property float y' 'property float z' \
  'property uchar red' 'property uchar green' 'property uchar blue' 'property double time' end_header \
  '0.1 2 3 255 128 0 1e9' '4 5 6 1 2 3 0.3' > rich.ply
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
check "points dropped by a conversion" grep -qx 'bad.xyz: 9600 points in, 2 dropped, 9600 out, converted' stdout
check_failure 3 "--max-points" --convert-only cube.xyz old.ply --max-points 9599
check_failure 1 "--max-memory" --convert-only cube.xyz old.ply --max-memory 10kb
check_failure 4 "no/out.ply" --convert-only cube.xyz no/out.ply
for option in "--points 5" "--percentage 5" "--method lor" "--json report.json" --strict --use-normals; do
  # shellcheck disable=SC2086
  check_failure 2 "--convert-only" --convert-only cube.xyz old.ply $option
done
check "a refused conversion writes nothing" is_old old.ply
run --convert-only scans --output-directory batch/converted --output-format ply
check "a batch of conversions" test "$status" -eq 3 -a "$(number_of_points batch/converted/a.ply)" -eq 9600 \
  -a "$(ls batch/converted)" = "$(printf 'a.ply\nb.ply\nd.ply')"

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
run_plainly --info cube.xyz --method lor --percentage 10 --quiet
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
  -a "$(fact spacing)" = "all points are at one place" -a "$(fact extent)" = "from 1,2,3 to 1,2,3, diagonal 0"
check_plain_failure 3 "missing.ply" --info missing.ply
check_plain_failure 2 "--info: one INPUT expected, found 2 files" --info cube.xyz old.ply
for option in "-o x.ply" "--json x.json" --dry-run --force "--output-directory x"; do
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

# Names and places
run cube.xyz "a name with blanks é.ply"
check "blanks and accents" test "$status" -eq 0 -a "$(number_of_points "a name with blanks é.ply")" -eq 4800
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
