# SPDX-License-Identifier: GPL-2.0-or-later
# `cmake --build --preset default --target reference`: build/reference/index.html from the public headers, by Doxygen.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  list(TRANSFORM public_headers PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE reference_input)
  list(APPEND reference_input ${CMAKE_CURRENT_LIST_DIR}/overview.dox)
  list(JOIN reference_input " " REFERENCE_INPUT)
  set(REFERENCE_OUTPUT ${PROJECT_BINARY_DIR}/reference)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
  file(MAKE_DIRECTORY ${REFERENCE_OUTPUT})
  add_custom_target(reference
    COMMAND Doxygen::doxygen ${PROJECT_BINARY_DIR}/Doxyfile
    COMMENT "Reference in ${REFERENCE_OUTPUT}/index.html" VERBATIM)
endif()
