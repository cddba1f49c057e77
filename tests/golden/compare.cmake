# cmake -DPROGRAM=... -DGOLDEN=... -P compare.cmake: fails unless the program prints the golden file.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${GOLDEN} golden)
if(NOT printed STREQUAL golden)
  message(FATAL_ERROR "not what ${GOLDEN} says:\n${printed}")
endif()
