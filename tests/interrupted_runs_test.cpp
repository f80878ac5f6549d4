// The command interrupted at random moments: by signals, by a full disk, by a folder that goes away
// while it writes. Whatever happens, an output is unchanged or new and whole, and nothing else
// stays. DISPLAYFILE_INTERRUPTED_RUNS=1000 sets the number of runs.

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "tests/command_fixture.h"
#include "tests/from_environment.h"

namespace {

using Clock = std::chrono::steady_clock;
using Files = std::map<std::string, std::string>;  // contents by their names in the folder

enum class Interruption {
  interrupt,
  terminate,
  kill,
  largest_file,  // the process may write no file that is longer
  full_disk,     // the outputs' folder is on one
  folder_gone,
};
constexpr std::array kInterruptions{Interruption::interrupt, Interruption::terminate,
                                    Interruption::kill,      Interruption::largest_file,
                                    Interruption::full_disk, Interruption::folder_gone};
constexpr std::array<std::string_view, kInterruptions.size()> kNames{
    "INT", "TERM", "KILL", "largest file", "full disk", "folder gone"};

/// A small file system of its own at a folder, if this process may have one.
class SmallDisk {
 public:
  explicit SmallDisk(const fs::path& folder) : folder_(folder) {
    fs::create_directories(folder_);
    is_there_ = ::mount("none", folder_.c_str(), "tmpfs", 0, "size=16m") == 0;
  }
  ~SmallDisk() {
    if (is_there_) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool is_there() const { return is_there_; }
  const fs::path& folder() const { return folder_; }
  /// Leaves `bytes` free, by a file that is removed later.
  void leave_free(std::uintmax_t bytes) const {
    fs::remove(filler());
    const std::uintmax_t free = fs::space(folder_).available;
    file(std::string(free > bytes ? free - bytes : 0, 'x'));
  }
  fs::path filler() const { return folder_ / "filler"; }

 private:
  void file(const std::string& text) const { std::ofstream(filler(), std::ios::binary) << text; }

  fs::path folder_;
  bool is_there_ = false;
};

class InterruptedRuns : public Command {
 protected:
  /// A command line with OUT for the outputs' folder, and its outputs when it is not interrupted.
  struct Work {
    std::vector<std::string> arguments;
    Files made = {};
    std::chrono::duration<double> takes{};
  };

  void SetUp() override {
    std::string triangles =
        "set-window -1.5 1.5 -1.5 1.5\nset-window-fit widen\nset-view-depth -2 2\nset-pick-id "
        "3\nopen-segment 1\n";
    for (int k = 0; k < 120; ++k) {
      const double x = -0.9 + 0.012 * k, y = 0.8 - 0.003 * (k * 7 % 500);
      triangles += fmt::format("polygon-abs-3 {0} {1} {2}  {3} {1} 0  {0} {4} 0\n", x, y, 0.003 * k,
                               x + 0.3, y - 0.4);
    }
    for (const char* name : {"a.draw", "b.draw", "c.draw"}) {
      write(name, triangles + "close-segment\n");
    }
    std::string mesh;
    for (int k = 0; k < 600; ++k) {
      mesh += fmt::format("v {} {} {}\nv {} 0 1\nv 0 {} 1\nf -1 -2 -3\n", k, k * k % 97, k % 13,
                          k + 1, k % 7 + 1);
    }
    write("m.obj", mesh);
    const auto work = [&](std::vector<std::string> arguments) {
      works_.push_back({std::move(arguments)});
    };
    work({"draw", "a.draw", "-o", "OUT/p.png", "--size", "300x200", "--ids", "OUT/i.npy", "--depth",
          "OUT/d.npy"});
    work({"draw", "a.draw", "-o", "OUT/p.svg"});
    work({"draw", "a.draw", "-o", "OUT/p.ppm", "--hidden", "bsp", "--size", "200x200"});
    work({"draw", "a.draw", "-o", "OUT/t.png", "--turntable", "4", "--hidden", "z-buffer", "--size",
          "200x200"});
    work({"draw", "a.draw", "b.draw", "c.draw", "-o", "OUT/{name}/p.png", "--threads", "3",
          "--size", "200x200"});
    work({"dump", "a.draw", "-o", "OUT/p.txt", "--hidden", "franklin"});
    work({"import", "m.obj", "-o", "OUT/m.draw"});
    work({"export", "m.obj", "-o", "OUT/m.obj"});
    work({"truth", "a.draw", "--size", "60x60", "--ids", "OUT/i.npy", "--depth", "OUT/d.npy"});
    work({"sheet", "m.obj", "-o", "OUT/s.svg"});
  }

