#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# G8: Ctrl-C while l0_resample works on a device ends it with status 130, and leaves no file.
# Skipped where there is no device.
# usage: test_tool_cuda_cancelled.sh PROGRAM

set -u -m   # job control, since a script's background jobs ignore SIGINT without it
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

# A sphere of radius 1; the blocks around its cells are full.
awk 'BEGIN { srand(1); for (i = 0; i < 1000000; ++i) {
  z = 2 * rand() - 1; a = 6.2831853 * rand(); s = sqrt(1 - z * z)
  printf "%.6f %.6f %.6f\n", s * cos(a), s * sin(a), z } }' > sphere.xyz
head -n 1000 sphere.xyz > small.xyz
"$program" small.xyz small.ply --device cuda --quiet 2> reason
if [ $? -ne 0 ]; then
  echo "skipped: $(cat reason)"
  exit 77
fi

failures=0 cancelled=0
for delay in 0.1 0.3 0.6 0.9 1.2 1.5 2; do
  timeout --foreground -s KILL 60 "$program" sphere.xyz result.ply --device cuda \
    --neighbor-radius 0.5 --percentage 90 --quiet > /dev/null 2> message &
  job=$!
  sleep "$delay"
  start=$(date +%s%N)
  if ! kill -INT $job 2> /dev/null; then
    echo "after $delay s the work was done"
    wait $job
    break
  fi
  wait $job
  status=$?
  echo "after $delay s: status $status, $((($(date +%s%N) - start) / 1000000)) ms later"
  if [ $status -eq 0 ] && [ -e result.ply ]; then
    echo "the work was done before the signal came"
    break
  fi
  cancelled=$((cancelled + 1))
  if [ $status -ne 130 ] || [ -e result.ply ] || [ -n "$(find . -name '*.tmp')" ]; then
    echo "failed: status $status after $delay s: $(cat message)" >&2
    failures=$((failures + 1))
  fi
done
if [ $cancelled -eq 0 ]; then
  echo "failed: nothing was cancelled" >&2
  failures=1
fi
exit $((failures > 0))
