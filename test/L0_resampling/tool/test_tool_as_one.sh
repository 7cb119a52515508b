#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# l0_resample --as-one: several tiles are as one, and a run goes on after any fault.
# usage: test_tool_as_one.sh PROGRAM

# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"

# A long wavy ribbon, whose tiles need less than all of it around them; in three files
awk 'BEGIN { srand(2); for (i = 0; i < 1200; ++i) for (j = 0; j < 20; ++j) {
  x = i + rand() - .5; y = j + rand() - .5
  printf "%.6f %.6f %.6f\n", x, y, 2 * sin(x / 40) + .1 * (rand() - .5) } }' > ribbon.txt
mkdir parts
sed -n '1,9000p' ribbon.txt > parts/a.xyz
sed -n '9001,9100p' ribbon.txt > parts/b.xyz
sed -n '9101,$p' ribbon.txt > c.xyz
run c.xyz parts/c.ply --convert-only
# what the program takes anyway, and what 12500 points with half as many samples do: too little to
# find the facts of all 24000, for which 6 MB are enough
memory=$(((96 << 20) + 12500 * 340))
more_memory=$(((96 << 20) + 6000000))
ribbon=(parts --as-one --points 12000 --memory "$memory")
with_facts=(parts --as-one --points 12000 --memory "$more_memory")

value() # of a JSON file: an expression of Python, where it is j
{
  python3 -c "import json, sys; j = json.load(open(sys.argv[1])); print($2)" "$1"
}
holds() { test "$(value "$1" "$2")" = True; }
same_tiles() # as those of the run that nothing has disturbed, or of another
{
  for tile in "${2:-whole}"/tile_*.ply; do
    cmp "$tile" "$1/$(basename "$tile")" || return 1
  done
}
number_of_tiles() { find "$1" -name 'tile_*.ply' | wc -l; }

run "${ribbon[@]}" --output-directory whole --output merged.ply --json whole.json
check "a run by tiles" test "$status" -eq 0
check "one line of summary" test "$(wc -l < stdout)" -eq 1 -a ! -s stderr
check "more tiles than files" test "$(number_of_tiles whole)" -ge 4
check "nothing else is left" test "$(find whole -type f | wc -l)" \
  -eq $(($(number_of_tiles whole) + 1))
check "tiles have exactly as many points as asked for" holds whole/index.json \
  "sum(t['output_points'] for t in j['tiles']) == 12000 == j['output_points']"
check "so has the file of all" test "$(number_of_points merged.ply)" -eq 12000
check "each tile has those that the index says" holds whole/index.json \
  "all(('element vertex %d\n' % t['output_points']).encode()
       in open('whole/' + t['file'], 'rb').read(300)
       for t in j['tiles'])"
check "all points of the input are in one tile" holds whole/index.json \
  "sum(t['input_points'] for t in j['tiles']) == 24000"
check "where tiles overlap they agree" holds whole/index.json \
  "j['overlap']['matches'] > 0.99 * j['overlap']['samples'] > 100 and j['overlap']['opposed'] == 0
   and j['overlap']['root_mean_square_distance'] < 0.01 * j['sample_spacing']"
check "a report of the phases" holds whole.json \
  "[p['name'] for p in j['phases']]
   == ('count blocks shard scales neighbors medians balls share samples solve stitch write merge'
       ' finish').split()
   and all(p['kept'] == 0 for p in j['phases']) and j['exit_status'] == 0"
check "no more memory than allowed" holds whole.json "0 < j['peak_bytes'] <= $memory"
run merged.ply merged.xyz --convert-only
check "normals are of one side" \
  test "$(awk '{ print ($6 > 0) }' merged.xyz | sort -u | wc -l)" -eq 1
# Along the ribbon, no step, gap or pile at any border
check "no seam" awk '{ ++n[int(($1 + 20) / 20)] } END {
  for (i = 2; i <= 59; ++i) if (n[i] < 180 || n[i] > 222) { print i, n[i]; exit 1 } }' merged.xyz

run "${ribbon[@]}" --output-directory threads --threads 1
check "one thread gives the same" same_tiles threads
run parts --as-one --points 12000 --memory 4GB --output-directory single
check "a single tile, if memory suffices" test "$(number_of_tiles single)" -eq 1

# Memory for all points once
run "${with_facts[@]}" --output-directory facts --output facts.xyz --json facts.json
check "more tiles than one" test "$status" -eq 0 -a "$(number_of_tiles facts)" -ge 2
check "no more memory than allowed with facts" holds facts.json \
  "0 < j['peak_bytes'] <= $more_memory"
check "samples start where the facts say" holds facts.json \
  "[p['name'] for p in j['phases']]
   == 'count blocks shard scales solve stitch write merge finish'.split()"
