// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tzc::compare {

using Environment = std::map<std::string, std::string>;

/// A child process in its own session, with its output in a file. The destructor stops it; it gets SIGTERM
/// when this program is killed.
class Child {
 public:
  enum class Input { none, pipe };

  /// @param log_file gets standard output and error; with Input::pipe only the latter
  /// @throws Failure
  Child(const std::vector<std::string>& command, const Environment& environment, std::string log_file,
        Input input = Input::none);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  pid_t pid() const { return pid_; }
  bool is_running();
  /// The exit status, 128 + signal for a signal; null while it runs.
  std::optional<int> status();
  /// Sends its whole session SIGINT, then SIGTERM, then SIGKILL, as long as it runs. Not interrupted by stop
  /// requests.
  void stop(int patience_ms = 20'000);
  bool wait(int timeout_ms);

  void write(const std::string& text);
  void close_input();
  /// What it has written to standard output since the last call; waits at most that long for something to
  /// come.
  std::string read_output(int timeout_ms);

  /// The last lines of its log.
  std::string log_tail() const;

 private:
  void run(const std::vector<std::string>& command, const Environment& environment, int input, int output);

  pid_t pid_ = -1;
  std::optional<int> status_;
  int input_ = -1, output_ = -1;
  const std::string log_file_;
};

/// Adopts orphans of this program's children, so that no process is left running.
void adopt_orphans();
/// Ends the adopted ones: all children but those that `Child` objects hold.
void kill_orphans();

}  // namespace tzc::compare
