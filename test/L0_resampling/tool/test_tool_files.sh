#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The program l0_resample and files of others: what it replaces, where what it writes goes, what it
# takes columns of a text for, and what a batch does with a file of no known format.
# usage: test_tool_files.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"

head -n 3000 cube.xyz > a1.xyz; tail -n 3000 cube.xyz > a2.xyz; cp a1.xyz one.xyz; cp a2.xyz two.xyz

# A file is not replaced without --force
check_plain_failure 4 "a2.xyz: the file exists; --force replaces it" a*.xyz
check "the second of two scans stays" cmp a2.xyz two.xyz
check_plain_failure 4 "--force" a1.xyz ./a1.xyz
check_plain_failure 4 "--force" a1.xyz a2.xyz --convert-only
check_plain_failure 4 "--force" missing.xyz a2.xyz   # before the input is looked at
check_plain_failure 4 "--force" a1.xyz a2.xyz --json none.json --snapshot none.png
check "a refused run writes no report" test ! -e none.json -a ! -e none.png
ln -s a2.xyz link.xyz
check_plain_failure 4 "link.xyz: the file exists" a1.xyz link.xyz
check "no file was replaced" cmp a1.xyz one.xyz
echo old > report.json; echo old > picture.png
run_plainly a1.xyz new.ply --points 50 --json report.json --snapshot picture.png
check "an output that is new" test "$status" -eq 0 -a "$(number_of_points new.ply)" -eq 50
check "reports and pictures are replaced" \
  test "$(head -n 1 report.json)" = "{" -a "$(wc -c < picture.png)" -gt 1000
run a1.xyz link.xyz --points 50
check "--force replaces the file behind a link" test -L link.xyz -a "$(wc -l < a2.xyz)" -eq 50
run a1.xyz a1.xyz --points 60
check "--force replaces the input" test "$status" -eq 0 -a "$(wc -l < a1.xyz)" -eq 60
cp one.xyz a1.xyz; cp two.xyz a2.xyz

# What the options name is read, and stays too
echo 'points = 10' > options.txt; cp options.txt options_as_they_were.txt
awk 'BEGIN { print "x,y,z,view" } { print $1 "," $2 "," $3 "," NR % 2 }' a1.xyz > seen.csv
printf '0 0 1\n0 1 0\n' > places.txt; cp places.txt places_as_they_were.txt
places=(--viewpoints places.txt --view-property view)
check_failure 2 "options.txt: is named twice" a1.xyz new.ply --config options.txt --json options.txt
check_failure 2 "options.txt: is named twice" a1.xyz options.txt --output-format ply \
  --config options.txt
check_failure 2 "places.txt: is named twice" seen.csv new.ply "${places[@]}" --json places.txt
check_failure 2 "./places.txt: is named twice" seen.csv ./places.txt --output-format ply \
  "${places[@]}"
check_failure 2 "places.txt: is named twice" seen.csv --output-directory none "${places[@]}" \
  --json places.txt
check "options are what they were" cmp options.txt options_as_they_were.txt
check "places are what they were" cmp places.txt places_as_they_were.txt
mkdir folder
check_plain_failure 2 "folder: is a folder; --output-directory" folder new.ply
check_plain_failure 2 "folder: is a folder; --output-directory" a1.xyz folder

# A name that would make two lines of one, or say something to a terminal
strange=$'two\nlines\033[31m.xyz'; cp a1.xyz "$strange"
check_plain_failure 3 "no?file.xyz: cannot be opened" $'no\nfile.xyz' strange.ply
check_plain_failure 2 "two?lines: the extension is not" a1.xyz $'two\nlines'
check_plain_failure 2 "scan.e57: files of e57 are neither read nor written" scan.e57 b.ply
check_plain_failure 2 "part.stl: files of stl are neither read nor written" part.stl b.ply
check_plain_failure 2 "scan.npz: archives of NumPy are neither read" scan.npz b.ply
# A name that is that of another format
for format in ply pcd las npy; do
  run a1.xyz "named.$format" --convert-only
  for other in ply pcd las npy off xyz csv obj; do
    [ $other != $format ] || continue
    cp "named.$format" "misnamed.$other"
    check_plain_failure 3 "begins as one of ${format^^}, which --input-format $format reads" \
      "misnamed.$other" b.ply
  done
  run "misnamed.$other" right.ply --input-format $format --convert-only
  check "with the right format it is read" test "$status" -eq 0
