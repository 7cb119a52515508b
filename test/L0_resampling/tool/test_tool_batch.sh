#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Batches of the program l0_resample: failures at the end, the others unharmed.
# usage: test_tool_batch.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"
make_inputs scans long.xyz same.xyz same.ply

# Its status is the one that all failures have, else 1
run scans/a.xyz scans/c.xyz scans/b.npy missing.ply --output-directory batch/new --points 30 \
  --output-format ply
check "status of a batch with failures of one kind" test "$status" -eq 3
check "files of a batch" test "$(ls batch/new)" = "$(printf 'a.ply\nb.ply')"
check "a result of a batch" test "$(number_of_points batch/new/b.ply)" -eq 30
check "a line for each success" test "$(grep -c '30 out' stdout)" -eq 2 -a "$(wc -l < stdout)" -eq 2
check "a line for each failure, and their number" cmp <(grep -v ': note: ' stderr) <(printf '%s\n' \
  "l0_resample: scans/c.xyz: line 2: '0,5' is not a number; $(echo \
    '--decimal-comma reads numbers such as 0,5')" \
  "l0_resample: missing.ply: cannot be opened: No such file or directory" \
  "l0_resample: 2 of 4 files failed")
run scans/a.xyz batch_alone.ply --points 30 --quiet
check "a batch gives what single runs give" cmp batch/new/a.ply batch_alone.ply
run scans --output-directory batch/folder --points 30 --json batch.json
check "a folder, each in its format" test "$status" -eq 3 \
  -a "$(ls batch/folder)" = "$(printf 'a.xyz\nb.npy\nd.pcd')"
check "the report of a batch" test "$(head -n 1 batch.json)" = "[" \
  -a "$(grep -c '"exit_status": 0' batch.json)" -eq 3 \
  -a "$(grep -c '"exit_status": 3' batch.json)" -eq 1 -a "$(tail -n 1 batch.json)" = "]"
mkdir -p batch/mixed/a.xyz
run scans/a.xyz scans/c.xyz --output-directory batch/mixed --quiet
check "status of a batch with failures of two kinds" \
  test "$status" -eq 1 -a "$(wc -l < stderr)" -eq 3
run scans/a.xyz scans/b.npy --output-directory batch/good --points 30 --quiet
check "a quiet batch" test "$status" -eq 0 -a ! -s stdout -a ! -s stderr
cp same.xyz scans/same.xyz; cp same.ply scans/same.ply; cp scans/notes.txt notes.txt
run notes.txt scans/same.xyz scans/same.ply --output-directory batch/seen --points 30 \
  --snapshot batch/pictures/new
check "pictures of a batch" test "$status" -eq 3 \
  -a "$(ls batch/pictures/new)" = "$(printf 'same.ply.png\nsame.xyz.png')"
check "each is a picture" \
  test "$(head -c 4 batch/pictures/new/same.ply.png | od -An -tx1)" = " 89 50 4e 47"
rm scans/same.*
check_failure 4 "cube.xyz/inside: cannot be made" scans/a.xyz --output-directory batch/same2 \
  --snapshot cube.xyz/inside
mkdir other; cp scans/a.xyz other/a.xyz
check_failure 2 "both scans/a.xyz and other/a.xyz" scans/a.xyz other/a.xyz \
  --output-directory batch/same
check_failure 2 "both scans/a.xyz and ./scans/a.xyz" scans/a.xyz ./scans/a.xyz \
  --output-directory batch/same
check_failure 2 "would take the place of the input scans/a.xyz" scans/a.xyz \
  --output-directory other/../scans
check_failure 2 "--snapshot: in a batch a folder expected" \
  scans/a.xyz --output-directory batch/same --snapshot picture.png
check_failure 2 "3 files" scans/a.xyz scans/b.npy out.ply
check_failure 2 "INPUT" --output-directory batch/same
check "a refused batch makes nothing" test ! -e batch/same
check_failure 4 "cannot be made" scans/a.xyz --output-directory cube.xyz/inside
mkdir texts; cp scans/a.xyz texts/a.TXT
run texts --output-directory batch/texts
check "a folder of texts" grep -qF 'but for .txt, which are read where they are named' stderr
run scans/notes.txt --output-directory batch/named --input-format xyz --output-format off
check "the input format of a batch" \
  grep -qF 'scans/notes.txt: line 1: a point needs 3 numbers' stderr
"${patient[@]}" "$program" scans/a.xyz long.xyz scans/b.npy --output-directory batch/cut \
  --neighbor-radius 1 > stdout 2> stderr & job=$!
sleep 2.5; kill -INT $job; wait $job
check "status of an interrupted batch" test $? -eq 130
check "an interrupted batch says what was not done" \
  grep -q '^l0_resample: 1 of 3 files failed, [12] not begun$' stderr
check "an interrupted batch leaves no temporary file" no_temporary_files
run long.xyz scans/b.npy --output-directory batch/slow --neighbor-radius 1 --timeout 0.2
check "the time of a batch is over" test "$status" -eq 1 -a ! -e batch/slow/b.npy
check "where the time was over" \
  grep -q '^l0_resample: long.xyz: the time given by --timeout is over$' stderr

end_of_checks
