#pragma once

#include <string>
#include <vector>

namespace displayfile::bench {

/// A process to be started.
struct Process {
  enum class Output { kept, ours };
  enum class Messages { ours, nowhere, with_output };

  /// The program is found on the path unless its name has a slash.
  std::vector<std::string> command;
  Output output = Output::kept;
  Messages messages = Messages::ours;
  /// NAME=VALUE: these are in its environment, in place of ours of the same name, or all there is.
  std::vector<std::string> variables = {};
  bool variables_alone = false;
};

/// The cost of a whole process. The memory is at least this program's own, which is small.
struct Cost {
  double wall, processor;  // seconds
  double peak_memory;      // bytes
};

/// The result of a process.
struct Finished {
  bool started;
  bool succeeded;      ///< it ended with status 0
  std::string output;  ///< the part of its output that was kept
  Cost cost;
};

/// Runs it and waits for it. Throws Error if there can be no pipe.
Finished run(Process process);

/// The same for a program whose messages are discarded.
inline Finished run(const std::vector<std::string>& command) {
  return run(Process{.command = command, .messages = Process::Messages::nowhere});
}

/// The cost of a command, with our output as its own. Throws Error unless it ends with status 0.
Cost cost_of(const std::vector<std::string>& command);

}  // namespace displayfile::bench
