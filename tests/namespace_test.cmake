# Registers a command with CTest that runs in a network namespace of its own (in_namespace.sh).
#   wells_namespace_test(<name> loopback|isolated|lan COMMAND <command>...)
include_guard(GLOBAL)

function(wells_namespace_test name kind)
  cmake_parse_arguments(ARG "" "" "COMMAND" ${ARGN})
  add_test(NAME ${name} COMMAND ${PROJECT_SOURCE_DIR}/tests/in_namespace.sh ${kind} ${ARG_COMMAND})
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
endfunction()
