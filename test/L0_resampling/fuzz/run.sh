#!/usr/bin/env bash
# Attacks one reader with libFuzzer, under AddressSanitizer and UndefinedBehaviorSanitizer.
#
#   run.sh [--keep] CORPUS [EXECUTIONS]
#
# CORPUS is csv, las, npy, obj, off, pcd, ply_ascii, ply_binary or xyz; there are 100000 executions
# if no number is given. With --keep, the files that reached new paths are packed into the corpus,
# and the number of executions is noted in executions.csv.
#
# Needs clang with its run-time library for fuzzing (Debian: clang, libclang-rt-dev) and Eigen. Ends
# with 0 if no file was found that breaks a reader; such a file is left in the folder that is named.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tool=$(cd "$here/../../../src/l0_resample" && pwd)
keep=OFF
if [ "$1" = --keep ]; then keep=ON; shift; fi
corpus=$1 executions=${2:-100000}
format=${corpus%_*}
scratch=$(cd "$here/../../.." && pwd)/build-fuzz
program=$scratch/fuzz_readers
mkdir -p "$scratch/$corpus"

include=$(cd "$here/../../../include" && pwd)
is_new() { [ -e "$program" ] && [ -z "$(find "$@" -newer "$program" -type f -print -quit)" ]; }
if ! is_new "$tool" "$include" "$here"; then
  flags=(-std=c++17 -O2 -g1 -D_GLIBCXX_SANITIZE_VECTOR
         -fsanitize=address,undefined,float-cast-overflow -fno-sanitize=vptr
         -fno-sanitize-recover=all
         -DL0_RESAMPLE_VERSION='"fuzzed"' -I "$tool" -I "$include" $(pkg-config --cflags eigen3))
  cd "$scratch"
  rm -rf objects readers.a   # or the linker takes what a source of another name was compiled to
  mkdir objects
  printf '%s\n' "$tool"/{basis,files,formats}/*.cpp "$tool"/system/*_posix.cpp |
    (cd objects; xargs -P "$(nproc)" -n 1 clang++ "${flags[@]}" -fsanitize=fuzzer-no-link -c)
  # The linker takes from an archive what the readers need.
  ar rcs readers.a objects/*.o
  clang++ "${flags[@]}" -fsanitize=fuzzer "$here/fuzz_readers.cpp" readers.a -lz -o "$program"
fi

[ ! -f "$here/corpora/$corpus.tar.gz" ] || tar -C "$scratch" -xzf "$here/corpora/$corpus.tar.gz"
awk -v format="$format" '/^#/ { wanted = $1 == "#=" && ($0 " ") ~ (" " format " "); next } wanted' \
  "$here/dictionary.txt" > "$scratch/$format.dict"
# short stacks and no quarantine, as allocations are what most of the time would go to; leaks are
# looked for when all is replayed
ASAN_OPTIONS=malloc_context_size=0:quarantine_size_mb=1 \
  "$program" "$scratch/$corpus" --format="$format" \
  -dict="$scratch/$format.dict" -max_len=1024 -detect_leaks=0 -runs="$executions" \
  -artifact_prefix="$scratch/" -print_final_stats=1 \
  2>&1 | tee "$scratch/$corpus.log"

[ $keep = ON ] || exit 0
mkdir -p "$scratch/merged/$corpus" "$here/corpora"
"$program" -merge=1 --format="$format" -max_len=1024 "$scratch/merged/$corpus" \
  "$scratch/$corpus"
tar -C "$scratch/merged" --sort=name --owner=0 --group=0 --mtime=@0 -c "$corpus" | gzip -n9 \
  > "$here/corpora/$corpus.tar.gz"

executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$scratch/$corpus.log")
kept=$(find "$scratch/merged/$corpus" -type f | wc -l)
{ grep -v "^$corpus," "$here/executions.csv"; echo "$corpus,$executions,0,$kept"; } \
  > "$scratch/executions.csv"
{ head -n 1 "$scratch/executions.csv"; tail -n +2 "$scratch/executions.csv" | sort; } \
  > "$here/executions.csv"
