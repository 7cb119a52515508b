#!/usr/bin/env bash
# Compiles the package by clang with libc++, the standard library of other systems, and compares its
# results with those of this compiler and library, to the last bit.
#   test_libcxx.sh SOURCE SCRATCH EIGEN PROGRAM
# EIGEN is the folder of Eigen's headers, PROGRAM interface/compiled_library.cpp as it was built
# here. Debian's packages of libc++ take those of Ceres away, so they are only unpacked, in SCRATCH.
# Ends with status 77 where they cannot be had.
set -euo pipefail
source=$1 scratch=$2 eigen=$3 program=$4
version=14

if ! command -v "clang++-$version" > /dev/null; then
  echo "clang++-$version is not there, so nothing was compiled with libc++."
  exit 77
fi
mkdir -p "$scratch/packages"
cd "$scratch"
if [ ! -e complete ]; then
  if ! (cd packages && apt-get download -qq libc++{,abi}{-$version-dev,1-$version} \
                                          libunwind-$version); then
    echo "The packages of libc++ cannot be had, so nothing was compiled with it."
    exit 77
  fi
  for package in packages/*.deb; do
    dpkg -x "$package" root
  done
  touch complete
fi

# Without TBB: it is compiled with the library of this system.
llvm=root/usr/lib/llvm-$version
"clang++-$version" -std=c++17 -O1 -frounding-math -ffp-contract=off -DCGAL_EIGEN3_ENABLED \
  -nostdinc++ -isystem "$llvm/include/c++/v1" -I "$source/include" -isystem "$eigen" \
  "$source/test/L0_resampling/interface/compiled_library.cpp" -o program \
  -nostdlib++ "$llvm"/lib/lib{c++,c++abi,unwind}.so.1 -Wl,-rpath,"$PWD/$llvm/lib" -lgmp -lmpfr
data=$source/data/bracket_noisy.ply
./program "$data" > with_libcxx.txt
"$program" "$data" > expected.txt
[ -s expected.txt ]
cmp expected.txt with_libcxx.txt
