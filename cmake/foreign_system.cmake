# Toolchain for the cross compilers of Debian:
#   cmake -DCMAKE_TOOLCHAIN_FILE=cmake/foreign_system.cmake -DL0_SYSTEM=<as in the names of the
#         compilers> -DL0_PREFIX=<what scripts/foreign_libraries.sh has made> ...
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES L0_SYSTEM L0_PREFIX)
set(CMAKE_SYSTEM_NAME Linux)
if(L0_SYSTEM MATCHES "mingw")
  set(CMAKE_SYSTEM_NAME Windows)
  set(CMAKE_RC_COMPILER ${L0_SYSTEM}-windres)
  set(CMAKE_CROSSCOMPILING_EMULATOR wine)
elseif(L0_SYSTEM MATCHES "s390x")
  set(CMAKE_CROSSCOMPILING_EMULATOR qemu-s390x)
elseif(L0_SYSTEM MATCHES "i686")
  set(CMAKE_CROSSCOMPILING_EMULATOR qemu-i386)   # Not all kernels of 64 bits run programs of 32.
  # Without them, numbers have more digits in registers than in memory.
  set(CMAKE_C_FLAGS_INIT "-msse2 -mfpmath=sse")
  set(CMAKE_CXX_FLAGS_INIT "-msse2 -mfpmath=sse")
endif()
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)   # Libraries of that system are not where programs look.
string(REGEX REPLACE "-.*" "" CMAKE_SYSTEM_PROCESSOR ${L0_SYSTEM})
# Of mingw-w64, the version with threads of C++
find_program(CMAKE_C_COMPILER REQUIRED NAMES ${L0_SYSTEM}-gcc-posix ${L0_SYSTEM}-gcc-12)
find_program(CMAKE_CXX_COMPILER REQUIRED NAMES ${L0_SYSTEM}-g++-posix ${L0_SYSTEM}-g++-12)
# Programs are those of this system, libraries and headers are not.
set(CMAKE_FIND_ROOT_PATH ${L0_PREFIX} /usr/${L0_SYSTEM})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