done
run "$strange" strange.ply --points 5 --neighbor-radius 1e-6
check "a strange name" test "$status" -eq 0 -a "$(number_of_points strange.ply)" -eq 5
check "its summary" test "$(wc -l < stdout)" -eq 1 \
  -a "$(head -c 17 stdout)" = 'two?lines?[31m.xy'
check "its warnings" test "$(grep -cv '^l0_resample: warning: two?lines?\[31m.xyz: ' stderr)" -eq 0
run_plainly --info "$strange"
check "what it is" grep -qxF 'file:            two?lines?[31m.xyz, xyz' stdout

# A file that comes while the program works
mkfifo slow.xyz
timeout 60 "$program" slow.xyz late.ply > stdout 2> stderr & job=$!
# begins when the program reads
timeout 60 bash -c '{ echo old > late.ply; cat a1.xyz; } > slow.xyz'
wait $job
check "a file that came later is not replaced" test $? -eq 4
check "a file that came later is named" \
  grep -q '^l0_resample: late.ply: the file exists; --force' stderr
check "a file that came later is what it was" is_old late.ply
check "nothing is left behind" no_temporary_files

# What is no file needs no --force
run_plainly a1.xyz /dev/null --output-format ply
check "a device as output" test "$status" -eq 0 -a -c /dev/null
mkfifo pipe.xyz
timeout 60 cat pipe.xyz > piped.xyz & job=$!
run_plainly a1.xyz pipe.xyz --points 70
wait $job
check "a named pipe as output" test "$status" -eq 0 -a -p pipe.xyz -a "$(wc -l < piped.xyz)" -eq 70
mkdir elsewhere
ln -s elsewhere/made.ply dangling.ply
run_plainly a1.xyz dangling.ply --points 80
check "a link that leads to no file yet makes it" test "$status" -eq 0 -a -L dangling.ply \
  -a "$(number_of_points elsewhere/made.ply)" -eq 80
ln -s circle.ply circle.ply
check_plain_failure 4 "circle.ply: cannot be written: Too many levels" a1.xyz circle.ply
check "a circle of links stays" test -L circle.ply

# In a batch
mkdir results; echo old > results/a2.xyz
check_plain_failure 4 "results/a2.xyz: the file exists; --force" a1.xyz a2.xyz \
  --output-directory results
check "a batch that is refused makes nothing" test "$(ls results)" = a2.xyz
check "a result of an earlier batch stays" is_old results/a2.xyz
echo old > results/a1.xyz
check_plain_failure 4 "results/a1.xyz: the file exists, as do 1 others" a1.xyz a2.xyz \
  --output-directory results
run a1.xyz a2.xyz --output-directory results --points 90
check "a batch with --force" test "$status" -eq 0 -a "$(cat results/*.xyz | wc -l)" -eq 180

# A descriptor that leads to a file: what others have written there stays
run_plainly a1.xyz points.xyz --points 30
echo first > expected; cat points.xyz >> expected; echo last >> expected
to=(--output-format xyz --points 30)
ln -s /dev/stdout out.xyz
for output in /dev/stdout - /dev/fd/1 /proc/self/fd/1 out.xyz; do
  (echo first; "$program" a1.xyz "$output" "${to[@]}" 2> stderr; echo last) > mixed
  check "only points between the lines of others: $output" cmp mixed expected
  check "then the summary is on stderr: $output" grep -q '30 out' stderr
done
(echo first; "$program" a1.xyz /dev/fd/3 "${to[@]}" 3>&1 > stdout; echo last) > mixed 2> stderr
check "another descriptor" cmp mixed expected
check "then the summary is on stdout" grep -q '30 out' stdout
(exec 2>&1; echo first; "$program" a1.xyz /dev/stderr "${to[@]}" > stdout; echo last) > mixed
check "standard error" cmp mixed expected
echo old > log
"$program" a1.xyz /dev/null --output-format ply --json /dev/stdout >> log 2> stderr
"$program" a1.xyz /dev/null --output-format ply --json - >> log 2> stderr
check "reports are appended to a log" test "$(head -n 1 log)" = old \
  -a "$(grep -cx '{' log)" -eq 2 -a "$(grep -cx '}' log)" -eq 2
