# Toolchain file: compiles for Linux on aarch64 by Debian's cross compiler.
# In: VOROGEO_AARCH64 in the environment, the folder of pyfilter/wheels/obtain_aarch64_python.sh.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
# Debian's headers of Python include one by its path below /usr/include.
set(CMAKE_CXX_FLAGS_INIT "-Wno-psabi -isystem $ENV{VOROGEO_AARCH64}/usr/include")
set(CMAKE_MODULE_LINKER_FLAGS_INIT "-s")

# The interpreter that is found is that of the system that compiles: what is its own is not taken from it.
set(Python_INCLUDE_DIR "$ENV{VOROGEO_AARCH64}/usr/include/python3.11" CACHE PATH "" FORCE)
set(SKBUILD_SOABI cpython-311-aarch64-linux-gnu CACHE STRING "" FORCE)
set(NB_SUFFIX ".${SKBUILD_SOABI}.so")
