#!/usr/bin/env bash
# Copies the licenses of libraries that are packed with the tool or the Python package, or of which
# headers are compiled into them:
#
#   scripts/library_licenses.sh FOLDER LIBRARY_OR_HEADER...
#
# On Debian these are the file `copyright` of each package, and the texts of common licenses that it
# names. For what is of no package, CGAL_L0_LICENSES names a folder with the texts: libtbb for
# libtbb.so.12, Eigen for a header in a folder of that name. Headers of a source tree have their
# license at its top. Fails where a license is not known.
set -euo pipefail
if [ $# -lt 2 ]; then
  sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
folder=$1
shift

package_of() {
  local path
  # Since /lib is a link to /usr/lib, a package knows one of the two names.
  for path in "$1" "/usr$1" "${1#/usr}"; do
    if dpkg-query -S "$path" 2> /dev/null | sed 's/:.*//'; then return; fi
  done
}

# Those beside the folder of a header, as Eigen has them, and one level above, as CGAL
texts_of_tree() {
  if [[ $1 == *.so* ]] || [ ! -f "$1" ]; then return; fi
  local beside=${1%/*/*}
  find "$beside" "${beside%/*}" -maxdepth 1 -type f \( -name 'LICENSE*' -o -name 'COPYING*' \) | sort
}

mkdir -p "$folder"
for library in "$@"; do
  if [[ $library == *.so* ]]; then
    name=${library##*/}
    name=${name%%.so*}
  else
    name=$(basename "${library%/*}")
  fi
  text=${CGAL_L0_LICENSES:-}/$name
  package=$(package_of "$library")
  texts=$(texts_of_tree "$library")
  if [ -f "$text" ]; then
    install -m 644 "$text" "$folder"
  elif [ -n "$package" ] && [ -f "/usr/share/doc/$package/copyright" ]; then
    install -m 644 "/usr/share/doc/$package/copyright" "$folder/$package"
    common=/usr/share/common-licenses/
    for text in $(grep -oE "${common}[A-Za-z]+(-[0-9.]*[0-9])?" "$folder/$package" | sort -u); do
      install -m 644 "$text" "$folder"
    done
  elif [ -n "$texts" ]; then
    xargs -d '\n' cat <<< "$texts" > "$folder/$name"
  else
    echo "library_licenses.sh: the license of $library is not known" >&2
    exit 1
  fi
done