check "the log has reports alone" test "$(grep -c 'points in' log)" -eq 0
check "no file has the name of a descriptor" test ! -e ./-
check_plain_failure 2 "is named twice" a1.xyz - --output-format ply --json /dev/stdout
check_plain_failure 2 "-: --output-format" a1.xyz -
check_plain_failure 2 "-: --input-format" - none.ply
check_plain_failure 2 "-: what is read from it" - a1.xyz --output-directory none --input-format xyz
for closed in /dev/fd/7 /dev/stdin; do
  check_plain_failure 4 "$closed: cannot be written: Bad file descriptor" \
    a1.xyz "$closed" --output-format ply
done
"$program" a1.xyz - --output-format xyz > /dev/full 2> stderr
check "a full disk behind standard output" test $? -eq 4
check "standard output is named" \
  grep -q '^l0_resample: standard output: cannot be written: No space left' stderr

# Standard input, also if others have read a part of it
whole=(--input-format xyz --percentage 100)
"$program" - rest.ply "${whole[@]}" < <(cat a1.xyz) > stdout 2> stderr
check "points from a pipe" test $? -eq 0 -a "$(number_of_points rest.ply)" -eq 3000
check "standard input in the summary" grep -q '^standard input: 3000 points in' stdout
(read -r _; "$program" --force - rest.ply "${whole[@]}") < a1.xyz > stdout 2> stderr
check "the rest of standard input" test "$(number_of_points rest.ply)" -eq 2999
"$program" - - --convert-only --input-format xyz --output-format xyz < a1.xyz > stdout 2> stderr
awk '{ printf "%.6f %.6f %.6f\n", $1, $2, $3 }' stdout > filtered.xyz
check "a filter" cmp filtered.xyz a1.xyz
echo "1 2 x" | "$program" - none.ply --input-format xyz > stdout 2> stderr
check "an error in standard input" \
  grep -q "^l0_resample: standard input: line 1: 'x' is not a number, " stderr

# Text: colors are no normals
awk '{ print $0, ($1 > 0 ? 200 : 100), 50, NR % 7 }' a1.xyz > colors.xyz
guess="columns 4 to 6 are no unit vectors and not taken for normals; --columns can name them"
for mode in --convert-only --keep-density; do
  run_plainly colors.xyz "plain$mode.ply" "$mode"
  check "colors without names, $mode" test "$status" -eq 0
  check "colors are no normals, $mode" grep -qx "l0_resample: warning: colors.xyz: $guess" stderr
done
coordinates="double x,double y,double z,"
check "colors without names are left out" \
  test "$(properties plain--convert-only.ply)" = "$coordinates"
for option in --orient-by-normals --use-normals; do
  run_plainly colors.xyz none.ply "$option"
  check "colors are no normals for $option" test "$status" -eq 3 -a ! -e none.ply
  check "the refusal says so" grep -q -- "$option is given, but the file has no normals" stderr
done
names=(--columns "x,y,z,red,green,blue")
run_plainly colors.xyz colors.ply --convert-only "${names[@]}"
check "columns with names" test "$status" -eq 0 -a ! -s stderr
color="uchar red,uchar green,uchar blue,"
check "a color" test "$(properties colors.ply)" = "$coordinates$color"
check "its numbers" test "$(tail -c 27 colors.ply | od -An -t u1 -j 24)" = " 200  50   4"
run_plainly colors.xyz carried.ply "${names[@]}"
normal="double nx,double ny,double nz,"
check "colors go along" test "$(properties carried.ply)" = "$coordinates$normal$color"
awk '{ print "p" NR, $3, $2, $1, -1, 0, 0, NR, NR / 2 }' a1.xyz > odd.xyz
run_plainly odd.xyz odd.ply --convert-only --columns -,z,y,x,nx,ny,nz,label,_
check "columns in another order" test "$status" -eq 0 \
  -a "$(properties odd.ply)" = "$coordinates${normal}int label,"
