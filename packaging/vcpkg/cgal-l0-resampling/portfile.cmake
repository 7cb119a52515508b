# The port builds the source tree that it lies in.
cmake_path(SET SOURCE_PATH NORMALIZE "${CURRENT_PORT_DIR}/../../..")

vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DCGAL_L0_BUILD_BENCHMARKS=OFF
    -DCGAL_L0_BUILD_EXAMPLES=OFF
    -DCGAL_L0_BUILD_TESTS=OFF
    -DCGAL_L0_BUILD_TOOL=OFF
    -DCGAL_L0_WITH_CUDA=OFF
    -DCGAL_L0_WITH_DOCUMENTATION=OFF
    -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF
    -DCGAL_L0_WITH_PYTHON=OFF
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME CGAL_L0_resampling CONFIG_PATH lib/cmake/CGAL_L0_resampling)

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
