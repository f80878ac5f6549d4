#pragma once

/// Mesa keeps some 160 bytes of every OSMesa context after it is destroyed (found with Mesa
/// 22.3.6 and a program that does nothing else); LeakSanitizer is to report only our own leaks.
/// To be included by one source file of a test that draws with OSMesa.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
