// Meshes of other formats are read in a process of their own: any end of it gives one message, and
// its result is the library's result in this process.

#include "displayfile/mesh/import_process.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/work_budget.h"
#include "displayfile/mesh/format_not_read.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/import_protocol.h"
#include "displayfile/mesh/mesh.h"
#include "tests/foreign_models.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using test::bytes;

class ImportProcess : public test::MeshFiles {
 protected:
  void SetUp() override {
    if (!import_library_version()) GTEST_SKIP() << "no import library";
  }
  void TearDown() override { unsetenv("DISPLAYFILE_IMPORT_PROGRAM"); }

  /// In the place of the import program: a script that gets its arguments and descriptors.
  void put_in_its_place(const std::string& script) const {
    const std::string path = file("program", "#!/bin/sh\n" + script);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    setenv("DISPLAYFILE_IMPORT_PROGRAM", path.c_str(), 1);
  }

  /// The message with which reading a file is refused, without its path.
  static std::string refusal(const std::string& path, const ImportLimits& limits = {}) {
    try {
      read_mesh(path, false, limits);
    } catch (const Error& e) {
      const std::string message = e.what();
      EXPECT_TRUE(message.starts_with(path + ": ")) << message;
      return message.substr(path.size() + 2);
    }
    return "it was read";
  }

  static void expect_in(const std::string& words, const std::string& message) {
    EXPECT_NE(message.find(words), std::string::npos) << message << "\ndoes not say: " << words;
  }
};

std::ptrdiff_t open_descriptors() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
}

bool has_children() { return waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD; }

void expect_same(const Mesh& a, const Mesh& b, const std::string& what) {
  EXPECT_EQ(a.vertices, b.vertices) << what;
  EXPECT_EQ(a.normals, b.normals) << what;
  EXPECT_EQ(a.corners, b.corners) << what;
  EXPECT_EQ(a.first_corner, b.first_corner) << what;
  EXPECT_EQ(a.corner_normals, b.corner_normals) << what;
  EXPECT_EQ(a.materials, b.materials) << what;
  EXPECT_EQ(a.face_materials, b.face_materials) << what;
  ASSERT_EQ(a.objects.size(), b.objects.size()) << what;
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(a.objects[i].name, b.objects[i].name) << what;
    EXPECT_EQ(a.objects[i].first_face, b.objects[i].first_face) << what;
    EXPECT_EQ(a.objects[i].faces, b.objects[i].faces) << what;
  }
  EXPECT_EQ(a.upright, b.upright) << what;
  EXPECT_EQ(a.skipped.warnings, b.skipped.warnings) << what;
  EXPECT_EQ(a.skipped.points_and_lines, b.skipped.points_and_lines) << what;
  EXPECT_EQ(a.skipped.degenerate_faces, b.skipped.degenerate_faces) << what;
  EXPECT_EQ(a.skipped.textured_faces, b.skipped.textured_faces) << what;
  EXPECT_EQ(a.skipped.transparent_faces, b.skipped.transparent_faces) << what;
}

/// They count on systems where the library runs in our own process.
TEST(AllowedFormats, AreThoseWhoseReadersStoodTheMutations) {
  for (const char* path : {"a.gltf", "b/A.GLB", "x.fbx"}) {
    EXPECT_NO_THROW(require_allowed_format(path)) << path;
  }
  for (const char* path : {"a.mdl", "a.ASE", "a", "gltf", "a.gltf.lws"}) {
    try {
      require_allowed_format(path);
      ADD_FAILURE() << path;
    } catch (const Error& e) {
      EXPECT_TRUE(std::string(e.what()).starts_with(std::string(path) + ": ")) << e.what();
      EXPECT_NE(std::string(e.what()).find("--any-format"), std::string::npos) << e.what();
    }
  }
}

// ---- Meshes that are read --------------------------------------------------------------

