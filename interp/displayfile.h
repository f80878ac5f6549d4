#pragma once

/// What an application includes, as "displayfile/displayfile.h": the user routines
/// (GraphicsSystem), drawing them into pictures and files (draw, or a Renderer that keeps what the
/// next picture needs and picks), what is thrown (Error), drawing programs, meshes, dumps, and
/// views of a retained scene and picking in it. This header and those that it includes are all that
/// is installed (interp/public_headers.cmake); they need GLM alone.

#include "clip/error.h"
#include "clip/version.h"
#include "displayfile/axes.h"
#include "displayfile/drawn_pieces.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/recorder.h"
#include "displayfile/retained_scene.h"
#include "displayfile/shapes/shapes.h"
#include "displayfile/text/drawing_program.h"
#include "displayfile/text/dump.h"
#include "displayfile/text/user_routine.h"
#include "displayfile/turntable.h"
#include "interp/draw/draw.h"
#include "interp/draw/nothing_seen.h"
#include "interp/draw/other_eye.h"
#include "interp/draw/renderer.h"
#include "interp/draw/turntable_renderer.h"