run_plainly odd.ply odd_again.xyz --convert-only
awk '{ printf "%.6f %.6f %.6f\n", $1, $2, $3 }' odd_again.xyz > positions.xyz
check "coordinates in another order" cmp positions.xyz a1.xyz
check "normals with names are taken as they are" \
  test "$(awk '$4 == -1 && $5 == 0' odd_again.xyz | wc -l)" -eq 3000
check_plain_failure 2 "--columns x,y,red: x, y and z have" colors.xyz none.ply --columns x,y,red
check_plain_failure 2 "--columns: a1.ply is no text" a1.ply none.ply --columns x,y,z
check_plain_failure 3 "colors.xyz: line 1: --columns names 3, found 6" \
  colors.xyz none.ply --columns x,y,z
check_plain_failure 3 "line 1: 'p1' is not a number" odd.xyz none.ply --columns x,y,z,a,b,c,d,e,f
run_plainly a1.xyz a2.xyz --output-directory named --columns x,y,z --output-format ply
check "columns of a batch" test "$status" -eq 0 -a "$(ls named)" = "$(printf 'a1.ply\na2.ply')"

# Decimal commas, if an option says so
sed 's/\./,/g' a1.xyz > commas.txt
check_plain_failure 3 "--decimal-comma reads numbers such as 0,5" commas.txt none.ply
run_plainly commas.txt commas.xyz --convert-only --decimal-comma
awk '{ printf "%.6f %.6f %.6f\n", $1, $2, $3 }' commas.xyz > positions.xyz
check "decimal commas" cmp positions.xyz a1.xyz
check_plain_failure 2 "--decimal-comma: a1.ply is no text" a1.ply none.ply --decimal-comma

# A table with a header, which is read and not written
awk 'BEGIN { print "X;Y;Z;class" } { print $1 ";" $2 ";" $3 ";" NR % 3 }' a1.xyz > table.csv
run_plainly table.csv table.ply --convert-only
check "a table" test "$status" -eq 0 -a ! -s stderr \
  -a "$(properties table.ply)" = "${coordinates}int class,"
run_plainly table.csv table.xyz --convert-only --quiet
awk '{ printf "%.6f %.6f %.6f\n", $1, $2, $3 }' table.xyz > positions.xyz
check "the points of a table" cmp positions.xyz a1.xyz
run_plainly table.csv another.ply --convert-only --columns z,y,x,-
check "names for the columns of a table" test "$(properties another.ply)" = "$coordinates"
run_plainly table.csv labeled.xyz --quiet
run_plainly table.csv labeled.ply
check "labels of a table stay labels" test "$(properties labeled.ply)" = \
  "$coordinates${normal}int class,"
check_plain_failure 2 "none.csv: CSV and OBJ are read, but not written" a1.xyz none.csv
check_plain_failure 2 "--output-format" a1.xyz none.ply --output-format csv
run_plainly table.csv --output-directory tables --points 20
check "the result of a table in a batch" test "$status" -eq 0 \
  -a "$(number_of_points tables/table.ply)" -eq 20

awk '{ print "v", $0; print "vn 0 0 1" }' a1.xyz > points.obj
run_plainly points.obj - --convert-only --output-format xyz
check "the points and normals of OBJ" test "$status" -eq 0 -a "$(grep -c ' 0 0 1$' stdout)" -eq 3000

# LAS of a survey, with classes 0 to 4 and up to two returns
awk 'BEGIN { print "X,Y,Z,classification,return_number,number_of_returns,intensity,r,g,b" }
     { printf "%.6f,%.6f,%.6f,%d,%d,2,%d,7,0,255\n",
       $1 + 637000, $2 + 5849000, $3, NR % 5, 1 + NR % 2, NR }' a1.xyz > survey.csv
run_plainly survey.csv survey.las --convert-only
check "LAS" test "$status" -eq 0 -a ! -s stderr -a "$(head -c 4 survey.las)" = LASF
run_plainly --info survey.las
check "what LAS is" \
  grep -qx "LAS:             1.4, point format 7, scale .*, no coordinate system" stdout
check "its properties" grep -q "^properties: .*intensity, return_number, .*red, green, blue$" stdout
run_plainly survey.las survey.ply --convert-only
check "the properties of LAS" test "$status" -eq 0 -a "$(number_of_points survey.ply)" -eq 3000 \
  -a "$(properties survey.ply | tr ',' '\n' \
    | grep -c 'uchar \(red\|green\|blue\|classification\)$')" -eq 4
