# Writes the changelog of a package, signed by its maintainer and packed:
#   cmake -DCHANGELOG=... -DOUTPUT=....gz -DGZIP=... -P signed_changelog.cmake
include(${CMAKE_CURRENT_LIST_DIR}/maintainer.cmake)
file(READ ${CHANGELOG} text)
string(REPLACE "@MAINTAINER@" "${maintainer}" text "${text}")
string(REGEX REPLACE "\\.gz$" "" signed ${OUTPUT})
file(WRITE ${signed} "${text}")
execute_process(COMMAND ${GZIP} -9nc ${signed} OUTPUT_FILE ${OUTPUT} COMMAND_ERROR_IS_FATAL ANY)
