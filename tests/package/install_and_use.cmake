# cmake -D BUILD= -D SOURCE= -D WORK= -D GENERATOR= -D COMPILER= -D FLAGS=
#       -D VERSION= -P install_and_use.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${result}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
# The folders move: a package that remembers where it was built would fail.
file(RENAME ${WORK}/prefix ${WORK}/moved)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR}
  -D CMAKE_PREFIX_PATH=${WORK}/moved -D CMAKE_CXX_COMPILER=${COMPILER}
  "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/outside)
message(STATUS "${output}")

if(EXISTS ${WORK}/moved/bin/unstep)
  run(${WORK}/moved/bin/unstep --version)
  if(NOT output MATCHES "${VERSION}")
    message(FATAL_ERROR "installed unstep --version says: ${output}")
  endif()
endif()