run_plainly survey.las same.las --convert-only
check "LAS as it is" cmp survey.las same.las
run_plainly survey.las ground.las --keep-classes 2 --first-returns -n 500 --json ground.json
check "the report has the classes" test "$(tr -d ' \n' < ground.json \
  | grep -c '"keep_classes":\[2\],"first_returns":true,')" -eq 1
check "the ground of a survey" test "$status" -eq 0
check "a note on what is left out" grep -qx \
  "l0_resample: note: survey.las: 2700 points are left out by --keep-classes or --first-returns" \
  stderr
run_plainly ground.las ground.csv.ply --convert-only --keep-classes 2
check "all of one class" test "$status" -eq 0 -a ! -s stderr \
  -a "$(number_of_points ground.csv.ply)" -eq 500
run_plainly --info survey.ply --keep-classes 1,3
check "classes of PLY" grep -qx "points:          1200" stdout
check_plain_failure 3 \
  "a1.xyz: --first-returns is given, but the points have no property 'return_number'" \
  a1.xyz none.ply --first-returns
for classes in 2,x 256 -1 2,,6 2, ""; do
  check_plain_failure 2 "--keep-classes" survey.las none.ply "--keep-classes=$classes"
done
# a record of the coordinate system, between header and points
{ head -c 96 survey.las; printf '\xb0\1\0\0\1\0\0\0'; head -c 375 survey.las | tail -c +105
  printf '\0\0LASF_Projection\0\x40\x08\3\0'; head -c 32 /dev/zero; printf WKT
  tail -c +376 survey.las; } > placed.las
run_plainly placed.las placed.ply -n 100
check "a coordinate system has no place" grep -qx \
  "l0_resample: note: placed.ply: only LAS has a place for the coordinate system of the input" \
  stderr
run_plainly placed.las placed_too.las -n 100
check "a coordinate system goes along" test "$status" -eq 0 -a ! -s stderr \
  -a "$(head -c 432 placed_too.las | tail -c 57 | tr -d '\0' | tail -c 3)" = WKT
# the same record behind the points, where others have read a part of standard input
little_endian()   # a number below 2^24, in eight bytes
{
  local byte
  for byte in $(($1 % 256)) $(($1 / 256 % 256)) $(($1 / 65536)); do
    printf "\\x$(printf '%02x' "$byte")"
  done
  printf '\0\0\0\0\0'
}
{ printf 'seen'; head -c 235 survey.las; little_endian "$(stat -c %s survey.las)"
  printf '\1\0\0\0'; tail -c +248 survey.las
  printf '\0\0LASF_Projection\0\x40\x08\3\0\0\0\0\0\0\0'; head -c 32 /dev/zero
  printf WKT; } > late.las
{ dd bs=4 count=1 of=/dev/null status=none
  "$program" - late_too.las --input-format las --convert-only; } < late.las > stdout 2> stderr
check "a record behind the points" cmp late_too.las placed.las
dd if=late.las bs=4 skip=1 status=none \
  | "$program" - late_too.las --input-format las --convert-only --force > stdout 2> stderr
check "a record behind the points of a pipe" cmp late_too.las placed.las
{ head -c 104 survey.las; printf '\x87'; tail -c +106 survey.las; } > packed.laz
check_plain_failure 3 "packed.laz: byte 375: LAZ is not read: give a command with --decompress" \
  packed.laz none.ply
check_plain_failure 2 "none.laz: LAZ is not written" survey.las none.laz
mkdir surveys; cp survey.las surveys/a.laz; cp packed.laz surveys/b.laz
run_plainly surveys --output-directory resampled -n 100 --quiet
check "a batch of LAZ, of which some is none" test "$status" -eq 3 -a "$(ls resampled)" = a.las

# LAZ through a command; base64 stands for what compresses it
mkdir "it's \"a\"; {}"; base64 survey.las > "it's \"a\"; {}/\$1.laz"; base64 survey.las > text.laz
run_plainly "it's \"a\"; {}/\$1.laz" unpacked.las --convert-only --decompress 'base64 -d {}'
check "LAZ through a command" cmp unpacked.las survey.las
cat packed.laz > packed.las
run_plainly packed.las by_content.las --convert-only --decompress 'cat survey.las # {}'
check "LAZ in a file .las" cmp by_content.las survey.las
run_plainly survey.las as_it_is.las --convert-only --decompress 'cat packed.las # {}'
check "LAS needs no command" cmp as_it_is.las survey.las
check_plain_failure 3 "packed.las: byte 375: LAZ is not read: give a command with --decompress" \
  packed.las none.ply --decompress 'cat {}'
