# Debian packages of an installation in /usr, by CPack: the preset `debian` (README.md). Included last,
# when all that is installed is known.

# ---- What each of them is ----------------------------------------------------------------------
# Components of the installation, and the packages that they are.
set(CPACK_COMPONENTS_ALL command bench library development)
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME displayfile)
set(CPACK_DEBIAN_BENCH_PACKAGE_NAME displayfile-bench)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libdisplayfile-c${PROJECT_VERSION_MAJOR})
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libdisplayfile-dev)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-displayfile)
if(DISPLAYFILE_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEBIAN_MODULES_PACKAGE_NAME displayfile-modules)
if(DISPLAYFILE_MODULE_LICENCES)
  list(APPEND CPACK_COMPONENTS_ALL modules)
endif()
set(CPACK_DEBIAN_CAD_PACKAGE_NAME displayfile-cad)
if(DISPLAYFILE_CAD_PROGRAM)
  list(APPEND CPACK_COMPONENTS_ALL cad)
endif()
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_NAME displayfile-doc)
if(DISPLAYFILE_SITE)
  list(APPEND CPACK_COMPONENTS_ALL documentation)
endif()

set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_BENCH_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_CAD_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_MODULES_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)

set(about
"Display File is a display-file, retained-mode 3D graphics system in the
textbook style. Polygons and lines are described in segments; they are viewed,
clipped, checked for back faces, sorted for visibility, kept in a display file
and drawn: to pixels (PNG, PPM), to vectors (SVG, PDF, EPS) or through OSMesa.
The picture is the one that exact arithmetic gives.
")
function(describe component summary)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${about}\n${ARGN}\n" PARENT_SCOPE)
endfunction()
describe(command "exact pictures of 3D drawing programs and meshes"
"This package has the command displayfile, which draws drawing programs and
meshes, and a gallery of drawing programs.")
describe(bench "speed against error of methods for hidden surfaces"
"This package has what the command displayfile starts for its subcommand bench:
it measures the methods side by side, beside OSMesa, Embree and gl2ps.")
describe(modules "exact pictures of 3D scenes: solids combined, DXF"
"This package has the modules that are compiled with libraries under the GPL:
they combine solids, by CGAL, and write DXF, by dxflib.")
describe(cad "exact pictures of 3D scenes: STEP and IGES"
"This package has the program that the command displayfile starts to read files
of CAD programs, STEP and IGES, by OpenCASCADE.")
describe(library "exact pictures of 3D scenes (library for C)"
"This package has the shared library that C programs use.")
describe(development "exact pictures of 3D scenes (development files)"
"This package has the headers for C++ and C, the libraries to link with, and
files for CMake and pkg-config.")
describe(python "exact pictures of 3D scenes (Python 3)"
"This package has the module displayfile, with all routines of the system and
arrays of NumPy in and out.")
describe(documentation "exact pictures of 3D scenes (documentation)"
"This package has the documentation as pages for a browser: tutorials, guide,
reference, the algorithms explained, and a gallery.")

# ---- Whose, and which version ------------------------------------------------------------------
set(CPACK_DEBIAN_PACKAGE_RELEASE ${DISPLAYFILE_DEBIAN_REVISION})
set(CPACK_DEBIAN_PACKAGE_SOURCE displayfile)
set(CPACK_PACKAGE_NAME displayfile)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(same "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# ---- What each of them needs -------------------------------------------------------------------
# Libraries that programs are linked with dpkg-shlibdeps finds; the rest, dependencies.cmake.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_BENCH_PACKAGE_DEPENDS "displayfile ${same}")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "displayfile-bench ${same}")
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS "hershey-fonts-data")  # which tutorials use
set(and_modules)
if(DISPLAYFILE_CAD_PROGRAM)
  set(and_modules ", displayfile-cad ${same}")
  string(APPEND CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "${and_modules}")
endif()
if(DISPLAYFILE_MODULE_LICENCES)
  string(APPEND and_modules ", displayfile-modules ${same}")
  string(APPEND CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS ", displayfile-modules ${same}")
endif()
# The program that reads foreign formats is in the command's package.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "displayfile${and_modules}, hershey-fonts-data")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "displayfile${and_modules}, hershey-fonts-data, python3-matplotlib, python3-dask, python3-distributed")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME} ${same}")
if(DISPLAYFILE_PYTHON)
  # An extension module is of one version of Python.
  get_directory_property(minor DIRECTORY interp/python DEFINITION Python_VERSION_MINOR)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${minor}~), python3 (<< 3.${next}), python3-numpy")
endif()

# ---- How they are made -------------------------------------------------------------------------
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
    GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(sources ${PROJECT_SOURCE_DIR}/programs/debian)
file(WRITE ${PROJECT_BINARY_DIR}/debian/shlibs "libdisplayfile_c ${PROJECT_VERSION_MAJOR} "
     "${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME} (>= ${PROJECT_VERSION})\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA
    ${sources}/library/triggers ${PROJECT_BINARY_DIR}/debian/shlibs)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${sources}/python/postinst ${sources}/python/prerm)
set(import_program)
if(DISPLAYFILE_IMPORT_PROGRAM)
  set(import_program $<TARGET_FILE:displayfile_import_program>)
endif()
set(python_module)
if(DISPLAYFILE_PYTHON)
  set(python_module $<TARGET_FILE:displayfile_python>)
endif()
configure_file(programs/debian/dependencies.cmake.in debian/dependencies.cmake.in @ONLY)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/debian/dependencies.cmake)
file(GENERATE OUTPUT ${CPACK_PROJECT_CONFIG_FILE}
     INPUT ${PROJECT_BINARY_DIR}/debian/dependencies.cmake.in)

# What policy wants each package to say of itself: whose it is, and what has changed.
file(READ LICENSE licence)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]+)" copyright "${licence}")
set(copyright ${CMAKE_MATCH_1})
string(REGEX REPLACE "^.*\n\n(Permission.*)$" "\\1" licence "${licence}")
string(STRIP "${licence}" licence)
string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence "${licence}")
function(write_copyright file licence_of_all)
  file(CONFIGURE OUTPUT debian/${file} CONTENT [[
Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Display File
@licence_of_all@
Files: *
Copyright: @copyright@
License: Expat

License: Expat
 @licence@
]] @ONLY)
endfunction()
write_copyright(copyright "")
# The modules as a whole are under another licence than the source.
set(gpl 2)
if(DISPLAYFILE_MODULE_LICENCES MATCHES CGAL)
  set(gpl 3)
endif()
string(REPLACE "CGAL) GPL-3.0-or-later" "CGAL: GPL, version 3 or later)" with
       "${DISPLAYFILE_MODULE_LICENCES}")
string(REPLACE "dxflib) GPL-2.0-or-later" "dxflib: GPL, version 2 or later)" with "${with}")
write_copyright(copyright-modules "License: GPL-${gpl}+
 The source is under the Expat licence, which is also called the MIT licence. These
 modules are compiled with libraries under the GNU General Public License, and are
 under it too: ${with}.
 .
 On Debian systems, the complete text of the GNU General Public License, version ${gpl}, is in
 /usr/share/common-licenses/GPL-${gpl}.
")
find_program(GZIP gzip REQUIRED)
set(signed_changelog ${PROJECT_BINARY_DIR}/debian/changelog.Debian.gz)
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(licence_file copyright)
  if("${component}" STREQUAL "modules")
    set(licence_file copyright-modules)
  endif()
  install(FILES ${PROJECT_BINARY_DIR}/debian/${licence_file} RENAME copyright
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DGZIP=${GZIP}\"
    \"-DCHANGELOG=${sources}/changelog\" \"-DOUTPUT=${signed_changelog}\"
    -P \"${sources}/signed_changelog.cmake\" COMMAND_ERROR_IS_FATAL ANY)"
    COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${signed_changelog}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
  set(overrides "")
  if("${component}" STREQUAL "documentation")
    file(READ ${sources}/lintian-overrides-doc overrides)
  endif()
  configure_file(programs/debian/lintian-overrides.in debian/lintian/${package} @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/debian/lintian/${package}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component}
          EXCLUDE_FROM_ALL)
endforeach()

include(CPack)
