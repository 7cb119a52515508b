#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# l0_resample --as-one: samples get the properties that they get where all points are in memory.
# usage: test_tool_as_one_properties.sh PROGRAM

helper=$(dirname "$(realpath "${BASH_SOURCE[0]}")")/colored_ribbon.py
# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"

value() # of a JSON file: an expression of Python, where it is j
{
  python3 -c "import json, sys; j = json.load(open(sys.argv[1])); print($2)" "$1"
}
holds() { test "$(value "$1" "$2")" = True; }
same_tiles() # of two folders
{
  for tile in "$1"/tile_*; do
    cmp "$tile" "$2/$(basename "$tile")" || return 1
  done
}
number_of_different_tiles()
{
  local number=0
  for tile in two/tile_*; do
    cmp -s "$tile" "order/$(basename "$tile")" || number=$((number + 1))
  done
  echo $number
}
number_of_tiles() { find "$1" -name 'tile_*' | wc -l; }
matches() # of the rows of tiles, those at places that a file has too; all have its properties
{
  python3 "$helper" compare "$1" "$2"/tile_*.ply > matches 2> stderr
}
number_of_matches() { cut -d ' ' -f 1 matches; }

check "a cloud" python3 "$helper" make
options=(--points 12000 --keep-outliers)
run whole.ply memory.ply "${options[@]}"
check "in memory" test "$status" -eq 0

# What decides on the tiles is memory: for all, for the facts of all, and less
memory_for_two=$(((96 << 20) + 6500000))
memory_for_more=$(((96 << 20) + 3000000))
run parts --as-one "${options[@]}" --memory 4GB --output-directory one --json one.json
check "one tile" test "$status" -eq 0 -a "$(number_of_tiles one)" -eq 1
check "nothing to be said" test ! -s stderr
check "the properties of the call in memory" matches memory.ply one
check "of each sample" test "$(number_of_matches)" -eq 12000
check "the phase is reported" holds one.json \
  "[p['name'] for p in j['phases']]
   == 'count blocks shard scales solve carry stitch write finish'.split()"
check "rows of properties count among the bytes" holds one.json \
  "[p['bytes'] for p in j['phases'] if p['name'] == 'shard'][0] > 25612 * (24 + 8 + 14)"

two=(parts --as-one "${options[@]}" --memory "$memory_for_two")
run "${two[@]}" --output-directory two --output merged.ply
check "some tiles" test "$status" -eq 0 -a "$(number_of_tiles two)" -ge 2
check "the same properties" matches memory.ply two
check "where samples are the same" test "$(number_of_matches)" -ge 11900
python3 "$helper" compare merged.ply two/tile_*.ply > matches
check "one file of all has them too" test $? -eq 0 -a "$(number_of_matches)" -eq 12000
run "${two[@]}" --output-directory threads --threads 1
check "one thread gives the same" same_tiles two threads
run rotated.ply memory_of_rotated.ply "${options[@]}"
run parts/c.ply parts/a.ply parts/b.ply "${two[@]:1}" --output-directory order
check "files in another order" matches memory_of_rotated.ply order
check "where samples are the same too" test "$(number_of_matches)" -ge 11900
check "are not as in the first" test "$(number_of_different_tiles)" -ge 1

# Tiles that are too small for the facts of the cloud
more=(parts --as-one "${options[@]}" --memory "$memory_for_more" --halo 20)
run "${more[@]}" --output-directory more --json more.json
check "many tiles" test "$status" -eq 0 -a "$(number_of_tiles more)" -ge 8
check "samples have the labels of the nearest points" python3 "$helper" nearest more/tile_*.ply
check "no more memory than allowed" holds more.json "0 < j['peak_bytes'] <= $memory_for_more"

# Labels in floating-point numbers are those of near points, and no means of them, if all files have
# few values alone; if one has others, no file has labels
label_parts() # folder, what is added to the labels of the second part, row by row
{
  mkdir -p "$1"
  for part in 0 1; do
    {
      printf 'ply\nformat ascii 1.0\nelement vertex 4800\n'
      printf 'property float %s\n' x y z label
      printf 'end_header\n'
      awk -v part=$part -v more="$2" \
        'NR % 2 == part { print $0, ($1 > 0 ? 1000 : 7) + part * more * NR }' cube.xyz
    } > "$1/$part.ply"
  done
}
label_parts labels 0
label_parts fractions 0.001
for folder in labels fractions; do
  run "$folder" --as-one --points 3000 --memory 1GB --output-directory "of_$folder"
  check "tiles of $folder" test "$status" -eq 0
done
check "labels are those of points" \
  test "$(python3 "$helper" values label of_labels/tile_*.ply)" = "7.0 1000.0"
check "means are no labels" \
  test "$(python3 "$helper" values label of_fractions/tile_*.ply | wc -w)" -gt 4
cat labels/0.ply > one.ply
run one.ply one_labeled.ply
check "and so are those of one file" \
  test "$(python3 "$helper" values label one_labeled.ply)" = "7.0 1000.0"

# LAS, whose colors have 16 bits
run whole.ply whole.las --convert-only
check "parts in LAS" python3 "$helper" split whole.las las_parts
run whole.las memory_of_las.ply "${options[@]}"
las=(las_parts --as-one "${options[@]}")
run "${las[@]}" --memory "$memory_for_two" --output-directory las_two
check "tiles of LAS" test "$status" -eq 0 -a "$(number_of_tiles las_two)" -ge 2
check "have the properties of LAS in memory" matches memory_of_las.ply las_two
check "where samples are the same" test "$(number_of_matches)" -ge 11900
run whole.las memory.las "${options[@]}"
run memory.las memory_in_las.ply --convert-only
run "${las[@]}" --memory 4GB --output-format las --output-directory las_one
mkdir las_one_in_ply
run las_one/tile_0.las las_one_in_ply/tile_0.ply --convert-only
check "a result in LAS has them too" matches memory_in_las.ply las_one_in_ply
check "all of it" test "$(number_of_matches)" -eq 12000
cp -r las_parts las_of_both
check "a part whose colors are bytes" python3 "$helper" bytes las_of_both/b.las
las[0]=las_of_both
run "${las[@]}" --memory "$memory_for_two" --output-directory both_two
check "has the colors of the others" same_tiles las_two both_two
run "${las[@]}" --memory 4GB --output-format las --output-directory both_one
check "in LAS too" same_tiles las_one both_one
check "and nothing to be said" test ! -s stderr
check "and the coordinate system" grep -q 'LOCAL_CS\["a town"\]' las_one/tile_0.las

# Killed, or damaged
rm -rf killed
"$program" "${two[@]}" --output-directory killed > stdout 2> stderr &
while ! test -e killed/work/carry_0 && kill -0 $! 2> /dev/null; do sleep 0.005; done
kill -KILL $! 2> /dev/null
wait $! 2> /dev/null
run_plainly "${two[@]}" --output-directory killed --resume
check "goes on after a kill" test "$status" -eq 0
check "as if nothing had been" same_tiles two killed
for task in begin count:0 count:1 count:2 blocks shard:0 shard:1 shard:2 scales solve:0 solve:1 \
  carry:0 carry:1; do
  run_plainly "${two[@]}" --output-directory damaged --task $task
  check "task $task" test "$status" -eq 0
done
truncate -s 5000 damaged/work/carry_0
printf 'x' | dd of=damaged/work/rows_1 bs=1 seek=500 conv=notrunc 2> /dev/null
rm damaged/work/rows_2
run_plainly "${two[@]}" --output-directory damaged --resume --json damaged.json
check "goes on with damaged files" test "$status" -eq 0
check "names one of a tile" grep -q "damaged/work/carry_0: is damaged" stderr
check "and one of an input" grep -q "damaged/work/rows_1: is damaged" stderr
check "makes these again, and keeps the others" holds damaged.json \
  "[(p['kept'], p['remade']) for p in j['phases'] if p['name'] in ('shard', 'carry')]
   == [(1, 1), (1, 1)]"
check "as if nothing had been" same_tiles two damaged

# What cannot be carried
run "${two[@]}" --output-format off --output-directory off
check "OFF has colors" grep -q '^CNOFF' off/tile_0.off
check "and no place for others" \
  grep -qF "off: the format has no place for the property 'moisture'" stderr
check "which the index says too" holds off/index.json "len(j['warnings']) == 4"
run "${two[@]}" --output-format xyz --output-directory xyz --json xyz.json
check "XYZ needs none" holds xyz.json "'carry' not in [p['name'] for p in j['phases']]"
echo '0 0 0' > plain.xyz
check_failure 3 "plain.xyz: the points have no property 'red', as those of parts/a.ply have" \
  parts plain.xyz "${two[@]:1}" --output-directory none

end_of_checks
