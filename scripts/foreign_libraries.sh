#!/usr/bin/env bash
# Makes what the tool needs for another system, in a folder for cmake/foreign_system.cmake:
#   scripts/foreign_libraries.sh SYSTEM FOLDER
# SYSTEM is what the names of Debian's cross compilers begin with: s390x-linux-gnu, i686-linux-gnu
# or x86_64-w64-mingw32. TBB, libpng and zlib are compiled from Debian's sources, which apt-get brings.
# Headers that are the same everywhere, of CGAL, Boost, Eigen, CLI11 and JSON, are those of this
# system. A folder that is complete stays as it is. Ends with status 77 where there are no sources.
set -euo pipefail
usage="usage: scripts/foreign_libraries.sh SYSTEM FOLDER"
system=${1:?$usage} folder=${2:?$usage}
toolchain=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/cmake/foreign_system.cmake
sources=(onetbb libpng1.6)
case $system in
  *mingw*) ;;   # Debian has zlib for it: libz-mingw-w64-dev
  *) sources+=(zlib) ;;
esac

mkdir -p "$folder"
cd "$folder"
folder=$PWD
[ ! -e complete ] || exit 0

# Sources, with a list of their own, so that apt's is as it was
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
repository=$(apt-get indextargets --format '$(REPO_URI)' 'Component: main' "Codename: $release" \
             | head -n 1)
if [ -z "$repository" ]; then
  echo "There are no packages of Debian."
  exit 77
fi
mkdir -p sources lists/partial include lib/cmake share/cmake
cat > debian.sources <<END
Types: deb-src
URIs: $repository
Suites: $release
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
END
apt_options=(-qq -o Dir::Etc::SourceList="$folder/debian.sources" -o Dir::Etc::SourceParts=-
             -o Dir::State::Lists="$folder/lists" -o Dir::Cache="$folder"
             -o APT::Sandbox::User=root)
if ! apt-get "${apt_options[@]}" update \
   || ! (cd sources && apt-get "${apt_options[@]}" source --download-only "${sources[@]}"); then
  echo "Sources of ${sources[*]} cannot be had."
  exit 77
fi
for description in sources/*.dsc; do
  name=$(basename "$description")
  rm -rf "sources/${name%%_*}"
  dpkg-source --no-check -x "$description" "sources/${name%%_*}" > /dev/null
done

for name in CGAL boost CLI nlohmann eigen3; do
  ln -sfn "/usr/include/$name" "include/$name"
done
cp -rL /usr/lib/"$(gcc -print-multiarch)"/cmake/CGAL lib/cmake
cp -rL /usr/share/cmake/CLI11 /usr/share/cmake/nlohmann_json share/cmake
cp -rL /usr/share/eigen3 share

# install_library NAME OPTION_OF_CMAKE...
install_library() {
  local name=$1
  shift
  cmake -G Ninja -S "sources/$name" -B "build/$name" -DCMAKE_TOOLCHAIN_FILE="$toolchain" \
        -DL0_SYSTEM="$system" -DL0_PREFIX="$folder" -DCMAKE_INSTALL_PREFIX="$folder" \
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DBUILD_SHARED_LIBS=OFF "$@"
  cmake --build "build/$name" --target install
}
if [ -d sources/zlib ]; then   # Debian's sources lack a file that its CMakeLists.txt names
  (cd sources/zlib
   CC=$(command -v "$system-gcc-12") AR=$system-ar RANLIB=$system-ranlib \
     ./configure --static --prefix="$folder"
   make install)
fi
install_library libpng1.6 -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_EXECUTABLES=OFF
install_library onetbb -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF
rm -rf build sources lists
touch complete
