#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "displayfile/files.h"
#include "tests/retained_truth.h"

namespace displayfile::test {

/// Calls visit(name, retained) for each drawing program of the gallery, replayed after
/// prepare(system).
template <class Prepare, class Visit>
void for_each_in_gallery(Prepare&& prepare, Visit&& visit) {
  for (const auto& entry :
       std::filesystem::directory_iterator(DISPLAYFILE_SOURCE_DIR "/programs")) {
    if (entry.path().extension() != ".draw") continue;
    SCOPED_TRACE(entry.path().filename());
    Retained retained;
    prepare(retained.system);
    replay_file(entry.path().string(), retained.system);
    visit(entry.path().stem().string(), retained);
  }
}

template <class Visit>
void for_each_in_gallery(Visit&& visit) {
  for_each_in_gallery([](const GraphicsSystem&) {}, visit);
}

}  // namespace displayfile::test
