# How all our code is compiled: the language, hidden symbols, optimisation, and the target vorogeo_flags.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

# Flags for our own targets only.
add_library(vorogeo_flags INTERFACE)
# Nothing reads errno or the flags of floating-point exceptions, and without them loops with conditions become vector code.
target_compile_options(vorogeo_flags INTERFACE -fno-math-errno -fno-trapping-math)
