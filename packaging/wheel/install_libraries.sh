#!/usr/bin/env bash
# Installs what the wheel is built with in an image of manylinux, as [tool.cibuildwheel] in
# pyproject.toml asks for: libraries of the image's distribution, and others from their releases to
# /usr/local, since the distribution has none or older ones.
set -euo pipefail

dnf -y install boost-devel gmp-devel libpng-devel mpfr-devel zlib-devel
licenses=/usr/local/share/licenses
install -D -m 644 /usr/share/licenses/libpng/LICENSE "$licenses/libpng16"

folder=$(mktemp -d)
cd "$folder"
# install_release NAME ADDRESS OPTION_OF_CMAKE...      NAME as scripts/library_licenses.sh asks for
install_release() {
  local name=$1 archive=${2##*/}
  curl -fsSL "$2" -o "$archive"
  shift 2
  mkdir source
  tar -xf "$archive" -C source --strip-components=1
  cmake -S source -B build -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr/local \
        -DCMAKE_INSTALL_LIBDIR=lib "$@"
  cmake --build build --parallel "$(nproc)"
  cmake --install build
  find source -maxdepth 1 -type f \( -name 'LICENSE*' -o -name 'COPYING*' \) -exec cat {} + \
    > "$licenses/$name"
  rm -r source build
}
github=https://github.com
install_release CGAL \
  $github/CGAL/cgal/releases/download/v5.6.2/CGAL-5.6.2-library.tar.xz
install_release Eigen https://gitlab.com/libeigen/eigen/-/archive/3.4.0/eigen-3.4.0.tar.gz \
  -DBUILD_TESTING=OFF -DEIGEN_BUILD_DOC=OFF
install_release CLI $github/CLIUtils/CLI11/archive/v2.3.2.tar.gz \
  -DCLI11_BUILD_TESTS=OFF -DCLI11_BUILD_EXAMPLES=OFF
install_release nlohmann $github/nlohmann/json/archive/v3.11.3.tar.gz \
  -DJSON_BuildTests=OFF
install_release pybind11 $github/pybind/pybind11/archive/v2.13.6.tar.gz \
  -DPYBIND11_TEST=OFF
install_release libtbb $github/uxlfoundation/oneTBB/archive/v2021.13.0.tar.gz \
  -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF
echo /usr/local/lib > /etc/ld.so.conf.d/usr_local.conf
ldconfig
