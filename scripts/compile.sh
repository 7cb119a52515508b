#!/usr/bin/env bash
# Compiles the library and the examples, without tool and tests, and runs one example: what is
# expected of a system where scripts/test.sh, which is for Debian, cannot install anything.
#
#   scripts/compile.sh BUILD_FOLDER [OPTION_OF_CMAKE...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:?usage: scripts/compile.sh BUILD_FOLDER [OPTION_OF_CMAKE...]}
shift

cmake -G Ninja -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DCGAL_L0_BUILD_TOOL=OFF \
      -DCGAL_L0_BUILD_TESTS=OFF -DCGAL_L0_BUILD_BENCHMARKS=OFF -DCGAL_L0_WITH_PYTHON=OFF \
      -DCGAL_L0_WITH_DOCUMENTATION=OFF -DCGAL_L0_WITH_CUDA=OFF \
      -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF -DCGAL_L0_BUILD_EXAMPLES=ON "$@"
cmake --build "$build"
"$build/bin/l0_resample_example" data/bracket_noisy.ply "$build/bracket_resampled.ply"
