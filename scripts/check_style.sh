#!/usr/bin/env bash
# Fails if clang-format 14 would write a file otherwise, if a line is too long, or if clang-tidy has something to say about what was changed:
#   scripts/check_style.sh [COMMIT]     clang-tidy about the files that differ from where this branch left main, or from COMMIT
#   scripts/check_style.sh --all        clang-tidy about all files, which takes an hour or two
#   scripts/check_style.sh --format     clang-format and lengths of lines only
# `git ls-files '*.h' '*.cpp' '*.cu' '*.cuh' | xargs clang-format -i` formats all files.
# Debian: clang clang-format clang-tidy
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

status=0
formatted=('*.h' '*.cpp' '*.cu' '*.cuh')
git ls-files -z "${formatted[@]}" | xargs -0 "${CLANG_FORMAT:-clang-format}" --dry-run --Werror || status=1
# clang-format leaves comments alone
long_lines=$(git grep -nE '^.{101,}$' -- '*.h' '*.cpp' '*.cu' '*.cuh' 'src/*.py' 'test/*.py' 'test/*.sh' \
                      'doc/*.txt' 'doc/*.bib' 'doc/*.py' 'doc/*.css' || true)
if [ -n "$long_lines" ]; then
  echo "lines of more than 100 columns:" >&2
  echo "$long_lines" >&2
  status=1
fi
[ "${1:-}" != --format ] || exit "$status"

sources=('include/*.h' 'src/*.h' 'src/*.cpp' 'test/*.h' 'test/*.cpp' 'benchmark/*.h' 'benchmark/*.cpp' 'examples/*.cpp' 'data/*.cpp' 'doc/*.cpp')
if [ "${1:-}" = --all ]; then
  mapfile -t files < <(git ls-files "${sources[@]}")
else
  base=${1:-$(git merge-base main HEAD)}
  mapfile -t files < <(git diff --name-only --diff-filter=d "$base" -- "${sources[@]}")
fi

# One file looks at all headers of the package, and those of the tool and the tests are looked at with what includes them.
units=()
for file in "${files[@]}"; do
  case $file in
    include/*) units+=(test/L0_resampling/house/everything_compiles.cpp) ;;
    *.cpp) units+=("$file") ;;
  esac
done
[ ${#units[@]} -gt 0 ] || exit "$status"
mapfile -t units < <(printf '%s\n' "${units[@]}" | sort -u)

# With the commands of g++ clang-tidy would take its own standard, C++14, and not know all options.
cmake -S . -B build-style -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCGAL_L0_WITH_CUDA=OFF -DPython_EXECUTABLE=/usr/bin/python3 > /dev/null
arguments=(-p build-style --quiet --warnings-as-errors='*' --extra-arg=-DCGAL_L0_LINKED_WITH_CUDA)
compiler=$(readlink -f "$(command -v nvcc)" || true)
[ -z "$compiler" ] || arguments+=(--extra-arg="-isystem$(dirname "$(dirname "$compiler")")/include")
for unit in "${units[@]}"; do
  if [ -z "$compiler" ] && grep -q '#include <cuda_' "$unit"; then
    echo "$unit: not looked at, it needs the headers of CUDA" >&2
    continue
  fi
  clang-tidy "${arguments[@]}" "$unit" || status=1
done
exit "$status"
