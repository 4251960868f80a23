# SPDX-License-Identifier: GPL-2.0-or-later
# cmake --install, what find_package and pkg-config find there, and the Debian packages that cpack makes of it.
# Components: development (headers, libraries) and program. Version, name and description are project()'s, in
# ../CMakeLists.txt; examples ask for a version of their own, as any project does.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/magicmass)

# Header a/b/c.hpp of a list goes to FOLDER/b/c.hpp, where `source` is a.
include(${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake)
function(install_headers folder source)
  foreach(header IN LISTS ARGN)
    cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${source} OUTPUT_VARIABLE below)
    cmake_path(GET below PARENT_PATH below)
    install(FILES ${header} DESTINATION ${folder}/${below})
  endforeach()
endfunction()

# The runtime: headers and one library.
set(runtime_targets magicmass_errors magicmass_arithmetic magicmass_generated magicmass_runtime)
foreach(target IN LISTS runtime_targets)
  string(REPLACE magicmass_ "" exported_name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${exported_name})
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endforeach()
install(TARGETS ${runtime_targets} EXPORT runtime)
install(EXPORT runtime NAMESPACE magicmass:: DESTINATION ${package_folder})
install_headers(${CMAKE_INSTALL_INCLUDEDIR} src ${runtime_headers} ${arithmetic_headers})
install_headers(${CMAKE_INSTALL_INCLUDEDIR} generated ${generated_headers})
# a folder of its own: two packages that have one file cannot be installed together
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libmagicmass-dev)

if(MAGICMASS_SYMBOLIC)
  # The symbolic libraries include each other as "proof/kernel.hpp", so they have a folder of their own.
  set(symbolic_includes ${CMAKE_INSTALL_INCLUDEDIR}/magicmass-symbolic)
  set(symbolic_libraries algebraic proof derivation equality codegen render)
  foreach(name IN LISTS symbolic_libraries ITEMS reference)
    set_target_properties(magicmass_${name} PROPERTIES EXPORT_NAME ${name})
    list(APPEND symbolic_targets magicmass_${name})
  endforeach()
  foreach(name IN LISTS symbolic_libraries)
    target_include_directories(magicmass_${name} INTERFACE $<INSTALL_INTERFACE:${symbolic_includes}>)
  endforeach()
  install_headers(${symbolic_includes} symbolic ${symbolic_headers})
  install_headers(${CMAKE_INSTALL_INCLUDEDIR} src ${reference_headers})
  set_target_properties(magicmass_symbolic PROPERTIES EXPORT_NAME symbolic)
  install(TARGETS ${symbolic_targets} magicmass_symbolic EXPORT symbolic)
  install(EXPORT symbolic NAMESPACE magicmass:: DESTINATION ${package_folder})

  # Man pages and completions come from the program just built.
  set(pages ${PROJECT_BINARY_DIR}/pages)
  add_custom_command(OUTPUT ${pages}/written
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${pages}
    COMMAND magicmass manual --man ${pages}/man1 --completions ${pages}/completions
    COMMAND ${CMAKE_COMMAND} -E touch ${pages}/written
    DEPENDS magicmass VERBATIM)
  add_custom_target(magicmass_pages ALL DEPENDS ${pages}/written)
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
  install(TARGETS magicmass)
  install(DIRECTORY ${pages}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
  install(FILES ${pages}/completions/magicmass DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${pages}/completions/_magicmass DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
  install(FILES ${pages}/completions/magicmass.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  set(data ${CMAKE_INSTALL_DATADIR}/magicmass) # src/command/data_folder.cpp looks here
  install(DIRECTORY tutorials/scenes DESTINATION ${data})
  install(DIRECTORY tutorials DESTINATION ${data} FILES_MATCHING
    REGEX "/exercises/[a-z0-9_]+/" PATTERN exercise_driver.hpp PATTERN TEACHERS.md
    PATTERN scenes EXCLUDE PATTERN course EXCLUDE)
  # The course is rendered when it is installed, in seconds, and not in each build; again where something is newer. It is
  # left out without pandoc.
  set(course ${PROJECT_BINARY_DIR}/installed/course)
  install(CODE "
  file(GLOB_RECURSE sources ${PROJECT_SOURCE_DIR}/tutorials/*)
  foreach(source IN LISTS sources ITEMS $<TARGET_FILE:magicmass>)
    if(\"\${source}\" IS_NEWER_THAN ${course}/index.html)
      execute_process(COMMAND $<TARGET_FILE:magicmass_course> --tutorials ${PROJECT_SOURCE_DIR}/tutorials
        --programs ${CMAKE_BINARY_DIR}/bin/tutorials --magicmass $<TARGET_FILE:magicmass> --out ${course}
        RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE said)
      if(failed)
        file(REMOVE_RECURSE ${course})
        string(STRIP \"\${said}\" said)
        if(failed EQUAL 77)
          message(STATUS \"Not installed: \${said}\")
        else()
          message(FATAL_ERROR \"\${said}\")
        endif()
      endif()
      break()
    endif()
  endforeach()")
  install(DIRECTORY ${course} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/magicmass OPTIONAL)
  install(DIRECTORY generated/ DESTINATION ${data}/generated PATTERN CMakeLists.txt EXCLUDE)
  install(DIRECTORY src/command/schemas DESTINATION ${data})
  install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/magicmass)
endif()

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
configure_package_config_file(packaging/magicmassConfig.cmake.in ${PROJECT_BINARY_DIR}/magicmassConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/magicmassConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/magicmassConfig.cmake ${PROJECT_BINARY_DIR}/magicmassConfigVersion.cmake
  DESTINATION ${package_folder})
# From LIBDIR/pkgconfig up to the prefix, so that what was moved is found where it is.
file(RELATIVE_PATH PC_UP /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(packaging/magicmass.pc.in magicmass.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/magicmass.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(MAGICMASS_SYMBOLIC)
  configure_file(packaging/magicmass-symbolic.pc.in magicmass-symbolic.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/magicmass-symbolic.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

if(PROJECT_IS_TOP_LEVEL)
  include(packaging/reference/reference.cmake)
  include(packaging/debian.cmake)
endif()
