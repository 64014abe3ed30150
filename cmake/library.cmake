# The library that others install: target vorogeo::vorogeo, its headers, its package files. Needs nothing beside the core.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
find_package(Threads REQUIRED)

# Static, or shared with -DBUILD_SHARED_LIBS=ON. The core is in it; only what the public header declares is visible.
add_library(vorogeo ${PROJECT_SOURCE_DIR}/core/vorogeo.cpp ${PROJECT_SOURCE_DIR}/core/vorogeo_means.cpp
            ${PROJECT_SOURCE_DIR}/core/vorogeo_sides.cpp)
get_target_property(vorogeo_type vorogeo TYPE)
if(vorogeo_type STREQUAL SHARED_LIBRARY OR VOROGEO_CORE_LIBRARY)
  target_link_libraries(vorogeo PRIVATE $<BUILD_INTERFACE:vorogeo_core>)
else() # an archive has to bring the core's objects itself
  target_sources(vorogeo PRIVATE $<TARGET_OBJECTS:vorogeo_core>)
endif()
add_library(vorogeo::vorogeo ALIAS vorogeo)
target_include_directories(vorogeo PRIVATE ${PROJECT_SOURCE_DIR}/core
                           PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(vorogeo PUBLIC cxx_std_20)
target_link_libraries(vorogeo PRIVATE $<BUILD_INTERFACE:vorogeo_flags> Threads::Threads)
# Until 1.0 a minor version may change the interface.
set_target_properties(vorogeo PROPERTIES VERSION ${PROJECT_VERSION}
                      SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

if(vorogeo_type STREQUAL SHARED_LIBRARY AND NOT APPLE)
  target_link_options(vorogeo PRIVATE "-Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/vorogeo.map")
  set_target_properties(vorogeo PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/vorogeo.map)
endif()

if(NOT VOROGEO_INSTALL OR (VOROGEO_CORE_LIBRARY AND vorogeo_type STREQUAL STATIC_LIBRARY))
  return() # an archive around a core compiled before is complete only together with it
endif()
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/vorogeo)
install(TARGETS vorogeo EXPORT vorogeoTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/VERSION DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(EXPORT vorogeoTargets NAMESPACE vorogeo:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/vorogeoConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/vorogeoConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/vorogeoConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/vorogeoConfig.cmake ${PROJECT_BINARY_DIR}/vorogeoConfigVersion.cmake
        DESTINATION ${package_dir})

# A static library also needs the C++ library and threads, of which pkg-config has to be told.
set(pkgconfig_libs "-L\${libdir} -lvorogeo")
if(vorogeo_type STREQUAL STATIC_LIBRARY)
  string(APPEND pkgconfig_libs " ${CMAKE_THREAD_LIBS_INIT}")
endif()
file(RELATIVE_PATH from_libdir "${CMAKE_INSTALL_FULL_LIBDIR}" "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
set(pkgconfig_includedir "\${libdir}/${from_libdir}")
configure_file(${PROJECT_SOURCE_DIR}/cmake/vorogeo.pc.in ${PROJECT_BINARY_DIR}/vorogeo.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/vorogeo.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
