# Makes the Debian package of the build in BUILD_DIRECTORY, as it was built, looks into it, installs
# it below a folder of its own and runs what it brings:
#   cmake -DBUILD_DIRECTORY=... -DSCRATCH=... -DCPACK=... -DVERSION=... -DDATA=... -DGENERATOR=...
#         -DCGAL_DIR=... -DMANUAL=<its sources> -DMANUAL_PAGES=<its pages, if they were built>
#         [-DPYTHON=...] [-DLIBRARY_OF_PROGRAMS=<its name>] [-DLINTIAN=...]
#         -P test_package.cmake

cmake_minimum_required(VERSION 3.21)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status
                  OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN} ended with status ${status}:\n${output}\n${errors}")
  endif()
  set(output ${output} PARENT_SCOPE)
endfunction()

function(expect what text regular_expression)
  if(NOT text MATCHES "${regular_expression}")
    message(SEND_ERROR "${what} does not match ${regular_expression}:\n${text}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
# Ninja builds nothing before an install, where make would build all that is not up to date.
run(${CPACK} -G DEB --config ${BUILD_DIRECTORY}/CPackConfig.cmake -B ${SCRATCH}
    -D CPACK_CMAKE_GENERATOR=Ninja)
file(GLOB packages ${SCRATCH}/*.deb)
list(LENGTH packages number_of_packages)
if(NOT number_of_packages EQUAL 1)
  message(FATAL_ERROR "${number_of_packages} packages: ${packages}")
endif()

# What Debian's own program says
if(LINTIAN)
  run(${LINTIAN} --allow-root --fail-on error,warning ${packages})
endif()

# What it says
cmake_path(GET packages FILENAME name)
string(REPLACE . \\. version ${VERSION})
string(REPLACE + \\+ version ${version})
expect("The file name" ${name} "^cgal-l0-resampling_${version}_[a-z0-9]+\\.deb$")
run(dpkg-deb --field ${packages})
expect("The control file" "${output}" "Package: cgal-l0-resampling\n")
expect("The control file" "${output}" "Version: ${version}\n")
expect("The control file" "${output}" "Maintainer: The CGAL::L0_resampling authors")
expect("The control file" "${output}" "Depends: [^\n]*libc6 \\(>= ")
expect("The control file" "${output}" "Depends: [^\n]*libtbb12 ")
expect("The control file" "${output}" "Depends: [^\n]*libpng16-16 ")
expect("The control file" "${output}" "Recommends: libcgal-dev \\(>= 5\\.5\\), ")

# What is in it
run(dpkg-deb --contents ${packages})
foreach(path IN ITEMS bin/l0_resample include/CGAL/l0_resample_point_set.h
                      CGAL_L0_resamplingConfig.cmake share/doc/cgal-l0-resampling/copyright
                      share/man/man1/l0_resample.1.gz share/doc/cgal-l0-resampling/README.md
                      share/doc/cgal-l0-resampling/examples/CMakeLists.txt
                      share/doc/cgal-l0-resampling/examples/l0_resample_example.cpp
                      share/doc/cgal-l0-resampling/examples/data/bracket_noisy.ply
                      share/bash-completion/completions/l0_resample)
  expect("The list of files" "${output}" "root/root [^\n]* \\./usr/[^\n]*${path}\n")
endforeach()
# by their packages, or by the folders of their headers
foreach(library IN ITEMS CGAL|cgal Eigen|eigen3 CLI|cli11 nlohmann)
  expect("The list of files" "${output}" "/cgal-l0-resampling/licenses/[^\n]*(${library})[^\n]*\n")
endforeach()
if(LIBRARY_OF_PROGRAMS)
  foreach(folder IN ITEMS "" glibc-hwcaps/x86-64-v3/ glibc-hwcaps/x86-64-v4/)
    expect("The list of files" "${output}"
           "root/root [^\n]* \\./usr/libexec/cgal-l0-resampling/${folder}${LIBRARY_OF_PROGRAMS}\n")
  endforeach()
endif()
if(EXISTS ${MANUAL_PAGES})
  foreach(page IN ITEMS index L0_resampling_tool L0_resampling_python L0_resampling_recipes)
    expect("The list of files" "${output}" "/usr/share/doc/cgal-l0-resampling/html/${page}.html\n")
  endforeach()
endif()
string(REGEX MATCHALL "[^\n]* \\./[^\n]*" lines "${output}")
list(FILTER lines EXCLUDE REGEX " \\./(usr/.*)?$")
if(lines)
  message(SEND_ERROR "Not below /usr: ${lines}")
endif()

# What it does, installed where nothing else is
set(root ${SCRATCH}/root)
file(MAKE_DIRECTORY ${root}/var/lib/dpkg/info ${root}/var/lib/dpkg/updates)
file(WRITE ${root}/var/lib/dpkg/status "")
run(dpkg --root=${root} --force-depends,not-root --log=${SCRATCH}/dpkg.log --install ${packages})
run(dpkg --root=${root} --status cgal-l0-resampling)
expect("The status" "${output}" "Status: install ok installed\n")
run(${root}/usr/bin/l0_resample --version)
expect("The version of the program" "${output}" "^l0_resample [0-9.]+, ")
run(${root}/usr/bin/l0_resample ${DATA}/bracket_noisy.ply ${SCRATCH}/out.npy --points 500)
expect("The summary" "${output}" "500 out")
set(documentation ${root}/usr/share/doc/cgal-l0-resampling)
run(gzip -dc ${root}/usr/share/man/man1/l0_resample.1.gz)
expect("The man page" "${output}" "^\\.TH L0_RESAMPLE 1 ")
if(EXISTS ${MANUAL_PAGES})
  find_program(interpreter NAMES python3 REQUIRED)
  run(${interpreter} -B ${MANUAL}/tools/check_offline.py ${documentation}/html)
endif()
run(${CMAKE_COMMAND} -S ${documentation}/examples -B ${SCRATCH}/examples -G ${GENERATOR}
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG"
    -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON   # which one example alone does not gain from
    -DCMAKE_PREFIX_PATH=${root}/usr -DCGAL_DIR=${CGAL_DIR})
run(${CMAKE_COMMAND} --build ${SCRATCH}/examples --target l0_resample_example)
run(${CMAKE_COMMAND} -E chdir ${SCRATCH}/examples ./l0_resample_example)
if(PYTHON)
  file(GLOB python_packages ${root}/usr/lib/python3*/*-packages)
  set(ENV{PYTHONPATH} ${python_packages})
  file(WRITE ${SCRATCH}/use.py "import cgal_l0, numpy\n"
       "points = numpy.load('${SCRATCH}/out.npy')[:, :3]\n"
       "print(cgal_l0.__file__, len(cgal_l0.l0_resample_point_set(points)[0]))\n")
  run(${PYTHON} -B ${SCRATCH}/use.py)
  expect("The Python package" "${output}" "^${root}/usr/.* 250\n")
endif()
