#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# l0_resample --as-one --device cuda: tiles on a device, and runs that go on.
# Skipped where there is no device.
# usage: test_tool_cuda_tiles.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"

awk 'BEGIN { srand(2); for (i = 0; i < 6000; ++i) for (j = 0; j < 20; ++j) {
  x = i + rand() - .5; y = j + rand() - .5
  printf "%.6f %.6f %.6f\n", x, y, 2 * sin(x / 40) + .1 * (rand() - .5) } }' > ribbon.xyz
# holds the points once, and a third of them with what a device takes of them
memory=$(((96 << 20) + 33000000))
ribbon=(ribbon.xyz --as-one --points 60000 --memory "$memory")
on_device=("${ribbon[@]}" --device cuda)

value() { python3 -c "import json, sys; j = json.load(open(sys.argv[1])); print($2)" "$1"; }
same_tiles()
{
  for tile in whole/tile_*.ply; do
    cmp "$tile" "$1/$(basename "$tile")" || return 1
  done
}

run "${on_device[@]}" --output-directory whole --output merged.ply
if [ "$status" -ne 0 ] && grep -q "device" stderr; then
  check "a device that cannot be used is said before anything is made" test ! -e whole/index.json
  echo "skipped: $(cat stderr)"
  exit "$((failures > 0 ? 1 : 77))"
fi
check "a run by tiles on a device" test "$status" -eq 0
number=$(find whole -name 'tile_*.ply' | wc -l)
check "several tiles, of which there are $number" test "$number" -ge 2
check "as many points as asked for" test "$(number_of_points merged.ply)" -eq 60000
check "where tiles overlap they agree" test "$(value whole/index.json \
  "j['overlap']['matches'] > 0.99 * j['overlap']['samples'] > 100 and j['overlap']['opposed'] == 0
   and j['overlap']['root_mean_square_distance'] < 0.01 * j['sample_spacing']")" = True

run "${on_device[@]}" --output-directory again
check "once more gives the same bytes" same_tiles again

for task in begin count:0 blocks:0 shard:0 scales:0 solve:1; do
  run "${on_device[@]}" --output-directory tasks --task "$task"
  check "task $task" test "$status" -eq 0
done
run "${ribbon[@]}" --output-directory tasks --resume
check "a run on the device does not go on on the CPU" test "$status" -eq 2
run "${on_device[@]}" --output-directory tasks --resume
check "but on a device" test "$status" -eq 0
check "and gives the same bytes" same_tiles tasks

end_of_checks
