#!/usr/bin/env bash
# Installs from Debian 12 what the machine lacks:
#   scripts/install_dependencies.sh [core|user|full] [PACKAGE...]
# `core` is what the package and its tests need, `user`, which is taken if none is named, what tool
# and Python package need too, and `full` what scripts/test_all.sh needs; then packages by name.
set -euo pipefail

tier=user
case ${1:-} in core | user | full) tier=$1; shift ;; esac
packages=(g++ cmake make ninja-build git python3 libcgal-dev libeigen3-dev libtbb-dev libboost-dev
          libgmp-dev libmpfr-dev libceres-dev)
if [ "$tier" != core ]; then
  packages+=(libcli11-dev nlohmann-json3-dev libpng-dev zlib1g-dev)
  packages+=(pybind11-dev python3-dev python3-numpy python3-pytest mypy)   # for the Python package
  packages+=(python3-pip python3-setuptools python3-wheel)                 # for its wheel
  packages+=(python3-distributed python3-mpi4py openmpi-bin)   # for workers of other engines
  packages+=(clang-format)
fi
if [ "$tier" = full ]; then
  packages+=(dpkg-dev file lintian pandoc)                     # for the packages and the paper
  packages+=(python3-yaml python3-jsonschema)                  # for the workflows
  packages+=(doxygen texlive-binaries libjs-mathjax)           # for the manual
  packages+=(python3-matplotlib python3-scipy python3-jinja2)   # for the benchmarks
  packages+=(chromium chromium-driver python3-selenium)        # to look at pages
  packages+=(valgrind clang libclang-rt-dev g++-11)
  # For other processors and systems, whose libraries are compiled from Debian's sources
  packages+=(g++-12-i686-linux-gnu g++-s390x-linux-gnu g++-mingw-w64-x86-64-posix
             libz-mingw-w64-dev qemu-user wine)
fi
packages+=("$@")
missing=()
for package in "${packages[@]}"; do
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
echo "Installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}"
