# A build for WebAssembly (README.md beside this file).

# Its libraries are headers alone, those of this machine: they are reached by links, since beside them
# stand those of this machine's C library. Where find_package looks for them there is a file that says so.
set(headers ${PROJECT_BINARY_DIR}/headers)
function(displayfile_headers library target folder)
  if(NOT IS_DIRECTORY /usr/include/${folder})
    message(FATAL_ERROR "/usr/include/${folder} is not there; tests/page --install installs it")
  endif()
  file(MAKE_DIRECTORY ${headers})
  file(CREATE_LINK /usr/include/${folder} ${headers}/${folder} SYMBOLIC)
  set(${library}_DIR ${PROJECT_BINARY_DIR}/packages CACHE PATH "" FORCE)
  file(CONFIGURE OUTPUT packages/${library}Config.cmake @ONLY CONTENT [[
if(NOT TARGET @target@)
  add_library(@target@ INTERFACE IMPORTED)
  target_include_directories(@target@ SYSTEM INTERFACE @headers@)
endif()
]])
endfunction()
displayfile_headers(glm glm::glm glm)
displayfile_headers(fmt fmt::fmt fmt)
add_compile_definitions(FMT_HEADER_ONLY)
displayfile_headers(CLI11 CLI11::CLI11 CLI)
displayfile_headers(nlohmann_json nlohmann_json::nlohmann_json nlohmann)
displayfile_headers(hwy hwy::hwy hwy)
displayfile_headers(boost boost::boost boost)
set(BOOST_MULTIPRECISION_INCLUDE_DIR ${headers} CACHE PATH "")

# Each file is told first what the standard library lacks. Exceptions are the processor's own: smaller
# and faster than those that JavaScript would carry.
add_compile_options(-fwasm-exceptions
  "SHELL:-include ${PROJECT_SOURCE_DIR}/interp/web/standard_library.h")
add_link_options(-fwasm-exceptions -sALLOW_MEMORY_GROWTH=1)
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)
