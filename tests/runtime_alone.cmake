# SPDX-License-Identifier: GPL-2.0-or-later
# The library part of src configures and builds where GiNaC and CLN cannot be found.
# cmake -D SOURCE=... -D BINARY=... -P runtime_alone.cmake
file(REMOVE_RECURSE ${BINARY})
set(ENV{PKG_CONFIG_LIBDIR} ${BINARY}/nothing) # pkg-config finds no ginac, no cln
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY} -DMAGICMASS_SYMBOLIC=OFF
  -DMAGICMASS_TESTS=OFF -DCMAKE_BUILD_TYPE=Debug COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BINARY} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY}/symbolic -DMAGICMASS_TESTS=OFF
  RESULT_VARIABLE with_symbolic OUTPUT_QUIET ERROR_QUIET)
if(with_symbolic EQUAL 0)
  message(FATAL_ERROR "GiNaC was found: this test shows nothing")
endif()
file(REMOVE_RECURSE ${BINARY})
