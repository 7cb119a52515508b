#!/usr/bin/env bash
# Tests all that there is, in hours, before an issue is resolved: test_all.sh [PART]...
#   tests         all tests of CTest
#   clang         the tests of scripts/test.sh, compiled by clang++
#   sanitizers    scripts/test_sanitized.sh
#   package       the Debian package, from nothing; and where CGAL_L0_CGAL_TREE names a folder with
#                 CGAL's sources, all tests and examples and the plugin of the Lab in a copy of it
#   run           scripts/run.sh
#   benchmarks    benchmark/run.sh, and whether `pip install .` takes at most four minutes on two cores
#   attacks       all pairs of hostile points and parameters, and 20000 random ones
#   fuzz          200000 damaged files for each reader of the tool
#   planted_bugs  all planted bugs
# All parts are run if none is named. A part that fails does not keep the next one from running; the
# last lines name those that did.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

all_parts=(tests clang sanitizers package run benchmarks attacks fuzz planted_bugs)
parts=("$@")
[ $# -gt 0 ] || parts=("${all_parts[@]}")

test_tests() { scripts/test.sh full; }

test_clang() {
  cmake -G Ninja -S . -B build-clang -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=clang++ \
        -DCGAL_L0_TEST_TIER=user -DCGAL_L0_TESTS_IN_BATCHES=ON -DCGAL_L0_WITH_CUDA=OFF \
        -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF \
        -DPython_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3
  cmake --build build-clang -j "$(nproc)"
  ctest --test-dir build-clang --output-on-failure --label-exclude sources -j "$(nproc)"
}

test_sanitizers() { scripts/test_sanitized.sh; }

test_package() {
  rm -rf build-package
  scripts/package.sh
  if [ -n "${CGAL_L0_CGAL_TREE:-}" ]; then
    test/L0_resampling/packages/test_cgal_tree.sh . build-package/cgal_tree Ninja \
      "$CGAL_L0_CGAL_TREE" all
  else
    echo "CGAL_L0_CGAL_TREE is not set, so the package was not built in a tree of CGAL."
  fi
}

test_run() { scripts/run.sh; }

test_benchmarks() {
  benchmark/run.sh
  taskset -c 0,1 /usr/bin/python3 -B benchmark/L0_resampling/performance/run_install.py \
    --at-most 240
}

# Seeds that the ctest of no other commit has had
test_attacks() {
  cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DPython_EXECUTABLE=/usr/bin/python3
  cmake --build build -j "$(nproc)" --target attack
  build/bin/attack named
  build/bin/attack random 20000 --seed "$((16#$(git rev-parse --short=7 HEAD)))"
}

test_fuzz() {
  local corpus
  for corpus in test/L0_resampling/fuzz/corpora/*.tar.gz; do
    test/L0_resampling/fuzz/run.sh "$(basename "$corpus" .tar.gz)" 200000
  done
}

test_planted_bugs() {
  test/L0_resampling/planted_bugs/planted_bugs.py run \
    --cmake=-DPython_EXECUTABLE=/usr/bin/python3 --cmake=-DPython3_EXECUTABLE=/usr/bin/python3
}

for part in "${parts[@]}"; do
  case " ${all_parts[*]} " in
    *" $part "*) ;;
    *) echo "usage: scripts/test_all.sh [${all_parts[*]}]..." >&2; exit 2 ;;
  esac
done
scripts/install_dependencies.sh full
failed=()
for part in "${parts[@]}"; do
  echo "=== $part"
  # In a shell of its own: where a condition calls a function, set -e does not stop it.
  bash -euo pipefail -c "$(declare -f "test_$part"); test_$part" || failed+=("$part")
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "Failed: ${failed[*]}" >&2
  exit 1
fi
echo "Passed: ${parts[*]}"
