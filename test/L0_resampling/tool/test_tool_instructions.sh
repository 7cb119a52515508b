#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Program and Python package load the library that is compiled for this processor, and those for
# older ones where the loader is told that this is one.
# usage: test_tool_instructions.sh PROGRAM LIBRARY [MODULE PYTHON]

library=$(realpath "$2") module=${3:+$(realpath "$3")} python=${4:-}
# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"
name=$(basename "$library")
folder_of_libraries=$(dirname "$library")
loader=$(ldd "$program" | sed -nE 's,^\s*(/[^ ]*) \(0x.*,\1,p')

library_for()   # instructions; that one, or the one for less if this processor has not got them
{
  local level
  for level in "$@"; do
    if "$loader" --help | grep -q "$level (supported, searched)"; then
      echo "$folder_of_libraries/glibc-hwcaps/$level/$name"
      return
    fi
  done
  echo "$library"
}
best=$(library_for x86-64-v4 x86-64-v3)
without_avx512=(env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F)
without_avx2=(env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2)

loaded()   # a command; prints which of the libraries it has loaded, and leaves its output
{
  rm -f loaded.*
  LD_DEBUG=libs LD_DEBUG_OUTPUT=loaded "$@" > stdout 2> stderr < /dev/null || return
  sed -n "s,.*calling init: \(.*/$name\)\$,\1,p" loaded.* | xargs -r realpath
}

run_cube=("$program" cube.xyz --points 500 --force)
check "the program loads the best library" \
  test "$(loaded "${run_cube[@]}" best.xyz)" = "$best"
check "and another one without AVX-512" \
  test "$(loaded "${without_avx512[@]}" "${run_cube[@]}" avx2.xyz)" = "$(library_for x86-64-v3)"
check "and the one for all processors without AVX2" \
  test "$(loaded "${without_avx2[@]}" "${run_cube[@]}" plain.xyz)" = "$library"
check "and where the loader is told not to look" \
  test "$(loaded "$loader" --glibc-hwcaps-mask none "${run_cube[@]}" masked.xyz)" = "$library"
for points in best avx2 plain masked; do
  check "as many points as asked for, all finite" \
    test "$(awk 'NF == 6 && !/n/' $points.xyz | wc -l)" = 500
done
check "one library gives one result" cmp plain.xyz masked.xyz

if [ -n "$module" ]; then
  cat > use.py << 'END'
import cgal_l0, numpy
positions, normals = cgal_l0.l0_resample_point_set(numpy.loadtxt("cube.xyz"),
                                                   number_of_output_points=500)
assert len(positions) == 500 and numpy.isfinite(positions).all() and numpy.isfinite(normals).all()
END
  PYTHONPATH=$(dirname "$(dirname "$module")")
  export PYTHONPATH
  check "the Python package loads the best library" \
    test "$(loaded "$python" -B use.py)" = "$best"
  check "and the one for all processors without AVX2" \
    test "$(loaded "${without_avx2[@]}" "$python" -B use.py)" = "$library"
fi

# A program must not have a function that the library calls by its name: it could have other
# instructions. The watcher of loops is one of both sides and does not compute.
names_in()   # a file, and options of nm
{
  nm --defined-only "${@:2}" "$1" | awk '{ print $3 }' | grep -v 12loop_watcherI | sort -u
}
for other in "$folder_of_libraries"/glibc-hwcaps/*/"$name"; do
  check "libraries have the same interface" cmp <(names_in "$library" -D) <(names_in "$other" -D)
done
check "the library has an interface" test "$(names_in "$library" -D | wc -l)" -gt 10
for user in "$program" $module; do
  check "$user has nothing of it" \
    test -z "$(comm -12 <(names_in "$library" -D) <(names_in "$user"))"
done

# Tiles of one run have the roundings of one library.
if [ "$best" != "$library" ]; then
  as_one=(cube.xyz --as-one --points 500 --memory 1GB --output-directory tiles)
  run_plainly "${as_one[@]}" --task begin
  check "a run begins" test "$status" -eq 0
  printf '#!/bin/sh\nexec %s %s "$@"\n' "${without_avx2[*]}" "$program" > older
  chmod 755 older
  program=$folder/older
  check_plain_failure 2 ", FMA, now it is instructions plain" \
    "${as_one[@]}" --resume
fi
end_of_checks
