#!/usr/bin/env bash
# Shows what clang-format would write otherwise of the lines that were changed since a commit, for a person to take over what is better so,
# and fails if clang-tidy has something to say about the changed files:
#   scripts/check_style.sh [COMMIT]     the commit is where this branch left main, unless another one is given
#   scripts/check_style.sh --all        clang-tidy about all files, which takes an hour or two; no clang-format
# Debian: clang-format clang-tidy
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

sources=('include/*.h' 'src/*.h' 'src/*.cpp' 'test/*.h' 'test/*.cpp' 'benchmark/*.h' 'benchmark/*.cpp' 'examples/*.cpp' 'data/*.cpp' 'doc/*.cpp')
status=0
if [ "${1:-}" = --all ]; then
  mapfile -t files < <(git ls-files "${sources[@]}")
else
  base=${1:-$(git merge-base main HEAD)}
  mapfile -t files < <(git diff --name-only --diff-filter=d "$base" -- "${sources[@]}")
  if [ ${#files[@]} -gt 0 ]; then
    git clang-format --diff "$base" -- "${files[@]}" || true   # some versions end with 1 where there is a difference
  fi
fi

# One file looks at all headers of the package, and those of the tool and the tests are looked at with what includes them.
units=()
for file in "${files[@]}"; do
  case $file in
    include/*) units+=(test/L0_resampling/everything_compiles.cpp) ;;
    *.cpp) units+=("$file") ;;
  esac
done
[ ${#units[@]} -gt 0 ] || exit "$status"
mapfile -t units < <(printf '%s\n' "${units[@]}" | sort -u)

cmake -S . -B build-style -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCGAL_L0_WITH_CUDA=OFF -DPython_EXECUTABLE=/usr/bin/python3 > /dev/null
for unit in "${units[@]}"; do
  clang-tidy -p build-style --quiet --warnings-as-errors='*' --extra-arg=-DCGAL_L0_LINKED_WITH_CUDA "$unit" || status=1
done
exit "$status"
