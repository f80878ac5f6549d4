#include "programs/process/stop_signals.h"

#include "clip/base/unfinished_path.h"
#include "clip/system/stopping.h"

namespace displayfile {

void leave_nothing_when_stopped() { call_when_stopped(UnfinishedPath::end_with_none); }

}  // namespace displayfile
