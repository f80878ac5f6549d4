#pragma once

/// The application's single include, as "displayfile/displayfile.h". Only this header and those
/// that it includes are installed (interp/public_headers.cmake); they depend on GLM alone. In
/// groups:

/// The library's version, for conditional compilation. CMake and setup.py read it here;
/// tests/check-version compares all other places that state it with this one.
#define DISPLAYFILE_VERSION_MAJOR 0
#define DISPLAYFILE_VERSION_MINOR 2
#define DISPLAYFILE_VERSION_PATCH 0

// Exceptions, and limits on work and how to stop it: Error, WorkBudget, BudgetInForce.
#include "clip/base/error.h"
#include "clip/base/work_budget.h"

// Values: points, views, hidden-surface settings, looks.
#include "clip/point.h"
#include "clip/surfaces.h"
#include "clip/view.h"
#include "displayfile/looks/style.h"

// Scenes: the user routines (GraphicsSystem, shapes, axes), meshes, drawing programs and dumps.
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"

// Pictures: draw, into memory, files and streams; a Renderer, which caches between pictures and
// picks; an application's own output devices.
#include "interp/device/output_device.h"
#include "interp/device/picture.h"
#include "interp/draw/draw.h"
#include "interp/draw/renderer.h"
