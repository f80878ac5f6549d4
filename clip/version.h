#pragma once

/// The library's version, by which an application may choose what it compiles. CMake reads it here.
#define DISPLAYFILE_VERSION_MAJOR 0
#define DISPLAYFILE_VERSION_MINOR 1
#define DISPLAYFILE_VERSION_PATCH 0
