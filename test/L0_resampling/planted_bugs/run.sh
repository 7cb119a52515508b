#!/usr/bin/env bash
# Plants each bug of this folder, one at a time, in a temporary copy of the tree and runs the test that has to catch it.
#
#   run.sh [NAME...]     all patches, or NAME.patch only
#
# A patch is a unified diff (-p1). Its first line names the test, a program and its arguments: "# caught by: test_x". A test counts only if it passes without the bug;
# one that does not end within TIME_LIMIT seconds (default 600) has caught a hang. Ends with 0 if every bug was caught.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

mkdir "$scratch/tree"
tar -C "$root" --exclude=./.git --exclude='./build*' -cf - . | tar -C "$scratch/tree" -xf -
launcher=()
if command -v ccache > /dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
cmake -S "$scratch/tree" -B "$scratch/build" -DCMAKE_BUILD_TYPE=Release -DCGAL_L0_BUILD_TOOL=OFF -DCGAL_L0_BUILD_EXAMPLES=OFF \
      -DCGAL_L0_BUILD_BENCHMARKS=OFF "${launcher[@]}" > "$scratch/log"

# Both take the program and its arguments as one word.
build() { cmake --build "$scratch/build" --target "${1%% *}"; } > "$scratch/log" 2>&1
runs()
{
  local words
  read -ra words <<< "$scratch/build/bin/$1"
  timeout "${TIME_LIMIT:-600}" "${words[@]}"
} > "$scratch/log" 2>&1

# Whether the test passes on the tree as it is, asked once a test.
declare -A sound
is_sound()
{
  if [[ -z ${sound[$1]:-} ]]; then
    if build "$1" && runs "$1"; then sound[$1]=yes; else sound[$1]=no; fi
  fi
  [[ ${sound[$1]} == yes ]]
}

# Prints what came of one patch.
verdict()
{
  local patch=$1 test status=0
  test=$(sed -n '1s/^# caught by: //p' "$patch")
  if [[ -z $test ]]; then echo "names no test"; return; fi
  if ! is_sound "$test"; then echo "cannot be judged: $test fails without it"; return; fi
  if ! patch -d "$scratch/tree" -p1 --dry-run -s -f < "$patch" > "$scratch/log" 2>&1; then echo "does not apply"; return; fi
  patch -d "$scratch/tree" -p1 -s --no-backup-if-mismatch < "$patch"
  if build "$test"; then
    runs "$test" || status=$?
    case $status in
      0) echo "NOT CAUGHT by $test" ;;
      124) echo "caught by $test: it does not end" ;;
      *) echo "caught by $test: $( (grep -m 1 -o 'failed: .*' "$scratch/log" || echo "status $status") | cut -c 1-90)" ;;
    esac
  else
    echo "does not build"
  fi
  patch -d "$scratch/tree" -p1 -s -R --no-backup-if-mismatch < "$patch"
}

patches=("$here"/*.patch)
if (( $# > 0 )); then
  patches=("${@/%/.patch}")
  patches=("${patches[@]/#/$here/}")
fi
missed=0
for patch in "${patches[@]}"; do
  verdict "$patch" > "$scratch/verdict"   # not in a subshell, which would forget what is sound
  echo "$(basename "$patch" .patch): $(cat "$scratch/verdict")"
  if ! grep -q '^caught' "$scratch/verdict"; then
    missed=$((missed + 1))
  fi
done
echo "${#patches[@]} planted, $missed not caught"
(( missed == 0 ))
