# Writes build_info.cpp at build time, so that the commit is the one that is built and not the one
# that was configured. Variables: INPUT, OUTPUT, SOURCE_DIR, COMPILER, FLAGS.
execute_process(
  COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12 --exclude=*
  OUTPUT_VARIABLE COMMIT
  OUTPUT_STRIP_TRAILING_WHITESPACE
  ERROR_QUIET)
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
configure_file(${INPUT} ${OUTPUT} @ONLY)
