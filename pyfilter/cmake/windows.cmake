# Toolchain file: compiles for Windows by mingw-w64. The binaries bring the runtime of the compiler with them.
# In: VOROGEO_WINDOWS_PYTHON in the environment, the folder of a CPython 3.11 for Windows with its headers and import library.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix) # posix: with std::thread
set(CMAKE_MODULE_LINKER_FLAGS_INIT "-static -s")

# The interpreter that is found is that of the system that compiles: what is its own is not taken from it.
set(Python_INCLUDE_DIR "$ENV{VOROGEO_WINDOWS_PYTHON}/include" CACHE PATH "" FORCE)
set(Python_LIBRARY "$ENV{VOROGEO_WINDOWS_PYTHON}/libs/python311.lib" CACHE FILEPATH "" FORCE)
set(SKBUILD_SOABI cp311-win_amd64 CACHE STRING "" FORCE)
set(NB_SUFFIX ".${SKBUILD_SOABI}.pyd")
