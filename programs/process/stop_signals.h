#pragma once

namespace displayfile {

/// From now on the signals INT, TERM, HUP, QUIT, PIPE and XCPU end the process as they always do,
/// but what is unfinished is removed before (clip/base/unfinished_path.h): outputs are whole, or
/// what they were. A signal that the process was started to ignore stays ignored. A file that would
/// be larger than the process may write is an error like a full disk, and no signal.
void leave_nothing_when_stopped();

}  // namespace displayfile
