#pragma once

namespace displayfile {

/// From now on the signals INT, TERM and HUP end the process as they always do, but what is
/// unfinished is removed before (displayfile/unfinished_path.h): outputs are whole, or what they
/// were. A signal that the process was started to ignore stays ignored.
void leave_nothing_when_stopped();

}  // namespace displayfile
