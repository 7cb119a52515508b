#!/usr/bin/env bash
# The package as a folder of CGAL's repository: one test and one example of it are built there and
# run, as CGAL does it, with the CGAL that is installed.
#
#   test_cgal_tree.sh SOURCE_DIRECTORY SCRATCH GENERATOR CGAL_DIR
set -euo pipefail
source_directory=$1 scratch=$2 generator=$3 cgal_dir=$4

rm -rf "$scratch"
mkdir -p "$scratch"/tree/Installation/include/CGAL/license \
         "$scratch"/tree/Documentation/doc/Documentation
cd "$scratch/tree"
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
done
[ "$(cut -d' ' -f1 "$list" | xargs)" = "Jet_fitting_3 L0_resampling Mesh_2" ] \
  || fail "the list of packages is wrong"
[ "$(grep -n L0_resampling Documentation/doc/Documentation/packages.txt)" = \
  '2:\package_listing{L0_resampling}' ] || fail "the manual's list of packages is wrong"
[ "$(grep -c 'new package' Installation/CHANGES.md)" -eq 1 ] || fail "not one entry in CHANGES.md"
[ "$(grep '^##' Installation/CHANGES.md | sed -E 's/.*\[([^]]*)\].*/\1/' | xargs)" = \
  "Release 7.8 ### General Changes L0 Resampling of Point Sets 3D Things Release 7.7" ] \
  || fail "the entry stands at another place of CHANGES.md"
grep -q 'doc.cgal.org/7.8/' Installation/CHANGES.md || fail "the entry is of another release"

# What CGAL's own script asks of a branch
grep -qE 'L0_resampling_Tests\s*\)' L0_resampling/test/L0_resampling/CMakeLists.txt \
  || fail "the tests are another project"
grep -qE 'L0_resampling_Examples\s*\)' L0_resampling/examples/L0_resampling/CMakeLists.txt \
  || fail "the examples are another project"
without=$(grep -rlE '^#define CGAL_\w+_H$' L0_resampling/include | xargs grep -L '<CGAL/license/')
[ -z "$without" ] || fail "without the license: $without"
foreign=$(grep -rL 'This file is part of CGAL' --include=*.h L0_resampling/include Installation)
[ -z "$foreign" ] || fail "not part of CGAL: $foreign"
grep -rn 'L0_EXAMPLE_DATA' L0_resampling/examples \
  && fail "an example names data as the project does"

# As CGAL's tests are: in the folder of the package, without NDEBUG
cd L0_resampling
includes="-I$PWD/include -I$PWD/../Installation/include"
for folder in test:test_weights examples:l0_resample_example; do
  program=${folder#*:} folder=${folder%:*}
  # Releases before 6.0 have another name for the switch of the tests.
  cmake -G "$generator" -S "$folder/L0_resampling" -B "$scratch/$folder" \
        -DCMAKE_CXX_FLAGS="-O1 $includes" -DCGAL_DIR="$cgal_dir" \
        -DCGAL_DATA_DIR="$PWD/../Data/data" -DBUILD_TESTING=ON -DCGAL_ENABLE_TESTING=ON
  cmake --build "$scratch/$folder" --target "$program"
  ctest --test-dir "$scratch/$folder" -R "^execution___of__$program\$" --no-tests=error \
        --output-on-failure
done
[ "$failures" -eq 0 ]
