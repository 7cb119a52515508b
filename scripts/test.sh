#!/usr/bin/env bash
# Installs what is missing, builds everything and runs the tests. Ends with ctest's summary.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_dependencies.sh clang-format valgrind python3-matplotlib python3-scipy python3-jinja2 \
                                libjs-three chromium chromium-driver python3-selenium python3-yaml \
                                ninja-build
# For any processor of the architecture, as packages are, so that the library is compiled once. Device code for one architecture:
# that of the device, or any where there is none.
architecture=90
if nvidia-smi -L 2> /dev/null | grep -q GPU; then architecture=native; fi
# A folder that make builds in stays as it is.
generator=(-G Ninja)
if [ -f build/CMakeCache.txt ]; then generator=(); fi
# The Python whose packages were installed, whatever other one may come first in the path
cmake "${generator[@]}" -S . -B build -DCMAKE_BUILD_TYPE=Release \
      -DCGAL_L0_BUILD_TESTS=ON -DCGAL_L0_BUILD_EXAMPLES=ON -DCGAL_L0_BUILD_BENCHMARKS=ON \
      -DCGAL_L0_TESTS_IN_BATCHES=ON -DCGAL_L0_WITH_PYTHON=ON \
      -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF -DCMAKE_CUDA_ARCHITECTURES="$architecture" \
      -DPython_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3
cmake --build build -j "$(nproc)"
ctest --test-dir build --output-on-failure --no-tests=error -j "$(nproc)"