check "the same radius" test "$(value facts/index.json "j['neighbor_radius']")" = \
  "$(value single/index.json "j['neighbor_radius']")"
run single/tile_0.ply single.xyz --convert-only
check "the same points and sides, but for a few in ten thousand" test \
  "$(comm -23 <(sort facts.xyz) <(sort single.xyz) | wc -l)" -le 12
run "${with_facts[@]}" --output-directory wide --output wide.xyz --halo 50
check "more tiles than one with a wide halo" test "$status" -eq 0 -a "$(number_of_tiles wide)" -ge 2
check "the same bits with a wide halo" cmp <(sort wide.xyz) <(sort single.xyz)
check_plain_failure 2 "--resume: the run began with --halo 50, now it is --halo 40" \
  "${with_facts[@]}" --output-directory wide --output wide.xyz --resume
run "${with_facts[@]}" --output-directory facts_threads --threads 1
check "one thread gives the same with facts" same_tiles facts_threads facts

# Strays over the ribbon, each alone
awk 'BEGIN { for (i = 0; i < 60; ++i) print 20 * i, 10, 30 + 20 * (i % 3) }' > strays.xyz
for sensitivity in 0 1; do
  run parts strays.xyz --as-one --points 12000 --memory 4GB --outlier-sensitivity $sensitivity \
    --output-directory "sensitivity_$sensitivity"
  of_tiles=$(value "sensitivity_$sensitivity/index.json" "sum(t['outliers'] for t in j['tiles'])")
  check "as sensitive as asked for" test "$status" -eq 0 -a "$of_tiles" -eq $((60 * sensitivity))
  check "the whole says the same" test "$of_tiles" -eq \
    "$(value "sensitivity_$sensitivity/index.json" "j['outliers']")"
done

# A folder that has a run
check_plain_failure 4 "has an earlier run of --as-one: --resume goes on with it" "${ribbon[@]}" \
  --output-directory whole
check_plain_failure 4 "with other options or inputs: --force begins anew" "${ribbon[@]}" \
  --output-directory whole --halo 30
run_plainly "${ribbon[@]}" --output-directory whole --output merged.ply --resume
check "nothing is left to be done" test "$status" -eq 0
check "which is said" grep -q "all was done already" stdout
run "${ribbon[@]}" --output-directory threads
check "--force begins anew" test "$status" -eq 0

# Files of others in the folder stay, and no result takes the place of an input
one_tile=(c.xyz --as-one --points 100 --memory 1GB --output-format xyz)
for value in 0 1001 wide; do
  check_failure 2 "--halo" "${one_tile[@]}" --output-directory others --halo "$value"
done
check_failure 2 "--halo" c.xyz --output-directory others --halo 30
cp c.xyz as_it_was.xyz
for name in index.json tile_0.xyz; do
  rm -rf others; mkdir others; echo old > others/$name
  check_plain_failure 4 "others/$name: the file exists; --force replaces it" "${one_tile[@]}" \
    --output-directory others
  check "$name of others stays" is_old others/$name
  run "${one_tile[@]}" --output-directory others
  check "--force replaces $name" test "$status" -eq 0 -a "$(wc -l < others/tile_0.xyz)" -eq 100
done
rm -rf others; mkdir -p others/work; echo old > others/work/mine
check_failure 4 "others/work: has something that is of no run" "${one_tile[@]}" \
  --output-directory others
check "a folder work of others stays" is_old others/work/mine
rm -rf others; mkdir others; echo old > others/tile_0.ply; echo old > others/tile_0.xyz.bak
run_plainly "${one_tile[@]}" --output-directory others
check "other names are in nobody's way" test "$status" -eq 0
check "and stay" is_old others/tile_0.ply
cp c.xyz others/tile_7.xyz
check_failure 2 "others/tile_7.xyz: a result would take the place" others/tile_7.xyz \
  "${one_tile[@]}" --output-directory others
check_failure 2 "others/tile_0.xyz: --force would remove this input" others/tile_0.xyz \
  "${one_tile[@]:1:5}" --output-directory others
check_failure 2 "a result would take the place" "${one_tile[@]}" --output-directory others \
  --output ./c.xyz
check_failure 2 "c.xyz: is named twice" "${one_tile[@]}" --output-directory others --json c.xyz
check_failure 2 "merged.xyz: is named twice" "${one_tile[@]}" --output-directory others \
  --output merged.xyz --json merged.xyz
for name in index.json tile_3.xyz work/report.json; do
  check_failure 2 "others/$name: is the name of a tile" "${one_tile[@]}" --output-directory others \
    --json others/$name
