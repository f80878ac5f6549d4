# Sets `maintainer`, the person who makes the packages, for cpack and for the installed changelog. As
# for all of Debian's tools DEBFULLNAME and DEBEMAIL name them; without these it is an address of this
# machine, and the packages are for this machine alone.
set(name "$ENV{DEBFULLNAME}")
set(address "$ENV{DEBEMAIL}")
if("${name}" STREQUAL "")
  set(name "The Display File authors")
endif()
if("${address}" STREQUAL "")
  cmake_host_system_information(RESULT host QUERY FQDN)
  execute_process(COMMAND id -un OUTPUT_VARIABLE user OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  set(address "${user}@${host}")
endif()
set(maintainer "${name} <${address}>")
