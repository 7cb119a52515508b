#!/usr/bin/env bash
# Installs what is missing, and makes the manual. Says at the end where it is.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_dependencies.sh user doxygen texlive-binaries libjs-mathjax
# Configured anew, as there is no target doc in a build folder that was configured without Doxygen
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DCGAL_L0_WITH_DOCUMENTATION=ON \
      -DPython_EXECUTABLE=/usr/bin/python3
cmake --build build -j "$(nproc)" --target doc
echo "build/doc/L0_resampling/html/index.html"
