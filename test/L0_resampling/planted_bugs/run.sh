#!/usr/bin/env bash
# Plants each bug of this folder, one at a time, in a temporary copy of the tree and runs the test that has to catch it.
#
#   run.sh [--json FILE] [NAME...]     all patches, or NAME.patch only; the verdicts go into FILE as they come, with the commit whose code it was,
#                                      beside those of other patches that it has
#
# A patch is a unified diff (-p1). Its first line names the test, a program and its arguments, or test_tool_cli: "# caught by: test_x". A test counts only if it passes without the bug;
# one that does not end within TIME_LIMIT seconds (default 600) has caught a hang. FLAGS="-O1 -DNDEBUG" compiles faster than the default. Ends with 0 if every bug was caught.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
results=
if [[ ${1:-} == --json ]]; then
  results=$(realpath "$2")
  shift 2
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

commit=$(git -C "$root" rev-parse --short HEAD 2> /dev/null || echo unknown)
mkdir "$scratch/tree"
tar -C "$root" --exclude=./.git --exclude='./build*' -cf - . | tar -C "$scratch/tree" -xf -
launcher=()
if command -v ccache > /dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  export CCACHE_BASEDIR=$scratch CCACHE_NOHASHDIR=1   # what one run compiles serves the next
fi
cmake -S "$scratch/tree" -B "$scratch/build" -DCMAKE_BUILD_TYPE=Release -DCGAL_L0_BUILD_EXAMPLES=OFF \
      -DCGAL_L0_BUILD_BENCHMARKS=OFF -DCGAL_L0_WITH_PYTHON=OFF -DCGAL_L0_WITH_DOCUMENTATION=OFF -DCGAL_L0_WITH_CUDA=OFF \
      -DCMAKE_CXX_FLAGS_RELEASE="${FLAGS:--O3 -DNDEBUG}" "${launcher[@]}" > "$scratch/log"

# Both take the program and its arguments as one word.
build()
{
  local target=${1%% *}
  [[ $target != test_tool_cli ]] || target=l0_resample   # a script runs it
  cmake --build "$scratch/build" --target "$target"
} > "$scratch/log" 2>&1
runs()
{
  local words
  read -ra words <<< "$scratch/build/bin/$1"
  [[ $1 != test_tool_cli ]] || words=(bash "$scratch/tree/test/L0_resampling/test_tool_cli.sh" "$scratch/build/bin/l0_resample")
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
  if [[ -n $results ]]; then
    python3 - "$results" "$(basename "$patch" .patch)" "$(cat "$scratch/verdict")" "$commit" << 'END'
import json, pathlib, sys
path, bug, verdict, commit = pathlib.Path(sys.argv[1]), *sys.argv[2:]
verdicts = json.loads(path.read_text()) if path.exists() else {}
verdicts[bug] = {"verdict": verdict, "code": commit}
path.write_text(json.dumps(verdicts, indent=1, sort_keys=True) + "\n")
END
  fi
done
echo "${#patches[@]} planted, $missed not caught"
(( missed == 0 ))
