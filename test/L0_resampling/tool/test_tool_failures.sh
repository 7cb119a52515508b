#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the program l0_resample answers where it cannot do what is asked: its exit statuses, one line
# that says why, and no harm to a file that is there.
# usage: test_tool_failures.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"
make_inputs bad.xyz comma.xyz long.xyz old.ply

# Input refused: 3
check_failure 3 "missing.ply: cannot be opened: No such file" missing.ply old.ply
check_failure 3 "Is a directory" . old.ply --input-format ply
check_failure 3 "comma.xyz: line 2: '0,5' is not a number" comma.xyz old.ply
awk '{ for (i = 0; i < 50; ++i) print }' cube.xyz > more.xyz
check_failure 3 "--percentage asks for more than 4294967294" more.xyz old.ply --percentage 1000000
check_failure 3 "--max-points" cube.xyz old.ply --max-points 9599
check_failure 3 "has no normals" cube.xyz old.ply --use-normals
check_failure 3 "has no normals" cube.xyz old.ply --orient-by-normals
printf '%s\n' ply 'format binary_little_endian 1.0' 'element vertex 1000000000000000' \
  'property double x' 'property double y' 'property double z' end_header > huge.ply
check_failure 3 "huge.ply: line 7: 1000000000000000 points are announced" huge.ply old.ply
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
# also where there is a device
CUDA_VISIBLE_DEVICES=-1 check_failure 1 "--device cuda" cube.xyz old.ply --device cuda
check_failure 1 "--max-memory" cube.xyz old.ply --max-memory 10kb
check_failure 1 "--max-memory" cube.xyz old.ply --max-memory 300kb
check_failure 1 "--timeout" cube.xyz old.ply --timeout 0.001 --neighbor-radius 0.5
mkfifo silent.xyz
sleep 60 > silent.xyz &   # an input that never comes
sleeper=$!
check_failure 1 "--timeout" silent.xyz old.ply --timeout 0.2
(
  ulimit -v 150000   # in units of 1 KiB: less than the points of the result would take
  # the shadow memory of a sanitizer alone is more
  "$program" --version > /dev/null 2>&1 || exit "$failures"
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
    check "a full disk has its status, leaves the old file and nothing else" \
      test "$answer" = "4 old old.ply"
    reason='about [0-9]* bytes are needed, the disk has room for [0-9]*'
    check "a full disk is named" \
      grep -q "^l0_resample: disk/old.ply: cannot be written: $reason\$" stderr
  fi
fi

# Write-protected files stop nobody who is root
unprivileged=()
test "$(id -u)" -ne 0 || unprivileged=(setpriv --reuid 65534 --regid 65534 --clear-groups)
chmod 755 "$folder"; mkdir -m 777 protected
echo old > protected/old.ply; chmod 444 protected/old.ply
mkdir -m 555 closed
for target in protected/old.ply closed/out.ply; do
  "${unprivileged[@]}" "$program" --force cube.xyz "$target" > stdout 2> stderr
  check "status of a write to $target" test $? -eq 4
  check "reason of a write to $target" \
    grep -q "^l0_resample: $target: cannot be written: .*Permission denied" stderr
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

# Cancelled: 130 and 143, while the input is waited for and in the midst of the work, which would
# last for minutes
for signal in INT TERM; do
  expected=130; test $signal = INT || expected=143
  "${patient[@]}" "$program" --force silent.xyz old.ply > stdout 2> stderr & job=$!
  sleep 0.3; kill -$signal $job; wait $job
  check "status after SIG$signal while reading" test $? -eq $expected
  "${patient[@]}" "$program" --force long.xyz old.ply --neighbor-radius 1 \
    > stdout 2> stderr & job=$!
  sleep 1.5; kill -$signal $job; wait $job
  check "status after SIG$signal while computing" test $? -eq $expected
  check "one line after SIG$signal" test "$(wc -l < stderr)" -eq 1 -a ! -s stdout
done
kill $sleeper; wait $sleeper 2> /dev/null
check "a cancelled run leaves the old file" is_old old.ply
check "a cancelled run leaves no temporary file" no_temporary_files

end_of_checks