TEST_F(ImportProcess, GivesWhatTheLibraryGivesInThisProcess) {
  file("a.bin", test::gltf_buffer());
  const std::string paths[] = {file("a.gltf", test::gltf("a.bin")),
                               file("a.ac", test::ac3d("4000000 0 0\n4000001 0 0\n4000001 1 0\n"))};
  for (const std::string& path : paths) {
    for (const bool with_normals : {false, true}) {
      const Mesh here = read_by_import_library(path, with_normals);
      EXPECT_GT(here.faces(), 0u);
      expect_same(here, read_by_import_process(path, with_normals, {}), path);
    }
  }
  EXPECT_FALSE(read_mesh(paths[0], true).corner_normals.empty()) << "or the test tests little";
  EXPECT_FALSE(read_mesh(paths[0]).materials.empty());
  EXPECT_FALSE(read_mesh(paths[1]).skipped.warnings.empty());
}

TEST_F(ImportProcess, GivesWhatTheLibraryGivesOfModels) {
  const std::filesystem::path models = "/usr/share/assimp/models";
  int read = 0;
  for (const char* name :
       {"FBX/box.fbx", "3DS/cube_with_diffuse_texture.3DS", "X/test.x",
        "Collada/cube_triangulate.dae", "BLEND/box.blend", "OpenGEX/Example.ogex", "AMF/test1.amf",
        "glTF/TwoBoxes/TwoBoxes.gltf"}) {
    const std::string path = (models / name).string();
    if (!std::filesystem::exists(path)) continue;
    ++read;
    expect_same(read_by_import_library(path, true), read_by_import_process(path, true, {}), path);
  }
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "no models in " << models;
  EXPECT_GE(read, 4);
}

TEST_F(ImportProcess, OpensTheNeighboursOfAMeshAndNothingElse) {
  namespace fs = std::filesystem;
  fs::create_directories(folder_ / "in" / "below");
  file("outside.bin", test::gltf_buffer());
  file("in/beside.bin", test::gltf_buffer());
  file("in/below/deep.bin", test::gltf_buffer());
  fs::create_symlink(folder_ / "outside.bin", folder_ / "in" / "link.bin");
  fs::create_symlink("beside.bin", folder_ / "in" / "inner.bin");
  const auto faces = [&](const std::string& buffer) {
    const std::string path = file("in/a.gltf", test::gltf(buffer));
    try {
      return static_cast<int>(read_mesh(path).faces());
    } catch (const Error& e) {
      EXPECT_TRUE(std::string(e.what()).starts_with(path)) << e.what();
      return 0;
    }
  };
  EXPECT_GT(faces("beside.bin"), 0);
  EXPECT_GT(faces("below/deep.bin"), 0);
  EXPECT_GT(faces("below/../beside.bin"), 0);
  EXPECT_GT(faces("inner.bin"), 0) << "a link to a neighbour";
  EXPECT_EQ(faces("../outside.bin"), 0);
  EXPECT_EQ(faces("link.bin"), 0) << "a link that leads out";
  EXPECT_EQ(faces((folder_ / "outside.bin").string()), 0);
  EXPECT_EQ(faces("missing.bin"), 0);
  fs::create_directories(folder_ / "links");
  file("in/a.gltf", test::gltf("beside.bin"));
  fs::create_symlink(folder_ / "in" / "a.gltf", folder_ / "links" / "b.gltf");
  file("links/beside.bin", test::gltf_buffer());
  EXPECT_GT(read_mesh((folder_ / "links" / "b.gltf").string()).faces(), 0u)
      << "the mesh itself may be a link";
}

TEST_F(ImportProcess, ReadsPathsFromTheWorkingFolderOnAndOfAnyLetters) {
  const auto before = std::filesystem::current_path();
  file("-a 'b\" é.ac", test::ac3d("0 0 0\n1 0 0\n1 1 0\n"));
  std::filesystem::current_path(folder_);
  EXPECT_GT(read_mesh("-a 'b\" é.ac").faces(), 0u);
  EXPECT_GT(read_mesh("./-a 'b\" é.ac").faces(), 0u);
  std::filesystem::current_path(before);
}

TEST_F(ImportProcess, LeavesNothingBehind) {
  const std::string path = file("a.ac", test::ac3d("0 0 0\n1 0 0\n1 1 0\n"));
  read_mesh(path);
  const auto before = open_descriptors();
  for (int i = 0; i < 3; ++i) read_mesh(path);
  refusal(file("bad.ac", "nothing\n"));
  refusal(file("crash.mdl", test::mdl_that_crashes()));
  put_in_its_place("sleep 30");
  refusal(path, {.seconds = 0.1});
  EXPECT_EQ(open_descriptors(), before);
  EXPECT_FALSE(has_children());
}

