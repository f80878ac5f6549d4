#pragma once

/// The header that an application includes, as "displayfile/displayfile.h". It and those that it
/// includes are all that is installed (interp/public_headers.cmake); they need GLM alone. In
/// groups:

/// The library's version, by which an application may choose what it compiles. CMake and setup.py
/// read it here; tests/check-version holds all other places that state it against this one.
#define DISPLAYFILE_VERSION_MAJOR 0
#define DISPLAYFILE_VERSION_MINOR 2
#define DISPLAYFILE_VERSION_PATCH 0

// Exceptions; limits of work, and how it is stopped: Error, WorkBudget, BudgetInForce.
#include "clip/base/error.h"
#include "clip/base/work_budget.h"

// Values: points, views, how hidden surfaces are found, looks.
#include "clip/point.h"
#include "clip/surfaces.h"
#include "clip/view.h"
#include "displayfile/looks/style.h"

// Scenes: the user routines (GraphicsSystem, shapes, axes), meshes, drawing programs and dumps.
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"

// Pictures: draw, in memory, into files and streams; a Renderer, which keeps what the next picture
// needs and picks; devices of an application's own.
#include "interp/device/output_device.h"
#include "interp/device/picture.h"
#include "interp/draw/draw.h"
#include "interp/draw/renderer.h"