  fs::path out() const { return (on_small_disk_ ? disk_.folder() : folder_) / "out"; }

  Files files() const {
    Files found;
    if (!fs::exists(out())) return found;
    for (const auto& entry : fs::recursive_directory_iterator(out())) {
      const std::string name = entry.path().lexically_relative(out()).string();
      found[name] = entry.is_directory() ? "(a folder)" : read(entry.path());
    }
    return found;
  }

  /// Starts the work in the test's folder and discards its output.
  pid_t start(const Work& work, rlim_t largest_file = RLIM_INFINITY) const {
    std::vector<std::string> words{DISPLAYFILE_COMMAND};
    for (std::string word : work.arguments) {
      if (word.starts_with("OUT")) word.replace(0, 3, out().string());
      words.push_back(std::move(word));
    }
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string folder = folder_.string(), said = (folder_ / ".err").string();
    const pid_t child = ::fork();
    if (child != 0) return child;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    const int to = ::open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(to, STDOUT_FILENO);
    ::dup2(to, STDERR_FILENO);
    ::close(to);
    if (largest_file != RLIM_INFINITY) {
      const rlimit limit{largest_file, largest_file};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::execv(DISPLAYFILE_COMMAND, argv.data());
    ::_exit(127);
  }

  /// Puts old files in the places of the work's outputs, of those for which `keep` is true.
  Files put_old_files(const Work& work, std::mt19937_64& random) const {
    fs::remove_all(out());
    fs::create_directories(out());
    Files old;
    if (random() % 2 == 0) return old;
    for (const auto& [name, text] : work.made) {
      if (text == "(a folder)") {
        fs::create_directories(out() / name);
        old[name] = text;
      } else {
        const std::string before = "old " + name;
        std::ofstream(out() / name, std::ios::binary) << before;
        old[name] = before;
      }
    }
    return old;
  }

  /// Describes the error in the folder after a run; empty if there is none.
  static std::string wrong(const Files& found, const Files& old, const Work& work, bool killed) {
    int nameless = 0;
    for (const auto& [name, text] : found) {
      const auto before = old.find(name);
      const auto made = work.made.find(name);
      if (before != old.end() && text == before->second) continue;
      if (made != work.made.end() && text == made->second) continue;
      const bool is_temporary = fs::path(name).filename().string().starts_with(".");
      if (killed && is_temporary && ++nameless == 1) continue;
      const bool is_known = made != work.made.end() || before != old.end();
      return fmt::format("{}: {} of {} bytes", name,
                         is_known ? "neither old nor new," : "left over,", text.size());
    }
    for (const auto& [name, text] : old) {
      if (!found.contains(name)) return name + ": gone";
    }
    for (const auto& [name, text] : found) {  // a folder is made for its contents
      const auto is_in_it = [inside = name + "/"](const auto& other) {
        return other.first.starts_with(inside);
      };
      if (text != "(a folder)" || killed || old.contains(name)) continue;
      if (std::ranges::none_of(found, is_in_it)) return name + ": an empty folder";
    }
    return "";
  }

  /// Runs once without interruption: finds its outputs, and how long it takes.
  void measure(Work& work) const {
    fs::remove_all(out());
    fs::create_directories(out());
    const auto begin = Clock::now();
    int status = 0;
    ::waitpid(start(work), &status, 0);
    work.takes = Clock::now() - begin;
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
        << work.arguments[0] << read(folder_ / ".err");
    work.made = files();
    ASSERT_FALSE(work.made.empty());
  }

  std::vector<Work> works_;
  SmallDisk disk_{folder_ / "disk"};
  bool on_small_disk_ = false;
};

TEST_F(InterruptedRuns, LeaveOutputsOldOrWhole) {
  const int runs = displayfile::test::from_environment("DISPLAYFILE_INTERRUPTED_RUNS", 54);
  std::mt19937_64 random(20);
  std::array<std::array<int, 4>, kInterruptions.size()> counts{};  // runs, stopped, failed, left
  for (Work& work : works_) {
    measure(work);
    ASSERT_FALSE(HasFatalFailure());
  }
  for (int run = 0; run < runs; ++run) {
    const auto kind = static_cast<std::size_t>(run) % kInterruptions.size();
    const Interruption how = kInterruptions[kind];
    const Work& work = works_[random() % works_.size()];
    on_small_disk_ = how == Interruption::full_disk;
    if (on_small_disk_ && !disk_.is_there()) continue;
    const Files old = put_old_files(work, random);
    std::uintmax_t all = 0, longest = 1;
    for (const auto& [name, text] : work.made) {
      all += text.size() + 4096;
      longest = std::max<std::uintmax_t>(longest, text.size());
    }
    if (on_small_disk_) disk_.leave_free(random() % all);
    const pid_t child =
        start(work, how == Interruption::largest_file ? random() % longest : RLIM_INFINITY);
    const double part = static_cast<double>(random() % 1000) / 1000.0;
    const bool is_timed = how != Interruption::largest_file && how != Interruption::full_disk;
    if (is_timed) std::this_thread::sleep_for(1.05 * part * work.takes);
    switch (how) {
      case Interruption::interrupt: ::kill(child, SIGINT); break;
      case Interruption::terminate: ::kill(child, SIGTERM); break;
      case Interruption::kill: ::kill(child, SIGKILL); break;
      case Interruption::folder_gone: fs::rename(out(), out().string() + "-gone"); break;
      default: break;
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    const std::string what = fmt::format("run {}, {} after {:.3f} of {} {}", run, kNames[kind],
                                         part, work.arguments[0], work.arguments.back());
    fs::remove(disk_.filler());
    Files found = files();
    if (how == Interruption::folder_gone) {
      const bool makes_folders =
          work.arguments.size() > 5 && work.arguments[5] == "OUT/{name}/p.png";
      EXPECT_TRUE(found.empty() || makes_folders) << what;
      fs::remove_all(out());
      fs::rename(out().string() + "-gone", out());
      found = files();
    }
    EXPECT_EQ(wrong(found, old, work, how == Interruption::kill), "") << what;
    ++counts[kind][0];
    if (WIFSIGNALED(status)) {
      ++counts[kind][1];
      EXPECT_TRUE(how == Interruption::interrupt   ? WTERMSIG(status) == SIGINT
                  : how == Interruption::terminate ? WTERMSIG(status) == SIGTERM
                                                   : how == Interruption::kill)
          << what << ", by signal " << WTERMSIG(status);
    } else {
      const std::string said = read(folder_ / ".err");
      EXPECT_TRUE(WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 2) << what << said;
      if (WEXITSTATUS(status) == 2) {
        ++counts[kind][2];
        EXPECT_TRUE(said.starts_with("displayfile: ")) << what << said;
        EXPECT_TRUE(!is_timed || how == Interruption::folder_gone) << what << said;
      }
    }
    for (const auto& [name, text] : found)
      counts[kind][3] += fs::path(name).filename().string()[0] == '.';
  }
  for (std::size_t kind = 0; kind < kInterruptions.size(); ++kind) {
    const auto& [all, stopped, failed, left] = counts[kind];
    std::cout << fmt::format("{:12}  {} runs: {} stopped, {} failed, {} temporary files left\n",
                             kNames[kind], all, stopped, failed, left);
  }
}

}  // namespace
