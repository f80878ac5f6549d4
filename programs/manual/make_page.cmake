# Puts a manual page together from what the program prints of itself and what people wrote:
#   cmake -DPROGRAM=... -DSUBCOMMAND=... -DPAGE=pages/NAME.1 -DOUTPUT=NAME.1.gz -DGZIP=... -DDATE=...
#         -DVERSION=... -DDOCUMENTS=... -P make_page.cmake
# The page's text stands after the printed description up to a line '.\" OPTIONS', and its sections
# from there on after the printed options. @DOCUMENTS@ in it is where documents are installed.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${PROGRAM} --manual ${SUBCOMMAND} OUTPUT_VARIABLE printed
                COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PAGE} written)
string(REPLACE "@DOCUMENTS@" "${DOCUMENTS}" written "${written}")

# Splits a text before a line, or after it.
function(split text line before after)
  string(FIND "${text}" "\n${line}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${PAGE}: no line ${line}")
  endif()
  math(EXPR at "${at} + 1")
  string(SUBSTRING "${text}" 0 ${at} first)
  string(SUBSTRING "${text}" ${at} -1 second)
  set(${before} "${first}" PARENT_SCOPE)
  set(${after} "${second}" PARENT_SCOPE)
endfunction()
if(SUBCOMMAND STREQUAL "")
  split("${printed}" ".SH COMMANDS" head options)
else()
  split("${printed}" ".SH OPTIONS" head options)
endif()
split("\n${written}" ".\\\" OPTIONS" text sections)
string(STRIP "${text}" text)
if(NOT text STREQUAL "")
  string(APPEND text "\n")
endif()

get_filename_component(name ${PAGE} NAME_WLE)
string(TOUPPER ${name} title)
string(REPLACE "-" "\\-" title ${title})
string(REGEX REPLACE "\\.gz$" "" page ${OUTPUT})
file(WRITE ${page} ".TH ${title} 1 ${DATE} \"Display File ${VERSION}\" \"User Commands\"\n"
     ".nh\n.ad l\n${head}${text}${options}${sections}")
execute_process(COMMAND ${GZIP} -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
