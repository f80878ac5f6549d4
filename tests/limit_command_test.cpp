// The command at its limits of pieces, seconds and memory: one message, exit status 2, and outputs
// as they were.

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "tests/command_fixture.h"

namespace {

class Limits : public Command {
 protected:
  void SetUp() override {
    std::string triangles = "set-view-depth -2 2\nopen-segment 1\n";
    for (int k = 0; k < 200; ++k) {
      const double u = 0.6 * k / 200, v = (k * 7 % 200) / 200.0;
      triangles +=
          fmt::format("polygon-abs-3 -0.9 {:.4f} {:.4f}  0.9 {:.4f} {:.4f}  {:.4f} 0.9 {:.4f}\n",
                      u - 0.5, v - 0.5, 0.4 - u, 0.5 - 0.4 * v, u - 0.2, 0.5 - v);
    }
    write("t.draw", triangles + "close-segment\n");
    write("old.svg", "old");
  }
};

TEST_F(Limits, PiecesOfEveryMethodThatHasThem) {
  expect_error("draw t.draw -o old.svg --hidden bsp --limit-pieces 1000",
               "into more than 1000 pieces: expected hidden-surface method map");
  expect_error("draw t.draw -o old.svg --hidden depth-sort --limit-pieces 1000",
               "expected hidden-surface method map");
  for (const char* method : {"map", "roberts", "appel", "franklin"}) {
    expect_error(
        fmt::format("draw t.draw -o old.svg --hidden {} --limit-pieces 10 --lines all", method),
        "pieces are not enough: expected a higher limit of pieces, or ");
  }
  EXPECT_EQ(read(folder_ / "old.svg"), "old");
  expect_error("dump t.draw -o d.txt --hidden map --limit-pieces 10", "10 pieces are not enough");
  EXPECT_EQ(run("draw t.draw -o old.svg --hidden franklin --limit-pieces 20000000"), 0) << err_;
}

TEST_F(Limits, SecondsOfEveryCommand) {
  for (const char* line : {
           "draw t.draw -o old.svg --hidden bsp",
           "draw t.draw -o old.svg --hidden roberts",
           "draw t.draw -o p.png --size 9000x9000 --samples 3 --hidden warnock",
           "draw t.draw -o p.png --turntable 500 --size 900x900 --hidden z-buffer",
           "dump t.draw --hidden bsp -o d.txt",
           "truth t.draw --size 2000x2000 --ids i.npy",
       }) {
    expect_error(fmt::format("{} --limit-seconds 0.004", line), "0.004 seconds are not enough");
  }
  EXPECT_EQ(read(folder_ / "old.svg"), "old");
  EXPECT_EQ(run("draw t.draw -o p.png --limit-seconds 1000"), 0) << err_;
}

TEST_F(Limits, MemoryIsKnownBeforeOrRunsOut) {
  expect_error("truth t.draw --size 20000x20000 --ids i.npy --limit-memory 2G",
               "out of memory: the truth of 20000 x 20000 pixels needs at least 6800000000 bytes, "
               "and the limit is 2147483648");
  // Memory of libraries, or of tables that are not counted, meets the system's limit.
  expect_error("draw t.draw -o old.svg --hidden bsp --limit-memory 34M --limit-pieces 4000000000",
               "bytes are not enough: expected a higher limit of memory, or ");
  EXPECT_NE(err_.find("hidden-surface method map"), err_.npos) << err_;
  EXPECT_EQ(read(folder_ / "old.svg"), "old");
  expect_error("draw t.draw -o p.png --limit-memory 1k", "1024 bytes of memory are not enough");
  EXPECT_EQ(run("draw t.draw -o p.png --limit-memory 0.5G"), 0) << err_;
}

/// Where fewer samples a pixel would fit, the message says so.
TEST_F(Limits, MemoryOfSamples) {
  const auto draws = [](const std::string& method, int samples, const char* limit) {
    return fmt::format(
        "draw t.draw -o p.png --size 4000x4000 --hidden {} --samples {} "
        "--limit-memory {}",
        method, samples, limit);
  };
  expect_error(draws("plain-z-buffer", 4, "1G"), "p.png of 4000 x 4000 needs at least 2048");
  EXPECT_NE(err_.find(" bytes with 4 x 4 samples a pixel, and the limit is 1073741824: expected "
                      "fewer, such as --samples 1"),
            err_.npos)
      << err_;
  EXPECT_EQ(run(draws("plain-z-buffer", 1, "1G")), 0) << err_;
}

/// A picture collected in memory before it is written is whole, or nothing is written.
TEST_F(Limits, NoMemoryCutsAPictureShort) {
  std::string texts = "open-segment 1\nmove-abs-3 0 0 0\n";
  for (int k = 0; k < 60; ++k) texts += "text \"" + std::string(65000, '&') + "\"\n";
  write("texts.draw", texts + "close-segment\n");
  ASSERT_EQ(run("draw texts.draw -o whole.svg --paper A4"), 0) << err_;
  const std::string whole = read(folder_ / "whole.svg");
  std::size_t drawn = 0;
  for (const char* limit : {"40M", "60M", "80M", "100M", "1G"}) {
    const std::string line =
        fmt::format("draw texts.draw -o old.svg --paper A4 --threads 1 --limit-memory {}", limit);
    if (run(line) == 0) {
      EXPECT_TRUE(read(folder_ / "old.svg") == whole) << limit;
      write("old.svg", "old");
      ++drawn;
    } else {
      EXPECT_NE(err_.find("out of memory"), err_.npos) << err_;
      EXPECT_EQ(read(folder_ / "old.svg"), "old");
    }
  }
  EXPECT_TRUE(drawn > 0 && drawn < 5) << drawn;
}

/// Cairo is out of memory in its own words.
TEST_F(Limits, MemoryOfPdf) {
  if (!can_run("draw t.draw -o p.pdf", "need Cairo, which this build was made without")) {
    GTEST_SKIP() << err_;
  }
  std::string lines = "open-segment 1\n";
  for (int k = 0; k < 100000; ++k) {
    lines += fmt::format("polygon-abs-3 0 0.{:05} 0  1 0 0  0 1 0\n", k);
  }
  write("many.draw", lines + "close-segment\n");
  expect_error("draw many.draw -o p.pdf --hidden none --threads 1 --limit-memory 120M",
               "bytes are not enough: expected a higher limit of memory");
}

TEST_F(Limits, WordsThatAreNone) {
  for (const char* word : {"x", "-1", "0", "1T", "1MM", "nan", "inf", "1e300", "''"}) {
    expect_error(fmt::format("draw t.draw -o p.png --limit-memory {}", word), "--limit-memory");
  }
  for (const char* word : {"x", "0", "-1", "1e9", "nan", "inf", "''"}) {
    expect_error(fmt::format("draw t.draw -o p.png --limit-seconds {}", word), "--limit-seconds");
    expect_error(fmt::format("draw t.draw -o p.png --limit-pieces {}",
                             word == std::string("1e9") ? "5e9" : word),
                 "--limit-pieces");
  }
  expect_error("draw t.draw -o p.png --limit-pieces 1e3",
               "--limit-pieces: 1e3: expected a whole number, 1 to 4000000000");
}

/// The wait for names from a pipe ends at the limit, whatever the parent process has done with the
/// timer's signal.
TEST_F(Limits, OfListsOfInputs) {
  const std::string pipe = file("pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int kept_open = ::open(pipe.c_str(), O_RDWR);
  ASSERT_GE(kept_open, 0);
  sigset_t alarm, before;
  ::sigemptyset(&alarm);
  ::sigaddset(&alarm, SIGALRM);
  before_ = "timeout 20 ";
  for (const int how : {SIG_UNBLOCK, SIG_BLOCK}) {
    ::pthread_sigmask(how, &alarm, &before);
    expect_error("draw @- -o '{name}.png' --limit-seconds 0.2", "0.2 seconds are not enough",
                 "pipe");
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  ::close(kept_open);
  std::string names;
  for (int k = 0; k < 4'000'000; ++k) names += "mesh.obj\n";
  write("names.txt", names);
  expect_error("draw @names.txt -o '{name}.png' --limit-memory 60M",
               "out of memory (the limit is 62914560 bytes)");
}

/// Each of several inputs that is not drawn in time is named.
TEST_F(Limits, OfManyInputs) {
  write("u.draw", kTriangle);
  EXPECT_EQ(run("draw u.draw t.draw -o '{name}.svg' --hidden bsp --limit-pieces 1000"), 2);
  EXPECT_TRUE(fs::exists(folder_ / "u.svg"));
  EXPECT_FALSE(fs::exists(folder_ / "t.svg"));
  EXPECT_NE(err_.find("1 of 2 inputs not drawn"), err_.npos) << err_;
}

/// That of a mesh in a file of ours.
TEST_F(Limits, MemoryOfAMesh) {
  std::string mesh;
  for (int k = 0; k < 400'000; ++k) mesh += fmt::format("v {} {} 0.5\n", k % 3, k % 2);
  write("large.obj", mesh + "f 1 2 3\n");
  expect_error("draw large.obj -o p.png --limit-memory 20M",
               "large.obj: out of memory (the limit is 20971520 bytes)");
}

}  // namespace
