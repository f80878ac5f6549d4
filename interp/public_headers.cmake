# The headers that an application includes: interp/displayfile.h, and all that it includes in turn.
#   cmake -DSOURCE=... -DOUTPUT=... -P interp/public_headers.cmake
# Writes them to the folder OUTPUT, which an installation has as include/displayfile: displayfile.h
# at its root, those of displayfile/ beside it, those of other folders in folders of their names.
# There they include one another by paths relative to themselves, so that an application has nothing
# of them in its include path but the one folder, and no header of its own is taken for one of them.
#
# Fails if one of them includes a header of hidden/, or of a room of interp/ other than draw and
# device: the algorithms, and the interpreter's own things, are there.
cmake_minimum_required(VERSION 3.25)

set(to_visit interp/displayfile.h)
set(visited)
file(REMOVE_RECURSE ${OUTPUT})

# Where a header stands in the folder.
function(place header result)
  string(REGEX REPLACE "^displayfile/|^interp/displayfile.h$" "" name ${header})
  if(name STREQUAL "")
    set(name displayfile.h)
  endif()
  set(${result} ${name} PARENT_SCOPE)
endfunction()

while(to_visit)
  list(POP_FRONT to_visit header)
  list(APPEND visited ${header})
  place(${header} own_place)
  get_filename_component(own_folder /${own_place} DIRECTORY)
  file(READ ${SOURCE}/${header} text)
  string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
  foreach(include ${includes})
    string(REGEX REPLACE "#include \"([^\"]+)\"" "\\1" included ${include})
    if(included MATCHES "^hidden/" OR
       (included MATCHES "^interp/.*/" AND NOT included MATCHES "^interp/(draw|device)/"))
      message(FATAL_ERROR "${header}, which applications include, includes ${included}, which is "
                          "private: a room's own")
    endif()
    place(${included} included_place)
    file(RELATIVE_PATH relative ${own_folder} /${included_place})
    string(REPLACE "${include}" "#include \"${relative}\"" text "${text}")
    if(NOT included IN_LIST visited AND NOT included IN_LIST to_visit)
      list(APPEND to_visit ${included})
    endif()
  endforeach()
  file(WRITE ${OUTPUT}/${own_place} "${text}")
endwhile()
