#pragma once

// Windows's header, without its macros named min and max and the parts that nothing here uses.
#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