"$program" - none.ply --input-format las --decompress 'cat survey.las # {}' \
  < packed.las > stdout 2> stderr
check "nor is LAZ in a pipe" grep -q "LAZ is not read: .* a file that is no pipe" stderr
run_plainly text.laz survey.las --output-directory through --convert-only \
  --decompress 'base64 -d < {}'
check "LAZ in a batch" cmp through/text.las through/survey.las
check_plain_failure 3 "text.laz: byte 227: the file ends here" \
  text.laz none.ply --decompress 'base64 -d {} | head -c 300'
check_plain_failure 3 "'base64 -d {}; exit 7' ended with status 7" \
  text.laz none.ply --decompress 'base64 -d {}; exit 7'
check_plain_failure 3 "'kill -9 \$\$ {}' was ended by signal 9" \
  text.laz none.ply --decompress 'kill -9 $$ {}'
check_plain_failure 2 "--decompress: laszip has no {}" text.laz none.ply --decompress laszip
run_plainly text.laz none.ply --timeout 1 --decompress 'echo $$ > process; exec sleep 1000 # {}'
check "a command that never ends" test "$status" -eq 1 -a -s process
check "the command is ended" test ! -e "/proc/$(cat process)"

# Compressed files
gzip -c a1.xyz > packed.xyz.gz
run_plainly packed.xyz.gz unpacked.xyz --convert-only --quiet
awk '{ printf "%.6f %.6f %.6f\n", $1, $2, $3 }' unpacked.xyz > positions.xyz
check "a compressed file" cmp positions.xyz a1.xyz
gzip -c a1.xyz | "$program" - - --convert-only --input-format xyz --output-format xyz \
  > stdout 2> stderr
check "a compressed pipe" cmp stdout unpacked.xyz
run_plainly packed.xyz.gz --output-directory unpacked --points 20
check "the result of a compressed file in a batch" test "$(ls unpacked)" = packed.xyz
check_plain_failure 2 "none.ply.gz: compressed files are read, but not written" a1.xyz none.ply.gz
head -c 1000 packed.xyz.gz > cut.xyz.gz
check_plain_failure 3 "cut.xyz.gz: the compressed data end early" cut.xyz.gz none.ply

# A text without a point, as an empty file of another format
: > empty.xyz; : > empty.ply; printf '# x y z\n\n' > comment.xyz; echo 0 > zero.xyz
check_plain_failure 3 "empty.ply: the file is empty" empty.ply none.ply
check_plain_failure 3 "empty.xyz: line 1: the file has no points" empty.xyz none.ply
check_plain_failure 3 "the file has no points" comment.xyz none.ply --convert-only
run_plainly zero.xyz zero.ply
check "a text that announces no points" test "$status" -eq 0 -a "$(number_of_points zero.ply)" -eq 0

# A batch that a glob of the shell has made: what no reader knows is listed at the end
mkdir scans scans/pictures; cp a1.xyz a2.xyz scans; : > scans/pictures/a.png
echo notes > scans/notes.txt; echo old > scans/z.e57
run_plainly scans/* --output-directory batch --points 40 --json batch.json
check "status of a batch with strays" test "$status" -eq 3
check "the others of a batch with strays" test "$(ls batch)" = "$(printf 'a1.xyz\na2.xyz')"
check "the line of a stray" \
  grep -q '^l0_resample: scans/notes.txt: line 1: a point needs 3 numbers' stderr
check "the line of a folder of strays" grep -q '^l0_resample: scans/pictures: the folder has' stderr
check "the number of strays" test "$(wc -l < stderr)" -eq 4 \
  -a "$(tail -n 1 stderr)" = "l0_resample: 3 of 5 files failed"
check "strays in the report" test "$(grep -c '"exit_status": 3' batch.json)" -eq 3
check "nothing is left behind at the end" no_temporary_files

end_of_checks
