#pragma once

namespace displayfile {

/// From now on all system calls of this process fail (EPERM) that reading files, memory and
/// answering on open descriptors do not need: there are no sockets, no new processes, programs or
/// threads, no files opened to be written, no memory that can be executed, no signals to others.
/// It cannot be taken back. False if this kernel or processor has no such filter.
bool allow_reading_calls_only();

}  // namespace displayfile