done
check "inputs are what they were" cmp c.xyz as_it_was.xyz
check "also in the folder of a run" cmp others/tile_7.xyz as_it_was.xyz

# Killed in the middle of each phase: past a file, of a run whose undisturbed result is in a folder.
# The rest are the words of the run.
check_after_kill()
{
  file=$1 undisturbed=$2
  shift 2
  rm -rf killed
  "$program" "$@" --output-directory killed > stdout 2> stderr &
  while ! test -e "killed/work/$file" && kill -0 $! 2> /dev/null; do sleep 0.005; done
  kill -KILL $! 2> /dev/null
  wait $! 2> /dev/null
  run_plainly "$@" --output-directory killed --resume --json killed.json
  check "goes on after a kill past $file" test "$status" -eq 0
  check "keeps what was there past $file" \
    holds killed.json "sum(p['kept'] for p in j['phases']) > 0"
  check "as if nothing had been past $file" same_tiles killed "$undisturbed"
}
for file in count_1 shard_0 share_1 solve_2; do
  check_after_kill $file whole "${ribbon[@]}"
done
for file in scales_0 solve_0; do
  check_after_kill $file facts "${with_facts[@]}"
done

# Damaged files are made again, and named
begin_run() # up to the samples of each tile: the folder, and the words of the run
{
  rm -rf "$1"
  for task in begin count:0 count:1 count:2 blocks shard:0 shard:1 shard:2 scales; do
    run_plainly "${@:2}" --output-directory "$1" --task $task
    check "task $task" test "$status" -eq 0
  done
}
begin_run damaged_points "${with_facts[@]}"
truncate -s 5000 damaged_points/work/points_0
run_plainly "${with_facts[@]}" --output-directory damaged_points --resume
check "goes on without what was known of each point" test "$status" -eq 0
check "names the file" grep -q "work/points_0: is damaged" stderr
check "as if it had not been damaged" same_tiles damaged_points facts
begin_run damaged "${ribbon[@]}"
run_plainly "${ribbon[@]}" --output-directory damaged --task list
check "phases with their numbers of tasks" grep -qx "solve $(number_of_tiles whole)" stdout
truncate -s 5000 damaged/work/shard_0
printf 'x' | dd of=damaged/work/shard_2 bs=1 seek=5000 conv=notrunc 2> /dev/null
run_plainly "${ribbon[@]}" --output-directory damaged --resume --json damaged.json
check "goes on with damaged files" test "$status" -eq 0
check "a truncated one is named" grep -q "damaged/work/shard_0: is damaged" stderr
check "one with another byte too" grep -q "damaged/work/shard_2: is damaged" stderr
check "both are made again" \
  holds damaged.json "[p['remade'] for p in j['phases'] if p['name'] == 'shard'] == [2]"
check "as if nothing had been" same_tiles damaged
check_plain_failure 2 "is no task of this run" \
  "${ribbon[@]}" --output-directory damaged --task solve:99

# No room on the disk
begin_run full "${ribbon[@]}"
(ulimit -f 30; "$program" "${ribbon[@]}" --output-directory full --resume > stdout 2> stderr)
check "a full disk" test $? -eq 4
check "leaves nothing half" no_temporary_files
run_plainly "${ribbon[@]}" --output-directory full --resume
check "goes on with room" test "$status" -eq 0
check "with the same result" same_tiles full

# Not enough memory
many_samples=(parts --as-one --points 2000000 --memory 4GB)
begin_run crowded "${many_samples[@]}"
(
  ulimit -v 500000   # in units of 1 KiB: less than so many samples take
  # the shadow memory of a sanitizer alone is more
  "$program" --version > /dev/null 2>&1 || exit "$failures"
  check_plain_failure 6 "solve 0: not enough memory; with a smaller --memory" "${many_samples[@]}" \
    --output-directory crowded --resume --task solve:0
  exit "$failures"
) || failures=$((failures + 1))

# LAZ through a command, which base64 stands for
mkdir surveys packed
run c.xyz surveys/c.las --convert-only
base64 surveys/c.las > packed/c.laz
run surveys --as-one --points 2000 --memory 1GB --output-directory unpacked
run packed --as-one --points 2000 --memory 1GB --output-directory through \
  --decompress 'base64 -d {}'
check "LAZ by tiles" cmp unpacked/tile_*.ply through/tile_*.ply

