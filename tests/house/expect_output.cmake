# Runs a command and compares what it prints and how it ends with what is known.
#
# cmake -D COMMAND=a;b;c -D EXIT_CODE=n -D OUTPUT_FILE=... -P expect_output.cmake
execute_process(COMMAND ${COMMAND} OUTPUT_VARIABLE output RESULT_VARIABLE exit_code)
file(READ ${OUTPUT_FILE} expected)
if(NOT exit_code EQUAL EXIT_CODE)
  message(FATAL_ERROR "exit code ${exit_code}, expected ${EXIT_CODE}; output:\n${output}")
endif()
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "output differs from ${OUTPUT_FILE}:\n${output}")
endif()
