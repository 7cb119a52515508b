# Which headers of others are compiled into the tool and the Python module: the path of one header
# of each library, in headers_of_others.txt of the build folder. What packs these programs for other
# machines takes their licenses by it, see scripts/library_licenses.sh.
#
# TBB is not among them, as its license goes with the library that is loaded. Nor is Boost, whose
# license asks for nothing where there is no source.
set(l0_names CGAL/version.h Eigen/Core CLI/CLI.hpp nlohmann/json.hpp)
if(TARGET cgal_l0)
  list(APPEND l0_names pybind11/pybind11.h)
endif()
set(l0_headers "")
foreach(name IN LISTS l0_names)
  find_file(l0_header ${name} NO_CACHE
            HINTS ${CGAL_INCLUDE_DIRS} ${EIGEN3_INCLUDE_DIR} ${pybind11_INCLUDE_DIR})
  if(l0_header)
    list(APPEND l0_headers ${l0_header})
  else()
    list(APPEND l0_headers ${name})   # where its license may be named
  endif()
  unset(l0_header)
endforeach()
list(JOIN l0_headers "\n" l0_lines)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers_of_others.txt CONTENT "${l0_lines}\n")
