#pragma once

/// The import library does not free all that it took for a file that it refuses; LeakSanitizer is
/// to report only our own leaks. To be included by one source file of a test that imports meshes.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }
