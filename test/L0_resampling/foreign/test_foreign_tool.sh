#!/usr/bin/env bash
# Compiles the tool for another system and runs there: the tests of its readers and writers,
# conversions between all formats, whose files have to be those that the tool of this system writes,
# and a resampling.
#   test_foreign_tool.sh SOURCE SCRATCH SYSTEM TOOL_OF_THIS_SYSTEM
# Ends with status 77 where compiler, emulator or sources of libraries are not there.
set -euo pipefail
source=$1 scratch=$2 system=$3 tool=$4

skip() { echo "$1, so the tool was not compiled for $system."; exit 77; }
case $system in
  s390x-*) emulator=(qemu-s390x) compiler=$system-g++-12 ;;
  i686-*) emulator=(qemu-i386) compiler=$system-g++-12 ;;
  *mingw*) emulator=(wine) compiler=$system-g++-posix ;;
  *) echo "unknown system: $system" >&2; exit 1 ;;
esac
for program in "$compiler" "${emulator[0]}"; do
  command -v "$program" > /dev/null || skip "$program is not there"
done

mkdir -p "$scratch"
status=0
"$source/scripts/foreign_libraries.sh" "$system" "$scratch/libraries" || status=$?
[ $status -ne 77 ] || skip "The sources of its libraries cannot be had"
[ $status -eq 0 ]

# What runs for seconds need not be optimized; for Windows, without it, a file of objects has more
# bytes of names than the assembler can count.
optimization=-O0
[[ $system != *mingw* ]] || optimization=-O1
cmake -G Ninja -S "$source/test/L0_resampling/foreign" -B "$scratch/build" -DL0_SOURCE="$source" \
      -DCMAKE_TOOLCHAIN_FILE="$source/cmake/foreign_system.cmake" -DL0_SYSTEM="$system" \
      -DL0_PREFIX="$scratch/libraries" -DCMAKE_BUILD_TYPE=Release \
      "-DCMAKE_CXX_FLAGS_RELEASE=$optimization -DNDEBUG"
cmake --build "$scratch/build" --target tests tests_with_allocations l0_resample
export WINEDEBUG=-all WINEPREFIX=$scratch/wine
ctest --test-dir "$scratch/build" --output-on-failure --no-tests=error

built=("$scratch"/build/l0_resampling/src/l0_resample/l0_resample*)
foreign_tool=("${emulator[@]}" "${built[0]}")
rm -rf "$scratch/files"
mkdir -p "$scratch/files/here" "$scratch/files/there"
cd "$scratch/files"
export SOURCE_DATE_EPOCH=0   # the day of creation in LAS
python3 -B "$source/test/L0_resampling/foreign/write_all_types.py" begin.ply

# From each format to each: both tools write the same bytes, and read what the other one has
# written.
formats=(ply pcd las npy xyz off)
# convert FOLDER TOOL...
convert() {
  local folder=$1 from to
  shift
  for to in "${formats[@]}"; do
    "$@" --convert-only --quiet begin.ply "$folder/begin-$to.$to"
  done
  for from in "${formats[@]}"; do
    for to in "${formats[@]}"; do
      "$@" --convert-only --quiet "here/begin-$from.$from" "$folder/$from-$to.$to"
    done
  done
}
convert here "$tool"
convert there "${foreign_tool[@]}"
diff -r here there

# On Windows, what begins with a slash is an option.
cp "$source/data/bracket_noisy.ply" .
"${foreign_tool[@]}" bracket_noisy.ply resampled.ply --points 500 --threads 2
"$tool" --info resampled.ply | grep -q 500
