# Toolchain file: compiles against the C and C++ libraries of an older Debian, so that the binaries run on systems as old.
# In: VOROGEO_SYSROOT in the environment, the folder of a root of that Debian with its libstdc++-dev.
set(CMAKE_SYSROOT "$ENV{VOROGEO_SYSROOT}")
file(GLOB gcc_library "${CMAKE_SYSROOT}/usr/lib/gcc/x86_64-linux-gnu/*")
if(NOT gcc_library)
  message(FATAL_ERROR "VOROGEO_SYSROOT is '${CMAKE_SYSROOT}', where no usr/lib/gcc/x86_64-linux-gnu is; "
                      "name a Debian root that has libstdc++-dev.")
endif()
get_filename_component(gcc_version "${gcc_library}" NAME)

# The compiler is newer than that Debian's and would take the C++ headers of its own version, and link the libraries beside it.
set(CMAKE_CXX_FLAGS_INIT "-nostdinc++ -isystem ${CMAKE_SYSROOT}/usr/include/c++/${gcc_version} \
-isystem ${CMAKE_SYSROOT}/usr/include/x86_64-linux-gnu/c++/${gcc_version}")
foreach(kind EXE MODULE SHARED)
  set(CMAKE_${kind}_LINKER_FLAGS_INIT "-L${gcc_library} -L${CMAKE_SYSROOT}/usr/lib/x86_64-linux-gnu")
endforeach()
