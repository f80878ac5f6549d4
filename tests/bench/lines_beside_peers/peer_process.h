#pragma once

#include <sys/types.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace displayfile::bench {

/// A peer did not answer: it failed, ended, or took too long.
struct PeerStopped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A program that stays for many questions, so that it is warm: each question is a line that it
/// reads, each answer the next line that it prints that begins with "peer: ". What else it prints
/// is skipped, its messages go nowhere.
class PeerProcess {
 public:
  /// Starts it and waits until it says "ready". An answer may take so many seconds. Throws
  /// PeerStopped, as ask does.
  PeerProcess(std::vector<std::string> command, double limit);
  ~PeerProcess();
  PeerProcess(const PeerProcess&) = delete;
  PeerProcess& operator=(const PeerProcess&) = delete;

  /// What follows the word in the answer that begins with it.
  std::string ask(const std::string& question, const std::string& word);

 private:
  std::string answer(const std::string& word);
  std::string next_line();
  void stop();

  double limit_;
  pid_t child_ = -1;
  int to_ = -1, from_ = -1;
  std::string read_;  // but not yet looked at
};

}  // namespace displayfile::bench
