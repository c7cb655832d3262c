# Writes HEADER, with what commit the SOURCE is at: "-dirty" if anything but docs differs from it.
cmake_policy(VERSION 3.25)
execute_process(COMMAND git rev-parse --short HEAD WORKING_DIRECTORY ${SOURCE}
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git status --porcelain -- . :!docs WORKING_DIRECTORY ${SOURCE}
                OUTPUT_VARIABLE edited ERROR_QUIET)
if(NOT commit)
  set(commit unknown)
elseif(edited)
  string(APPEND commit -dirty)
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define RC2_COMMIT \"@commit@\"\n" @ONLY)
