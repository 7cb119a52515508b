#!/usr/bin/env bash
# Installs what is missing, builds all that users rely on, and runs its tests. Ends with ctest's
# summary.
#   test.sh [core|user|full]     `core` and `full` serve scripts/test_core.sh and scripts/test_all.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tier=${1:-user} folder=build parts=ON
case $tier in
  core) folder=build-core parts=OFF ;;
  user | full) ;;
  *) echo "usage: scripts/test.sh [core|user|full]" >&2; exit 2 ;;
esac
scripts/install_dependencies.sh "$tier"
# For any processor of the architecture, as packages are.
# Device code for one architecture: that of the device, or any where there is none.
architecture=90
if nvidia-smi -L 2> /dev/null | grep -q GPU; then architecture=native; fi
# A folder that make builds in stays as it is.
generator=(-G Ninja)
if [ -f $folder/CMakeCache.txt ]; then generator=(); fi
# The Python whose packages were installed, whatever other one may come first in the path
cmake "${generator[@]}" -S . -B $folder -DCMAKE_BUILD_TYPE=Release \
      -DCGAL_L0_BUILD_TESTS=ON -DCGAL_L0_TEST_TIER="$tier" -DCGAL_L0_TESTS_IN_BATCHES=ON \
      -DCGAL_L0_BUILD_TOOL=$parts -DCGAL_L0_WITH_PYTHON=$parts -DCGAL_L0_BUILD_EXAMPLES=$parts \
      -DCGAL_L0_BUILD_BENCHMARKS=$parts -DCGAL_L0_WITH_DOCUMENTATION=$parts \
      -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF -DCMAKE_CUDA_ARCHITECTURES="$architecture" \
      -DPython_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3
cmake --build $folder -j "$(nproc)"
ctest --test-dir $folder --output-on-failure --no-tests=error -j "$(nproc)"
