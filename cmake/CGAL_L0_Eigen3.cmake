# Finds Eigen 3.3.7 or later and gives CGAL::Eigen3_support, or l0_eigen_refusal says why not. The
# version files of Eigen accept their own major version only: a request for 3.3.7 refuses Eigen 5.
find_package(Eigen3 CONFIG QUIET)
set(l0_eigen_version "${Eigen3_VERSION}")
if(NOT Eigen3_FOUND)   # headers alone, for which CGAL 5 has a module
  find_package(Eigen3 QUIET)
  set(l0_eigen_version "${EIGEN3_VERSION}")
endif()
set(l0_eigen_refusal "")
if(NOT l0_eigen_version VERSION_GREATER_EQUAL 3.3.7)
  set(l0_eigen_refusal "Eigen 3.3.7 or later is needed, and the version \"${l0_eigen_version}\" was\
 found. -DEigen3_DIR=... names the folder of Eigen3Config.cmake.")
  return()
endif()
# CGAL 5 reads these, and Eigen 5 does not set them.
if(NOT EIGEN3_FOUND AND TARGET Eigen3::Eigen)
  set(EIGEN3_FOUND ON)
  get_target_property(EIGEN3_INCLUDE_DIR Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
endif()
include(CGAL_Eigen3_support)
