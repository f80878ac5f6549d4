# A build for WebAssembly (README.md beside this file).

include(interp/header_libraries.cmake)

# Each file is told first what the standard library lacks. Exceptions are the processor's own: smaller
# and faster than those that JavaScript would carry.
add_compile_options(-fwasm-exceptions
  "SHELL:-include ${PROJECT_SOURCE_DIR}/interp/web/standard_library.h")
add_link_options(-fwasm-exceptions -sALLOW_MEMORY_GROWTH=1)
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)

# No file asks what kind an object is: the names of all kinds are left out. Nor is a long double printed.
add_compile_options(-fno-rtti)
add_compile_definitions(FMT_USE_LONG_DOUBLE=0)

# A page is loaded before it draws: what most of the time is spent in is compiled for speed, all else for
# size. There functions of a few lines are put in place of their calls, too: left where they are, as -Os
# leaves them, they would make it slower by far, and no smaller.
set(DISPLAYFILE_SIZE -O2 -fno-unroll-loops "SHELL:-mllvm -inline-threshold=10"
    "SHELL:-mllvm -inlinehint-threshold=100")
# What most of the time is spent in: predicates (not exact numbers, which they seldom need), scan
# conversion, the painters, methods of image space; and views of what is retained.
string(CONCAT DISPLAYFILE_SPEED "^scan/|"
  "^exact/(common_line|defined_point|depth|entered|eye|line_parameter|orientation|p[il]|support)|"
  "^(scene_viewer|triangle_sieve|view_points|view_rounding|view_volume)\\.|"
  "^raster/(fill_paints|painter|sorted_painter|write_pixels)|"
  "^visibility/(depth_row|image_space|pixel_tree|ray_|row_|scan_line|span_sweep|warnock\\.|z_buffer)")

# Takes the files that are compiled for speed out of a list of a library's, and puts in what is made of
# them.
function(displayfile_for_speed name variable)
  set(fast ${${variable}})
  list(FILTER fast INCLUDE REGEX "${DISPLAYFILE_SPEED}")
  if(NOT fast)
    return()
  endif()
  set(others ${${variable}})
  list(REMOVE_ITEM others ${fast})
  set(target displayfile_${name}_for_speed)
  add_library(${target} OBJECT ${fast})
  displayfile_options(${target})
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
  target_include_directories(${target} SYSTEM PRIVATE ${headers})
  target_compile_features(${target} PRIVATE cxx_std_20)
  set(${variable} ${others} $<TARGET_OBJECTS:${target}> PARENT_SCOPE)
endfunction()
