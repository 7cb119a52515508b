#!/usr/bin/env bash
# What conda runs in the source tree, in an environment with PREFIX, PYTHON and its CMAKE_ARGS
set -euo pipefail
# shellcheck disable=SC2086  # several arguments
cmake -G Ninja -S . -B build ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_INSTALL_PREFIX="$PREFIX" -DCMAKE_INSTALL_LIBDIR=lib -DPython_EXECUTABLE="$PYTHON" \
  -DCGAL_L0_BUILD_BENCHMARKS=OFF -DCGAL_L0_BUILD_EXAMPLES=OFF -DCGAL_L0_BUILD_TESTS=OFF \
  -DCGAL_L0_BUILD_TOOL=ON -DCGAL_L0_WITH_CUDA=OFF -DCGAL_L0_WITH_DOCUMENTATION=OFF \
  -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF -DCGAL_L0_WITH_PYTHON=ON
cmake --build build
cmake --install build
