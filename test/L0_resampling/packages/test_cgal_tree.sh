#!/usr/bin/env bash
# The package as a folder of CGAL's repository: one test and one example of it are built there and
# run, as CGAL does it.
#
#   test_cgal_tree.sh SOURCE_DIRECTORY SCRATCH GENERATOR CGAL_DIR [all]
#
# CGAL_DIR is that of an installed CGAL, or a folder with CGAL's sources, a clone of its repository
# or a release. Sources are copied, so that the package lies in a whole tree of CGAL. `all` builds
# and runs all tests and examples, and builds the plugin in the Lab of that tree.
set -euo pipefail
[ $# -eq 4 ] || [ "$#/${5:-}" = 5/all ] || { sed -n '5p' "$0" >&2; exit 2; }
source_directory=$(cd "$1" && pwd) generator=$3 cgal_dir=$4 programs=${5:-}
rm -rf "$2"
mkdir -p "$2"/{lists,tree}
scratch=$(cd "$2" && pwd)
if [ -d "$cgal_dir" ]; then cgal_dir=$(cd "$cgal_dir" && pwd); fi

mkdir -p "$scratch"/lists/Installation/include/CGAL/license \
         "$scratch"/lists/Documentation/doc/Documentation \
         "$scratch"/lists/STL_Extension/include/CGAL/STL_Extension/internal
cd "$scratch/lists"
failures=0
fail() {
  echo "$*" >&2
  failures=$((failures + 1))
}

# The lists of a clone
list=Installation/include/CGAL/license/gpl_package_list.txt
printf 'Jet_fitting_3 Jets\nMesh_2 Meshes\n' > "$list"
printf '\\package_listing{Point_set_3}\n\\package_listing{Point_set_processing_3}\n' \
  > Documentation/doc/Documentation/packages.txt
names=CGAL/STL_Extension/internal/parameters_interface.h
printf '// List of Jets\nCGAL_add_named_parameter(jet_t, jet, jet)\n' \
  > "STL_Extension/include/$names"
cat > Installation/CHANGES.md << 'END'
# Release History

## [Release 7.8](https://example.org)

### General Changes

- Something.

### [3D Things](https://example.org)

- More.

## [Release 7.7](https://example.org)
END
for _ in 1 2; do   # what is there already is written anew, and no list grows
  "$source_directory/packaging/cgal/make_tree.sh" .
  # Another package may have come behind it.
  printf '\n// List of Kernels\nCGAL_add_named_parameter(k_t, k, k)\n' \
    >> "STL_Extension/include/$names"
done
[ "$(sed -nE 's/^.*\((jet|normal_weight|k)_t.*/\1/p; s,^//.* ,,p' \
        "STL_Extension/include/$names" | xargs -d '\n')" \
  = "Jets jet Kernels k Sets' normal_weight Kernels k" ] \
  || fail "the list of named parameters is wrong"
[ "$(cut -d' ' -f1 "$list" | xargs)" = "Jet_fitting_3 L0_resampling Mesh_2" ] \
  || fail "the list of packages is wrong"
[ "$(xargs -d '\n' < Documentation/doc/Documentation/packages.txt)" = \
  "\\package_listing{Point_set_3} \\package_listing{L0_resampling} \
\\package_listing{Point_set_processing_3}" ] || fail "the manual's list of packages is wrong"
[ "$(grep -c 'new package' Installation/CHANGES.md)" -eq 1 ] || fail "not one entry in CHANGES.md"
[ "$(grep '^##' Installation/CHANGES.md | sed -E 's/.*\[([^]]*)\].*/\1/' | xargs)" = \
  "Release 7.8 ### General Changes L0 Resampling of Point Sets 3D Things Release 7.7" ] \
  || fail "the entry stands at another place of CHANGES.md"
grep -q 'doc.cgal.org/7.8/' Installation/CHANGES.md || fail "the entry is of another release"
grep -qF '\cgalPkgSince{7.8}' L0_resampling/doc/L0_resampling/PackageDescription.txt \
  || fail "the manual says another release"
manual=L0_resampling/doc/L0_resampling
[ ! -e "$manual/CGAL" ] || fail "CGAL's manual would not read the headers of include"
bibliography=$(sed -n 's,^CITE_BIB_FILES *+= ${CGAL_PACKAGE_DOC_DIR}/,,p' "$manual/Doxyfile.in")
[ -f "$manual/$bibliography" ] || fail "the manual does not find the publications that it cites"
grep -rnE '(page|defgroup|anchor|section) bgl_namedparameters' "$manual" \
  && fail "the page on named parameters is that of BGL"
grep -qx BGL "$manual/dependencies" || fail "the manual does not find the page on named parameters"
grep -rnE '`\|`|behind a bar' L0_resampling/{include,examples} "$manual"/*.txt \
  && fail "chains are taught as they are outside of CGAL"
grep -qF '`parameters::neighbor_radius(0.1).normal_weight(0.5)`' \
     L0_resampling/include/CGAL/l0_resample_point_set.h || fail "chains are not taught"
# What pages quote and refer to is in the tree, or in packages of CGAL that `dependencies` names.
for file in $(grep -ohP '\\(include|snippet)(\{\w+\})? +\KL0_resampling/\S+' "$manual"/*.txt); do
  [ -f "L0_resampling/examples/$file" ] || [ -f "$manual/quoted/$file" ] \
    || fail "the manual does not find $file"
done
words() { # words COMMAND: of this command of Doxygen, wherever it stands
  grep -rohP --include=*.txt --include=*.h "\\\\$1 +\K\w+\b(?!::)" "$manual" L0_resampling/include
}
places() {
  words '(page|(sub)*section|anchor|defgroup)'
  printf '%s\n' bgl_namedparameters licensesGPL thirdpartyEigen PkgPropertyMap
}
nowhere=$(comm -23 <(words '(ref|subpage)' | sort -u) <(places | sort -u))
[ -z "$nowhere" ] || fail "the manual refers to these, which are nowhere: $nowhere"
find "$manual" -type f -perm /111 | grep . && fail "text can be run"
find L0_resampling/examples -type f -not -name '*.cpp' -not -name CMakeLists.txt | grep . \
  && fail "there are examples that CGAL does not build"

# The tree
cd "$scratch/tree"
folders=()
options=()
if [ -f "$cgal_dir/include/CGAL/version.h" ] && [ -d "$cgal_dir/demo" ]; then
  # A release has the files of all packages in the same folders.
  mkdir -p Lab Data GraphicsView STL_Extension
  cp -r "$cgal_dir" Installation
  mkdir -p Installation/package_info/Installation   # CGAL knows its repository by this folder
  mv Installation/demo Lab
  mv Installation/data Data
  ln -s ../Installation/include GraphicsView
  ln -s ../Installation/include STL_Extension
  cgal_dir=$PWD/Installation/lib/cmake/CGAL
elif [ -f "$cgal_dir/Installation/include/CGAL/version.h" ]; then
  tar -C "$cgal_dir" --exclude=./.git -c . | tar -x
  cgal_dir=$PWD/Installation/lib/cmake/CGAL
else
  for folder in L0_resampling Installation STL_Extension; do
    folders+=("-I$PWD/$folder/include")
  done
  options=(-DCGAL_DATA_DIR="$PWD/Data/data")
fi

# Where the headers are that a program may include beside those of the package
options+=(-G "$generator" -DCGAL_DIR="$cgal_dir")
mkdir "$scratch/folders"
cat > "$scratch/folders/CMakeLists.txt" << 'END'
cmake_minimum_required(VERSION 3.12...3.31)
project(folders CXX)
find_package(CGAL REQUIRED)
find_package(Eigen3 REQUIRED)
include(CGAL_Eigen3_support)
set(property INTERFACE_INCLUDE_DIRECTORIES)
set(of_eigen $<TARGET_PROPERTY:CGAL::Eigen3_support,${property}>)
file(GENERATE OUTPUT list CONTENT "$<JOIN:${CGAL_INCLUDE_DIRS};${of_eigen},\n>\n")
END
cmake "${options[@]}" -S "$scratch/folders" -B "$scratch/folders"
mapfile -t searched < <(sed '/^$/d' "$scratch/folders/list" | awk '!seen[$0]++')
if [ ${#folders[@]} -gt 0 ]; then   # nothing is written into an installed CGAL
  for folder in "${searched[@]}"; do
    if [ -f "$folder/$names" ]; then
      install -D -m 644 "$folder/$names" "STL_Extension/include/$names"
    fi
  done
fi
"$source_directory/packaging/cgal/make_tree.sh" .

# What CGAL's own script asks of a branch
grep -qE 'L0_resampling_Tests\s*\)' L0_resampling/test/L0_resampling/CMakeLists.txt \
  || fail "the tests are another project"
grep -qE 'L0_resampling_Examples\s*\)' L0_resampling/examples/L0_resampling/CMakeLists.txt \
  || fail "the examples are another project"
without=$(grep -rlE '^#define CGAL_\w+_H$' L0_resampling/include | xargs grep -L '<CGAL/license/')
[ -z "$without" ] || fail "without the license: $without"
foreign=$(grep -rL 'This file is part of CGAL' --include=*.h L0_resampling/include \
                   Installation/include/CGAL/license/L0_resampling.h)
[ -z "$foreign" ] || fail "not part of CGAL: $foreign"
grep -rn 'L0_EXAMPLE_DATA' L0_resampling/examples \
  && fail "an example names data as the project does"
grep -rnE '[ ,(]std::(numeric_limits<[^>]*>::)?(max|min)\(' L0_resampling/{test,examples} \
  && fail "min and max are macros on Windows"

compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$scratch/folders/CMakeCache.txt")
if [ ${#folders[@]} -eq 0 ]; then   # cgal_package_info asks it of an installed CGAL
  python3 -B "$source_directory/test/L0_resampling/packages/test_package_info.py" \
          "$PWD/L0_resampling" "$compiler" "${searched[@]}" \
    || fail "what CGAL is told of the package is not true of this tree"
fi

# Public headers alone, as CGAL compiles those of its manual; the others too where all is built. One
# that includes the one before it has its verdict from the same source file.
command=("$compiler" -std=c++17 -fsyntax-only -DCGAL_EIGEN3_ENABLED -IL0_resampling/include
         "${folders[@]}" "${searched[@]/#/-I}")
mkdir "$scratch/headers"
(cd L0_resampling/include && find CGAL -name '*.h') \
  | { if [ -n "$programs" ]; then cat; else grep -v /internal/; fi; } > "$scratch/headers/names"
xargs python3 -B "$source_directory/test/L0_resampling/house/header_chains.py" \
      L0_resampling/include "" < "$scratch/headers/names" > "$scratch/headers/chains"
while read -r _ chain; do
  printf '#include <%s>\n' $chain > "$scratch/headers/$(tr / _ <<< "${chain##* }").cpp"
done < "$scratch/headers/chains"
find "$scratch/headers" -name '*.cpp' -print0 | xargs -0 -n 1 -P "$(nproc)" "${command[@]}" \
  || fail "there is a header that does not compile alone"

# The named parameters are CGAL's own, in chains of either order.
cat > "$scratch/chains.cpp" << 'END'
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

int main()
{
  namespace parameters = CGAL::parameters;
  using Kernel = CGAL::Simple_cartesian<double>;
  const auto chain = parameters::neighbor_radius(.1).normal_weight(.5);
  static_assert(
    std::is_same_v<decltype(chain),
                   const CGAL::Named_function_parameters<
                     double, CGAL::internal_np::normal_weight_t,
                     decltype(parameters::neighbor_radius(.1))>>);
  const std::vector<Kernel::Point_3> points;
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;
  const auto out = std::back_inserter(result);
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(points, out, chain);
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(
    points, out, parameters::normal_weight(.5).neighbor_radius(.1).keep_density(true));
}
END
"${command[@]}" "$scratch/chains.cpp" || fail "CGAL has no named parameters of the package"

# As CGAL's tests are: in the folder of the package, without NDEBUG, with warnings of headers too
options+=(-DCMAKE_CXX_FLAGS="-O1 -Wall -Wextra ${folders[*]}")
build() { # build FOLDER TARGET...
  local folder=$1
  shift
  cmake --build "$scratch/$folder" --parallel "$(nproc)" --target "$@" 2>&1 \
    | tee "$scratch/$folder.log"
  ! grep -E 'tree/(L0|Lab/demo/Lab/Plugins/L0)_resampling/.*warning:' "$scratch/$folder.log" \
    || fail "warnings of $folder"
}
for folder in test:test_weights examples:l0_resample_example; do
  program=${folder#*:} folder=${folder%:*}
  # Releases before 6.0 have another name for the switch of the tests.
  cmake "${options[@]}" -S "L0_resampling/$folder/L0_resampling" -B "$scratch/$folder" \
        -DBUILD_TESTING=ON -DCGAL_ENABLE_TESTING=ON -DCGAL_TEST_SUITE=ON
  if [ -n "$programs" ]; then
    build "$folder" all
    program='.*'
  else
    build "$folder" "$program"
  fi
  ctest --test-dir "$scratch/$folder" -R "^execution[_ ]+of[_ ]+$program\$" --no-tests=error \
        --output-on-failure --parallel "$(nproc)"
done

# The plugin among those of the Lab, where Qt 6 is there
if [ -n "$programs" ] && [ -f Lab/demo/Lab/CMakeLists.txt ]; then
  cmake "${options[@]}" -S Lab/demo/Lab -B "$scratch/lab"
  if cmake --build "$scratch/lab" --target help | grep l0_resampling_plugin; then
    build lab l0_resampling_plugin
  fi
fi
[ "$failures" -eq 0 ]
