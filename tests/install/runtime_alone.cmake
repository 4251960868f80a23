# SPDX-License-Identifier: GPL-2.0-or-later
# Where GiNaC and CLN cannot be found, the library part builds as a subproject that changes nothing of the project it
# is in, installs, and is found there without its symbolic part.
# What is installed stays in BINARY/stage, where compilers_agree compares its bits.
# cmake -D SOURCE=... -D BINARY=... -D COMPILER=... -P runtime_alone.cmake
set(project ${CMAKE_CURRENT_LIST_DIR}/project)
set(quietly COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
file(REMOVE_RECURSE ${BINARY})
set(ENV{CXX} ${COMPILER})
set(ENV{PKG_CONFIG_LIBDIR} ${BINARY}/nothing) # pkg-config finds no ginac, no cln

function(expect_examples folder)
  foreach(name IN ITEMS evaluate count simulate)
    execute_process(COMMAND ${folder}/examples/${name} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
    file(READ ${SOURCE}/examples/expected_output/${name}.txt expected)
    if(NOT said STREQUAL expected)
      message(FATAL_ERROR "${folder}/examples/${name} says ${said}")
    endif()
  endforeach()
  execute_process(COMMAND ${folder}/scene OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  if(NOT said STREQUAL "3 bodies\n")
    message(FATAL_ERROR "${folder}/scene says ${said}")
  endif()
endfunction()

execute_process(COMMAND ${CMAKE_COMMAND} -S ${project} -B ${BINARY} -DMAGICMASS_SUBPROJECT=${SOURCE}
  -DMAGICMASS_INSTALL=ON -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON ${quietly})
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BINARY} ${quietly} ERROR_VARIABLE said)
if(said)
  message(FATAL_ERROR "as a subproject it is not built in silence: ${said}")
endif()
expect_examples(${BINARY})
file(STRINGS ${BINARY}/compile_commands.json warned REGEX "-W(all|extra|error)")
file(STRINGS ${BINARY}/compile_commands.json own REGEX "-ffp-contract=off.*/examples/count.cpp")
if(warned OR own)
  message(FATAL_ERROR "flags of magicmass' own development reach others: ${warned} ${own}")
endif()

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BINARY} --prefix ${BINARY}/stage ${quietly})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${project} -B ${BINARY}/user -DCMAKE_PREFIX_PATH=${BINARY}/stage ${quietly})
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BINARY}/user ${quietly})
expect_examples(${BINARY}/user)

# Each of these must fail, and the last say why.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY}/symbolic -DMAGICMASS_TESTS=OFF
  RESULT_VARIABLE with_symbolic OUTPUT_QUIET ERROR_QUIET)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${project} -B ${BINARY}/prover -DCMAKE_PREFIX_PATH=${BINARY}/stage
  -DWITH_SYMBOLIC=ON RESULT_VARIABLE user_of_symbolic OUTPUT_QUIET ERROR_VARIABLE said)
if(with_symbolic EQUAL 0)
  message(FATAL_ERROR "GiNaC was found: this test shows nothing")
elseif(user_of_symbolic EQUAL 0 OR NOT said MATCHES "built with MAGICMASS_SYMBOLIC=OFF")
  message(FATAL_ERROR "a symbolic part that is not there was found: ${said}")
endif()
