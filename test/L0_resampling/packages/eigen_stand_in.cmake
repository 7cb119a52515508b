# write_eigen_stand_in(VERSION FOLDER): what Eigen 5 installs for find_package(), of VERSION, and
# with the headers in EIGEN_INCLUDE_DIRECTORY, in FOLDER for -DEigen3_DIR=FOLDER
include(CMakePackageConfigHelpers)

function(write_eigen_stand_in version folder)
  file(WRITE ${folder}/Eigen3Config.cmake "if(NOT TARGET Eigen3::Eigen)
  add_library(Eigen3::Eigen INTERFACE IMPORTED)
  set_target_properties(Eigen3::Eigen PROPERTIES
                        INTERFACE_INCLUDE_DIRECTORIES \"${EIGEN_INCLUDE_DIRECTORY}\")
endif()
")
  write_basic_package_version_file(${folder}/Eigen3ConfigVersion.cmake VERSION ${version}
                                   COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
endfunction()
