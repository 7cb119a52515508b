# Run by cpack once all files of the Debian package are laid out: Debian has one folder of Python
# packages for all versions of Python, below /usr alone, where a build has that of its own version.
# Both are as deep, so that the module finds its library.
file(GLOB folders ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/lib/python3.*/dist-packages)
foreach(folder IN LISTS folders)
  cmake_path(GET folder PARENT_PATH parent)
  file(MAKE_DIRECTORY ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/lib/python3)
  file(RENAME ${folder} ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/lib/python3/dist-packages)
  file(REMOVE_RECURSE ${parent})
endforeach()
