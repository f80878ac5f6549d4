#include "programs/warnings.h"

#include <iostream>
#include <utility>

namespace displayfile {

namespace {
thread_local std::ostream* collected = nullptr;
}

std::ostream& warnings() { return collected == nullptr ? std::cerr : *collected; }

CollectedWarnings::CollectedWarnings(std::ostream& into)
    : before_(std::exchange(collected, &into)) {}
CollectedWarnings::~CollectedWarnings() { collected = before_; }

}  // namespace displayfile