# Where the points were seen from, as all files say, or none does
pcd_of_cube()   # a file, its VIEWPOINT, and lines of the cube
{
  {
    printf '%s\n' 'VERSION 0.7' 'FIELDS x y z' 'SIZE 4 4 4' 'TYPE F F F' "WIDTH 4800" 'HEIGHT 1' \
      "VIEWPOINT $2 1 0 0 0" 'DATA ascii'
    sed -n "$3" cube.xyz
  } > "$1"
}
number_outwards() # of the normals of a text
{
  awk '$1 * $4 + $2 * $5 + $3 * $6 > 0' "$1" | wc -l
}
mkdir seen
pcd_of_cube seen/a.pcd '0 0 0.1' 1,4800p
pcd_of_cube seen/b.pcd '0 0 0.1' '4801,$p'
of_cube=(--as-one --points 2000 --memory 1GB --output-directory of_cube)
outwards="taking outwards for right (--viewpoint for a room seen from within)"
run seen "${of_cube[@]}" --output seen.xyz --output-format pcd
check "all normals to the viewpoint of the files" \
  test "$status" -eq 0 -a "$(number_outwards seen.xyz)" -eq 0
note="of_cube: normals face the viewpoint of the files, 0,0,0.1, unless --viewpoint none is given"
check "a note on it" grep -qx "l0_resample: note: $note" stderr
check "outwards is not assumed" test "$(grep -cF "$outwards" stdout)" -eq 0 -a \
  "$(value of_cube/index.json "j['outwards_assumed']")" = False
check "the result has it too" grep -qx 'VIEWPOINT 0 0 0.1 1 0 0 0' --text of_cube/tile_0.pcd
run seen "${of_cube[@]}" --output outward.xyz --viewpoint none
check "none if none is asked for" test "$(number_outwards outward.xyz)" -eq 2000 -a ! -s stderr
run cube.xyz "${of_cube[@]}" --output plain.xyz
check "outwards is assumed of files without one" \
  test "$(number_outwards plain.xyz)" -eq 2000 -a "$(grep -cF "$outwards" stdout)" -eq 1
check "as the index says" holds of_cube/index.json "j['outwards_assumed']"
for viewpoint in '0 0 0.2' '0 0 0'; do
  pcd_of_cube seen/b.pcd "$viewpoint" '4801,$p'
  run seen "${of_cube[@]}" --output differ.xyz
  check "none of several" test "$status" -eq 0 -a "$(number_outwards differ.xyz)" -eq 2000
  check "which is said" grep -q "warning: of_cube: the files have different viewpoints" stderr
  check "also in the index" grep -q "the files have different viewpoints" of_cube/index.json
  check "beside outwards: $viewpoint" grep -qF "$outwards" stdout
done
run seen "${of_cube[@]}" --output seen.xyz --viewpoint 0,0,0.1
check "that of the option for all" test "$(number_outwards seen.xyz)" -eq 0 -a ! -s stderr

# What a run may not go on with
begin_run changed "${ribbon[@]}"
check_plain_failure 2 "--resume: the run began with --seed 0, now it is --seed 1" "${ribbon[@]}" \
  --output-directory changed --resume --seed 1
touch parts/b.xyz
check_plain_failure 3 "parts/b.xyz" "${ribbon[@]}" --output-directory changed --resume
run_plainly c.xyz --as-one --points 100 --memory 1GB --output-directory as_xyz --task begin
check_plain_failure 3 "c.xyz: csv, " c.xyz --as-one --points 100 \
  --memory 1GB --output-directory as_xyz --resume --input-format csv
check "a run says which compiler has made the program, and how" \
  grep -qE '^compiler (g|clang)\+\+ [0-9].*, [A-Z]' \
  as_xyz/work/run
check "and a hash of its sources" grep -qE '^sources [0-9a-f]{64}$' as_xyz/work/run
cp as_xyz/work/run as_it_began
for what in compiler sources; do
  sed "s/^$what .*/$what of another machine/" as_it_began > as_xyz/work/run
  check_plain_failure 2 "the run began with $what of another machine, now it is $what" \
    c.xyz --as-one --points 100 --memory 1GB --output-directory as_xyz --resume
done
check_failure 6 "--memory" parts --as-one --points 100 --memory 90MB --output-directory none
check_failure 6 "do not hold a part of the cloud" parts --as-one --points 12000 \
  --memory $(((96 << 20) + 100000)) --output-directory none
check_failure 2 "--memory" parts --as-one --points 100 --output-directory none
check_failure 2 "excludes" \
  parts --as-one --points 100 --memory 1GB --output-directory none --method lor
check_failure 3 "missing.xyz" missing.xyz --as-one --points 100 --memory 1GB --output-directory none
check_failure 3 "reads its files twice" /dev/stdin --as-one --points 100 --memory 1GB \
  --input-format xyz --output-directory none
echo '1 2 x' > parts/d.xyz
check_failure 3 "parts/d.xyz: line 1" "${ribbon[@]}" --output-directory none

end_of_checks
