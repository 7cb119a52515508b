#!/usr/bin/env bash
# Copies the licenses of libraries that are packed with the tool or the Python package:
#
#   scripts/library_licenses.sh FOLDER LIBRARY...
#
# On Debian these are the file `copyright` of each package, and the texts of common licenses that it
# names. For libraries of no package, CGAL_L0_LICENSES names a folder with their texts, as libtbb for
# libtbb.so.12. Fails where the license of a library is not known.
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

mkdir -p "$folder"
for library in "$@"; do
  name=${library##*/}
  text=${CGAL_L0_LICENSES:-}/${name%%.so*}
  package=$(package_of "$library")
  if [ -f "$text" ]; then
    install -m 644 "$text" "$folder"
  elif [ -n "$package" ] && [ -f "/usr/share/doc/$package/copyright" ]; then
    install -m 644 "/usr/share/doc/$package/copyright" "$folder/$package"
    common=/usr/share/common-licenses/
    for name in $(grep -oE "${common}[A-Za-z]+(-[0-9.]*[0-9])?" "$folder/$package" | sort -u); do
      install -m 644 "$name" "$folder"
    done
  else
    echo "library_licenses.sh: the license of $library is not known" >&2
    exit 1
  fi
done
