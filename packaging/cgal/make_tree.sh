#!/usr/bin/env bash
# Lays the package into a CGAL tree, as CGAL's git repository has packages: a folder for each.
#
#   packaging/cgal/make_tree.sh FOLDER_OF_CGAL [GENERATED]
#
# A clone of CGAL gets, beside the folder L0_resampling, what other folders have of a package: the
# header of the license, the lines of the lists of packages and of named parameters, the entry in
# CHANGES.md, the data of the examples and the plugin of CGAL Lab. In an empty folder these stand
# alone. GENERATED is doc/L0_resampling/generated of a build folder whose target doc was built: the
# figures and tables that the manual quotes, with those of options, which lie elsewhere there.
set -euo pipefail
source_directory=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [ $# -lt 1 ] || [ $# -gt 2 ] || [ ! -d "$1" ] || [ ! -d "${2:-.}" ]; then
  sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
cgal=$(cd "$1" && pwd)
generated=""
if [ $# -eq 2 ]; then generated=$(cd "$2" && pwd); fi
package=$cgal/L0_resampling
title="L0 Resampling of Point Sets"
cd "$source_directory"

# The release that the tree will be, which is the first one with the package
changes=$cgal/Installation/CHANGES.md
release=""
if [ -f "$changes" ]; then
  release=$(sed -nE '0,/^## \[Release /s/^## \[Release ([0-9.]+)\].*/\1/p' "$changes")
fi

data=$cgal/Data/data/points_3/L0_resampling
rm -rf "$package" "$cgal/Lab/demo/Lab/Plugins/L0_resampling" "$data"
mkdir -p "$package"/{doc,examples,test}/L0_resampling "$cgal/Installation/include/CGAL/license" \
         "$cgal/Lab/demo/Lab/Plugins" "$data"

# Headers and what is said of the package
cp -r include package_info "$package"
packaging/cgal/headers.py for_cgal "$package/include"
mv "$package/include/CGAL/license/L0_resampling.h" "$cgal/Installation/include/CGAL/license"
rmdir "$package/include/CGAL/license"
# CGAL has no CUDA, and compiles each header of `include` alone, which ends these with #error. The
# manual, which tells of them, reads what lies beside it; not in a folder CGAL there, or it would
# read that in place of `include`.
device_headers=doc/L0_resampling/device/CGAL/L0_resampling
mkdir -p "$package/$device_headers"
mv "$package"/include/CGAL/L0_resampling/CUDA_*.h "$package/$device_headers"
cp data/*.ply data/*.off "$data"

# CGAL makes members of one class, and free functions, of the names in its own list. That is made
# anew, so that it has no name twice. What the package does for want of that is left out, but for
# the operator that its tests join chains by.
names=$cgal/STL_Extension/include/CGAL/STL_Extension/internal/parameters_interface.h
if [ -f "$names" ]; then
  heading="// List of named parameters used in the package '$title'"
  own=$package/include/CGAL/L0_resampling/named_parameters
  {
    sed -zE "s,\n$heading\n((CGAL_add| )[^\n]*\n)*,," "$names"
    printf '\n%s\n' "$heading"
    sed -n '/^CGAL_add/,$p' "${own}_interface.h"
  } > "$names.new"
  mv "$names.new" "$names"
  rm "${own}_interface.h"
  {
    sed '/^#include <CGAL\/Named_function_parameters.h>$/q' "$own.h"
    cat << 'END'

namespace CGAL {

/// Adds the one named parameter `np` to the end of `chain`.
template <typename T, typename Tag, typename Base, typename K, typename X>
Named_function_parameters<K, X, Named_function_parameters<T, Tag, Base>> operator|(
  const Named_function_parameters<T, Tag, Base>& chain, const Named_function_parameters<K, X>& np)
{
  return Named_function_parameters<K, X, Named_function_parameters<T, Tag, Base>>(np.v, chain);
}

} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_NAMED_PARAMETERS_H
END
  } > "$own.h.new"
  mv "$own.h.new" "$own.h"
  sed -i -zE 's/Those that CGAL lacks start [^\n]*(\n`[^`|]*) \| parameters::/Dots join them:\1./' \
      "$package/include/CGAL/l0_resample_point_set.h"
fi

# What a CMakeLists.txt has: cmake_of KIND SOURCE...
cmake_of() {
  local kind=$1 source
  shift
  cat << END
# Written by packaging/cgal/make_tree.sh of the project that this package comes from.
cmake_minimum_required(VERSION 3.12...3.31)
project(L0_resampling_$kind)

find_package(CGAL REQUIRED)
find_package(Eigen3 QUIET)
include(CGAL_Eigen3_support)
if(NOT TARGET CGAL::Eigen3_support)
  message(STATUS "NOTICE: $title needs Eigen 3.3.7 or later, so nothing is compiled here.")
  return()
endif()
find_package(TBB QUIET)
include(CGAL_TBB_support)
set(l0_libraries CGAL::Eigen3_support)
if(TARGET CGAL::TBB_support)
  list(APPEND l0_libraries CGAL::TBB_support)
endif()
include_directories(\${CMAKE_CURRENT_SOURCE_DIR})
add_definitions(-DL0_TEST_DATA="\${CGAL_DATA_DIR}/points_3/L0_resampling")

END
  printf 'create_single_source_cgal_program("%s")\n' "$@"
  for source in "$@"; do
    printf 'target_link_libraries(%s PRIVATE ${l0_libraries})\n' "$(basename "$source" .cpp)"
  done
}

# Examples: those that need neither a device nor the library of the project
cp examples/L0_resampling/*_example.cpp "$package/examples/L0_resampling"
rm "$package/examples/L0_resampling/l0_resample_cuda_example.cpp"
sed -i -E 's|L0_EXAMPLE_DATA "/([^"]*)"|CGAL::data_file_path("points_3/L0_resampling/\1")|' \
    "$package"/examples/L0_resampling/*.cpp
if [ -f "$names" ]; then   # chains as they are written in CGAL
  sed -i -zE 's/\s*\| (CGAL::)?parameters::/./g; s/ behind a bar\././g' \
      "$package"/examples/L0_resampling/*.cpp
fi
(cd "$package/examples/L0_resampling" && cmake_of Examples *.cpp > CMakeLists.txt)
# The recipes are of scans that no tree has, so they are compiled only.
sed -i '/program("recipes_example.cpp")/{
  i set_directory_properties(PROPERTIES CGAL_NO_TESTING TRUE)
  a set_directory_properties(PROPERTIES CGAL_NO_TESTING FALSE)
}' "$package/examples/L0_resampling/CMakeLists.txt"

# Tests of stages and of calls, which are one source file each
mapfile -t tests < <(sed -nE 's/^add_l0_(stage|call)_test\(([a-z_0-9/]+)\)$/\2.cpp/p' \
                         test/L0_resampling/CMakeLists.txt)
[ ${#tests[@]} -gt 0 ] || { echo "make_tree.sh: no test was found" >&2; exit 1; }
mapfile -t folders < <(dirname "${tests[@]}" | sort -u)
(
  shopt -s nullglob
  cd test/L0_resampling
  cp --parents "${tests[@]}" ./*.h "$package/test/L0_resampling"
  for folder in "${folders[@]}"; do
    for header in "$folder"/*.h; do cp --parents "$header" "$package/test/L0_resampling"; done
  done
)
cmake_of Tests "${tests[@]}" > "$package/test/L0_resampling/CMakeLists.txt"

# The manual
manual=$package/doc/L0_resampling
cp -r doc/L0_resampling/{*.txt,*.bib,Concepts,fig,dependencies} "$manual"
# The page on named parameters is that of the package BGL.
rm "$manual"/{CMakeLists,Named_parameters}.txt
echo BGL >> "$manual/dependencies"
sed -i -f - "$manual/PackageDescription.txt" << 'END'
s/\\cgalPkgDependsOn{.*}/\\cgalPkgDependsOn{\\ref PkgPropertyMap and \\ref thirdpartyEigen}/
s/\\cgalPkgLicense{.*}/\\cgalPkgLicense{\\ref licensesGPL "GPL"}/
s/\\cgalPkgShortInfoEnd/\\cgalPkgDemo{CGAL Lab,CGALlab.zip}\n&/
END
if [ -n "$release" ]; then
  sed -i "s/cgalPkgSince{.*}/cgalPkgSince{$release}/" "$manual/PackageDescription.txt"
fi
# Examples that the manual quotes, and that CGAL does not build
mkdir -p "$manual/quoted/L0_resampling"
cp examples/L0_resampling/{*.py,*.sh,l0_resample_cuda_example.cpp} "$manual/quoted/L0_resampling"
chmod -x "$manual"/quoted/L0_resampling/*
(cd test && cp --parents L0_resampling/packages/consumer/CMakeLists.txt "$manual/quoted")
if [ -n "$generated" ]; then
  cp -r "$generated" "$manual/generated"
  cp "$generated"/../../../share/l0_resample/table_of_*_options.txt "$manual/generated"
fi
{
  # The names of aliases that CGAL has not
  cat << END
@INCLUDE = \${CGAL_DOC_PACKAGE_DEFAULTS}

PROJECT_NAME = "CGAL \${CGAL_DOC_VERSION} - $title"

EXTRACT_ALL        = NO
HIDE_UNDOC_MEMBERS = YES
HIDE_UNDOC_CLASSES = YES
EXCLUDE_SYMBOLS   += *internal*
EXCLUDE_PATTERNS  += */L0_resampling/internal/*
PREDEFINED        += CGAL_L0_LINKED_WITH_CUDA
HTML_EXTRA_FILES   = \${CGAL_PACKAGE_DOC_DIR}/fig
@INCLUDE_PATH      = \${CGAL_PACKAGE_DOC_DIR}/generated
EXAMPLE_PATH      += \${CGAL_PACKAGE_DOC_DIR}/quoted \${CGAL_PACKAGE_DOC_DIR}/generated
STRIP_FROM_INC_PATH += \${CGAL_PACKAGE_DOC_DIR}/device
CITE_BIB_FILES    += \${CGAL_PACKAGE_DOC_DIR}/L0_resampling.bib
ALIASES           += "l0Version=$(scripts/project_version.sh)"
END
  grep '^ALIASES += "l0' doc/L0_resampling/aliases
  if [ -n "$generated" ]; then
    echo '@INCLUDE           = figures_of_the_code'
    echo 'FORMULA_MACROFILE  = ${CGAL_PACKAGE_DOC_DIR}/generated/formula_macros.tex'
  fi
} > "$manual/Doxyfile.in"

# The plugin of CGAL Lab, which has the package beside it here
cp -r demo/L0_resampling "$cgal/Lab/demo/Lab/Plugins"
cat > "$cgal/Lab/demo/Lab/Plugins/L0_resampling/CMakeLists.txt" << END
include(CGALlab_macros)

if(TARGET CGAL::Eigen3_support)
  qt6_wrap_ui(l0_resamplingUI_FILES L0_resampling_plugin.ui)
  cgal_lab_plugin(l0_resampling_plugin L0_resampling_plugin \${l0_resamplingUI_FILES}
                  KEYWORDS PointSetProcessing)
  target_link_libraries(l0_resampling_plugin PRIVATE scene_points_with_normal_item
                                                     CGAL::Eigen3_support)
  if(TARGET CGAL::TBB_support)
    target_link_libraries(l0_resampling_plugin PRIVATE CGAL::TBB_support)
  endif()
else()
  message(STATUS "NOTICE: Eigen was not found. The plugin of $title will not be available.")
endif()
END

# What a clone of CGAL has in lists
list=$cgal/Installation/include/CGAL/license/gpl_package_list.txt
if [ -f "$list" ] && ! grep -q '^L0_resampling ' "$list"; then
  LC_ALL=C awk -v line="L0_resampling $title" '
    !done && $1 > "L0_resampling" { print line; done = 1 } { print }
    END { if (!done) print line }' "$list" > "$list.new"
  mv "$list.new" "$list"
fi
if [ -f "$changes" ] && ! grep -q 'L0 Resampling' "$changes"; then
  entry=$(sed "s/@CGAL_VERSION@/$release/g" packaging/cgal/CHANGES.md)
  # Before the first package of the newest release
  awk -v entry="$entry" '!done && /^### \[/ { print entry "\n"; done = 1 } { print }' "$changes" \
    > "$changes.new"
  mv "$changes.new" "$changes"
fi
packages=$cgal/Documentation/doc/Documentation/packages.txt
if [ -f "$packages" ] && ! grep -q 'package_listing{L0_resampling}' "$packages"; then
  sed -i '/package_listing{Point_set_processing_3}/i \\\\package_listing{L0_resampling}' "$packages"
fi
examples=("$package"/examples/L0_resampling/*.cpp)
echo "L0_resampling: ${#tests[@]} tests, ${#examples[@]} examples"
