# cmake -P: writes OUT, a script with MODULE packed by GZIP and encoded by BASE64.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND "${GZIP}" -9nc "${MODULE}" COMMAND "${BASE64}" -w0
  OUTPUT_VARIABLE letters COMMAND_ERROR_IS_FATAL ANY)
file(WRITE "${OUT}" "oddity.module(\"${letters}\");\n")
