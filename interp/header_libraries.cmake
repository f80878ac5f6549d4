# Libraries for a build for another system, where this machine's headers are all that is needed: those
# for WebAssembly (interp/web) and for Windows (clip/system/windows).

# They are reached by links, since beside them stand those of this machine's C library. Where
# find_package looks for them there is a file that says so.
set(headers ${PROJECT_BINARY_DIR}/headers)
function(displayfile_headers library target folder)
  if(NOT IS_DIRECTORY /usr/include/${folder})
    message(FATAL_ERROR "/usr/include/${folder} is not there; interp/web/make-package and tests/elsewhere install it")
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
