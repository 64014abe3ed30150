# Brings one plugin binary per MeshLab version into the package: vorogeo/plugins/<version>/libfilter_vorogeo.so.
# In: VOROGEO_HOSTS, VOROGEO_PLUGIN_DIR, VOROGEO_ROOT, targets vorogeo_core and vorogeo_methods.
include(ExternalProject)

set(plugin_file libfilter_vorogeo.so)

if(VOROGEO_PLUGIN_DIR)
  foreach(host IN LISTS VOROGEO_HOSTS)
    if(EXISTS "${VOROGEO_PLUGIN_DIR}/${host}/${plugin_file}")
      install(PROGRAMS "${VOROGEO_PLUGIN_DIR}/${host}/${plugin_file}" DESTINATION vorogeo/plugins/${host})
    else()
      message(WARNING "There is no ${VOROGEO_PLUGIN_DIR}/${host}/${plugin_file}: the package will have no filters for "
                      "MeshLab ${host}.")
    endif()
  endforeach()
  return()
endif()
if(NOT VOROGEO_HOSTS)
  message(STATUS "VOROGEO_HOSTS is empty: the package will have its numpy part only.")
  return()
endif()

find_package(Qt5 5.15 QUIET COMPONENTS Widgets OpenGL Xml)
find_package(Eigen3 QUIET NO_MODULE)
find_path(glew_include GL/glew.h)
if(NOT Qt5_FOUND OR NOT Eigen3_FOUND OR NOT glew_include)
  message(FATAL_ERROR
    "The PyMeshLab filters are compiled against Qt 5, Eigen and GLEW. Install them:\n"
    "  apt-get install qtbase5-dev libqt5opengl5-dev libeigen3-dev libglew-dev\n"
    "or install the numpy part alone:\n"
    "  pip install ./pyfilter -C cmake.define.VOROGEO_HOSTS=")
endif()

foreach(host IN LISTS VOROGEO_HOSTS)
  execute_process(COMMAND bash "${VOROGEO_ROOT}/plugin/host/obtain_headers.sh" ${host}
                  OUTPUT_VARIABLE answer RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed)
    message(WARNING "The headers of MeshLab ${host} cannot be had (see above): the package will have no filters for it.")
    continue()
  endif()
  string(REGEX REPLACE ".*\n" "" host_source "${answer}")
  set(binary_dir "${CMAKE_CURRENT_BINARY_DIR}/plugin-${host}")
  ExternalProject_Add(plugin_${host}
    SOURCE_DIR "${CMAKE_CURRENT_SOURCE_DIR}/host_plugin"
    BINARY_DIR "${binary_dir}"
    PREFIX "${binary_dir}-steps"
    CMAKE_ARGS -DCMAKE_BUILD_TYPE=Release
               -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
               -DCMAKE_TOOLCHAIN_FILE=${CMAKE_TOOLCHAIN_FILE}
               -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
               -DCMAKE_MAKE_PROGRAM=${CMAKE_MAKE_PROGRAM}
               -DVOROGEO_CORE_LIBRARY=$<TARGET_FILE:vorogeo_core>
               -DVOROGEO_HOST_VERSION=${host}
               -DVOROGEO_HOST_SCALAR=double
               -DVOROGEO_HOST_SOURCE=${host_source}
    BUILD_ALWAYS ON
    USES_TERMINAL_BUILD ON # one after the other, with output
    BUILD_BYPRODUCTS "${binary_dir}/${plugin_file}"
    INSTALL_COMMAND ""
    DEPENDS vorogeo_core vorogeo_methods)
  install(PROGRAMS "${binary_dir}/${plugin_file}" DESTINATION vorogeo/plugins/${host})
endforeach()