TEST_F(ImportProcess, SeveralThreadsReadAtOnce) {
  const std::string good = file("a.ac", test::ac3d("0 0 0\n1 0 0\n1 1 0\n"));
  const std::string bad = file("bad.mdl", test::mdl_that_crashes());
  const std::size_t faces = read_mesh(good).faces();
  std::vector<std::size_t> found(4);
  std::vector<std::string> said(4);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < found.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 3; ++i) {
        found[t] += read_mesh(good).faces();
        said[t] = refusal(bad);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::size_t count : found) EXPECT_EQ(count, 3 * faces);
  for (const std::string& message : said) EXPECT_EQ(message, said[0]);
}

/// An application may leave its children to the system, or wait for all of them itself.
TEST_F(ImportProcess, GoesOnWhereChildrenAreNotWaitedFor) {
  const std::string path = file("a.ac", test::ac3d("0 0 0\n1 0 0\n1 1 0\n"));
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_GT(read_mesh(path).faces(), 0u);
  expect_in("import library", refusal(file("crash.mdl", test::mdl_that_crashes())));
  std::signal(SIGCHLD, before);
}

// ---- Crashes, limits -------------------------------------------------------------------

TEST_F(ImportProcess, ACrashOfTheLibraryIsAMessage) {
  const std::string message = refusal(file("a.mdl", test::mdl_that_crashes()));
  expect_in("not a mesh that can be read: the import library (Assimp) ", message);
  if (!kWatchesResidentMemory) expect_in("crashed on it (SIGSEGV)", message);
  for (const auto& [name, number] : {std::pair("ABRT", "SIGABRT"), std::pair("FPE", "SIGFPE"),
                                     std::pair("BUS", "SIGBUS"), std::pair("ILL", "SIGILL")}) {
    put_in_its_place(fmt::format("kill -{} $$", name));
    expect_in(fmt::format("crashed on it ({})", number), refusal(file("a.ac", "AC3Db\n")));
  }
  put_in_its_place("kill -KILL $$");
  expect_in("was killed while reading it", refusal(file("a.ac", "AC3Db\n")));
  put_in_its_place("exit 7");
  expect_in("with status 7", refusal(file("a.ac", "AC3Db\n")));
}

TEST_F(ImportProcess, AHangOfTheLibraryIsAMessage) {
  const std::string path = file("a.smd", test::smd_that_hangs());
  expect_in("reached the limit of 0.5 seconds: --import-seconds", refusal(path, {.seconds = 0.5}));
  // It neither ends nor keeps its descriptors open, or prints without end. If reading waited for
  // it, or for a process that it has started, the file `ended` would be there.
  const std::filesystem::path ended = folder_ / "ended";
  const auto runs = [&](const std::string& script) {
    put_in_its_place(fmt::format(fmt::runtime(script), fmt::format(": > '{}'", ended.string())));
  };
  std::ostringstream said;
  std::streambuf* const before = std::cerr.rdbuf(said.rdbuf());
  runs("{0}; exit 7");
  refusal(path);
  EXPECT_TRUE(std::filesystem::remove(ended)) << "a script writes no file";
  for (const char* script :
       {"exec 3>&- 1>&- 2>&-; sleep 60; {0}", "while :; do echo talks; done",
        "(sleep 60; {0}) & sleep 60; {0}", "trap '' TERM INT HUP XCPU; sleep 60; {0}"}) {
    runs(script);
    EXPECT_NE(refusal(path, {.seconds = 0.3}), "it was read") << script;
    EXPECT_FALSE(std::filesystem::exists(ended)) << script;
    EXPECT_FALSE(has_children()) << script;
  }
  std::cerr.rdbuf(before);
}

