#!/usr/bin/env bash
# Installs what is missing, builds for any processor of this architecture, and makes a Debian
# package, which lintian looks at. Says at the end where it is.
#   package.sh [programs]     `programs` installs nothing and builds alone, for scripts/tag_release.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ "$*" = "" ] || [ "$*" = programs ] || { echo "usage: scripts/package.sh [programs]" >&2; exit 2; }

if [ $# -eq 0 ]; then
  scripts/install_dependencies.sh user dpkg-dev file doxygen texlive-binaries libjs-mathjax lintian
fi
cmake -S . -B build-package -DCMAKE_BUILD_TYPE=Release -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF -DPython_EXECUTABLE=/usr/bin/python3 \
      -DCGAL_L0_BUILD_TESTS=OFF -DCGAL_L0_BUILD_EXAMPLES=OFF -DCGAL_L0_BUILD_BENCHMARKS=OFF -DCGAL_L0_WITH_DOCUMENTATION=ON
cmake --build build-package -j "$(nproc)"
[ $# -eq 0 ] || exit 0
cmake --build build-package --target doc
cpack --config build-package/CPackConfig.cmake -B build-package
lintian --allow-root --fail-on error,warning build-package/cgal-l0-resampling_*.deb

cat <<END

To install it with what it needs:  sudo apt install ./build-package/cgal-l0-resampling_*.deb
END
