// A system that several threads call, and one that another thread stops.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "interp/c/displayfile_c.h"

namespace {

class CThreads : public testing::Test {
 protected:
  ~CThreads() override { df_destroy(system_); }

  /// Enters `triangles` triangles that pass through each other.
  void enter(int triangles) {
    std::string program = "set-view-depth -2 2\nopen-segment 1\n";
    std::uint32_t state = 1;
    const auto number = [&] {
      state = state * 1664525u + 1013904223u;
      return " " + std::to_string((state >> 8) / 16777216.0 * 1.8 - 0.9);
    };
    for (int k = 0; k < triangles; ++k) {
      program += "polygon-abs-3";
      for (int i = 0; i < 9; ++i) program += number();
      program += '\n';
    }
    program += "close-segment\n";
    ASSERT_EQ(df_replay(system_, program.data(), program.size(), "planes"), DF_OK);
  }

  df_system* const system_ = df_create();
};

TEST_F(CThreads, ThreadsThatCallAtOnceAreBusyOrServed) {
  enter(20);
  std::atomic<int> served = 0, busy = 0, other = 0, told = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      df_options options = DF_OPTIONS_INIT;
      options.width = options.height = 32;
      std::vector<std::uint8_t> rgba(4 * 32 * 32);
      for (int k = 0; k < 50; ++k) {
        const int result = df_draw(system_, &options, 32 * 32, rgba.data(), nullptr, nullptr);
        ++(result == DF_OK ? served : result == DF_BUSY ? busy : other);
        if (result == DF_BUSY) told += std::string(df_error(system_)).starts_with("busy: ") ? 1 : 0;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(served + busy, 200);
  EXPECT_GT(served, 0);
  EXPECT_EQ(other, 0);
  EXPECT_EQ(told, busy);
}

TEST_F(CThreads, WhoIsRefusedIsToldUntilTheNextCall) {
  enter(300);
  const char* text = nullptr;
  std::size_t length = 0;
  std::atomic<bool> refused = false;
  std::thread other([&] {
    df_options options = DF_OPTIONS_INIT;
    options.method = "bsp";
    df_pieces pieces{};
    pieces.size = sizeof pieces;
    while (!refused) df_drawn_pieces(system_, &options, &pieces);
    EXPECT_EQ(df_call(system_, "no-such-routine", nullptr), DF_ERROR);
    EXPECT_NE(std::string(df_error(system_)).find("no-such-routine"), std::string::npos);
  });
  while (df_dump(system_, &text, &length) != DF_BUSY) std::this_thread::yield();
  const char* const message = df_error(system_);
  EXPECT_EQ(std::string(message), "busy: another thread's call on the system is in progress");
  refused = true;
  df_stop(system_);
  other.join();
  EXPECT_EQ(df_error(system_), message);
  EXPECT_EQ(df_dump(system_, &text, &length), DF_OK);
  EXPECT_EQ(std::string(df_error(system_)), "");
}

TEST_F(CThreads, ThreadsMayStopACall) {
  enter(300);
  df_options options = DF_OPTIONS_INIT;
  options.method = "bsp";
  std::atomic<bool> ended = false;
  std::thread stopper([&] {
    while (!ended) {
      df_stop(system_);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  df_pieces pieces{};
  pieces.size = sizeof pieces;
  EXPECT_EQ(df_drawn_pieces(system_, &options, &pieces), DF_ERROR);
  ended = true;
  stopper.join();
  EXPECT_NE(std::string(df_error(system_)).find("stopped on request"), std::string::npos)
      << df_error(system_);
  options.most_seconds = 1e-3;
  EXPECT_EQ(df_drawn_pieces(system_, &options, &pieces), DF_ERROR);
  EXPECT_NE(std::string(df_error(system_)).find("seconds are not enough"), std::string::npos);
  options.most_seconds = 0.0;
  options.most_pieces = 400;
  EXPECT_EQ(df_drawn_pieces(system_, &options, &pieces), DF_ERROR);
  EXPECT_NE(std::string(df_error(system_)).find("pieces"), std::string::npos);
}

}  // namespace