/// A caller that has less time than the library, or is stopped, does not wait for it.
TEST_F(ImportProcess, TheBudgetInForceIsAskedWhileTheLibraryReads) {
  const std::string path = file("a.ac", "AC3Db\n");
  const std::filesystem::path ended = folder_ / "ended";  // there if reading waited for it
  put_in_its_place(fmt::format("sleep 50; : > '{}'", ended.string()));
  {
    WorkBudget budget({.seconds = 0.2});
    const BudgetInForce in_force(budget);
    EXPECT_THROW(read_mesh(path), LimitReached);
  }
  {
    WorkBudget budget;
    const BudgetInForce in_force(budget);
    std::thread stopper([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      budget.stop();
    });
    EXPECT_THROW(read_mesh(path), LimitReached);
    stopper.join();
  }
  EXPECT_FALSE(std::filesystem::exists(ended));
  EXPECT_FALSE(has_children());
}

TEST_F(ImportProcess, AHungerOfTheLibraryIsAMessage) {
  const std::string path = file("a.ac", test::ac3d_that_hungers());
  const std::string message = refusal(path, {.memory = std::size_t{64} << 20, .seconds = 20});
  if (kWatchesResidentMemory) {
    expect_in("import library (Assimp)", message);
  } else {
    expect_in("reached the limit of 64 MiB of memory: --import-memory", message);
  }
  put_in_its_place(fmt::format("exit {}", kOutOfMemoryStatus));
  expect_in("reached the limit of 1000 bytes", refusal(path, {.memory = 1000}));
  expect_in("reached the limit of 3 KiB", refusal(path, {.memory = 3 << 10}));
  expect_in("reached the limit of 2 GiB", refusal(path));
}

TEST_F(ImportProcess, LimitsAreMoreThanNothing) {
  const std::string path = file("a.ac", test::ac3d("0 0 0\n1 0 0\n1 1 0\n"));
  for (const ImportLimits limits :
       {ImportLimits{.memory = 0}, ImportLimits{.seconds = 0.0}, ImportLimits{.seconds = -1.0},
        ImportLimits{.seconds = std::nan("")}}) {
    expect_in("expected more than 0", refusal(path, limits));
  }
  EXPECT_GT(read_mesh(path, false, {.memory = SIZE_MAX / 2, .seconds = 1e300}).faces(), 0u);
}

// ---- The program -----------------------------------------------------------------------

TEST_F(ImportProcess, AProgramThatIsNotThereIsNamed) {
  const std::string path = file("a.ac", "AC3Db\n");
  setenv("DISPLAYFILE_IMPORT_PROGRAM", "/nowhere/displayfile-import", 1);
  const std::string message = refusal(path);
  expect_in("cannot be started: /nowhere/displayfile-import: No such file", message);
  expect_in("DISPLAYFILE_IMPORT_PROGRAM", message);
  setenv("DISPLAYFILE_IMPORT_PROGRAM", path.c_str(), 1);
  expect_in("Permission denied", refusal(path));
  put_in_its_place("exit 4");
  expect_in("a program of another build", refusal(path));
}

TEST_F(ImportProcess, WhatTheProgramGivesIsNotBelieved) {
  const std::string path = file("a.ac", "AC3Db\n");
  for (const char* script :
       {"head -c 100000 /dev/zero >&3", "head -c 100000 /dev/urandom >&3", "printf 'IDFM' >&3",
        "printf 'IDFMSH1' >&3; head -c 100000 /dev/zero >&3"}) {
    put_in_its_place(script);
    expect_in("not a mesh that can be read: ", refusal(path));
  }
}

TEST_F(ImportProcess, WhatReadersSayIsWrittenToCerrAsFarAsItIsShort) {
  const std::string path = file("a.ac", "AC3Db\n");
  put_in_its_place("echo said; echo this >&2; exit 7");
  std::ostringstream said;
  std::streambuf* const before = std::cerr.rdbuf(said.rdbuf());
  refusal(path);
  put_in_its_place("head -c 3000000 /dev/zero; exit 7");
  const std::string first = said.str();
  said.str("");
  refusal(path);
  std::cerr.rdbuf(before);
  EXPECT_EQ(first, "said\nthis\n");
  EXPECT_LE(said.str().size(), kMostOfMessage);
}

}  // namespace
}  // namespace displayfile
