#pragma once

namespace displayfile {

/// From now on the signals INT, TERM, HUP, QUIT, PIPE and XCPU end the process as usual, but
/// unfinished files are removed first (clip/base/unfinished_path.h): outputs are complete or
/// unchanged. Signals ignored at process start stay ignored. Exceeding the file size limit is an
/// error like a full disk, and no signal.
void leave_nothing_when_stopped();

}  // namespace displayfile
