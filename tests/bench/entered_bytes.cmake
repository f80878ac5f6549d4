# Adds entered_bytes to a build of any tree, for one that does not have it yet. Given to cmake as
#   -DCMAKE_PROJECT_displayfile_INCLUDE=FOLDER/entered_bytes.cmake
# it runs where the project begins, and waits until the libraries are declared.
set(ENTERED_BYTES_FOLDER ${CMAKE_CURRENT_LIST_DIR})
function(add_entered_bytes)
  if(TARGET entered_bytes)
    return()
  endif()
  add_executable(entered_bytes
    ${ENTERED_BYTES_FOLDER}/entered_bytes.cpp
    programs/bench/counted_memory.cpp)  # where older trees have it
  target_link_libraries(entered_bytes PRIVATE displayfile::displayfile)
endfunction()
cmake_language(DEFER CALL add_entered_bytes)
