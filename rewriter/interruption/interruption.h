// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <functional>
#include <string>

#include <sys/types.h>

namespace tzc::rewriter {

/// From now on SIGINT, SIGTERM and SIGHUP end what the process has started, remove its temporary folders, say `message` on
/// standard error, and end the process as they would have. One that is ignored (nohup) stays so. Call it once, before the
/// process has other threads: they must not take these signals.
void handle_interruptions(const std::string& message);

/// Removes a folder when the process is interrupted; otherwise its owner does. Thread-safe.
class RemovedWhenInterrupted {
 public:
  explicit RemovedWhenInterrupted(std::string folder);
  RemovedWhenInterrupted(RemovedWhenInterrupted&& other) noexcept : folder_(std::move(other.folder_)) {
    other.folder_.clear();
  }
  RemovedWhenInterrupted& operator=(RemovedWhenInterrupted&&) = delete;
  /// Waits for ever when an interruption has begun: the process ends.
  ~RemovedWhenInterrupted();

  const std::string& folder() const { return folder_; }

 private:
  std::string folder_;
};

/// A child process that gets SIGTERM when this one is interrupted: only a terminal signals both. Thread-safe.
class EndedWhenInterrupted {
 public:
  /// @param start starts it; negative: it could not. No interruption begins meanwhile.
  explicit EndedWhenInterrupted(const std::function<pid_t()>& start);
  EndedWhenInterrupted(const EndedWhenInterrupted&) = delete;
  EndedWhenInterrupted& operator=(const EndedWhenInterrupted&) = delete;
  ~EndedWhenInterrupted();

  pid_t pid() const { return child_; }

 private:
  pid_t child_;
};

/// Puts an interruption off while it lives, with or without handle_interruptions().
class InterruptionDelay {
 public:
  InterruptionDelay();
  InterruptionDelay(const InterruptionDelay&) = delete;
  InterruptionDelay& operator=(const InterruptionDelay&) = delete;
  ~InterruptionDelay();

 private:
  sigset_t before_;
};

/// The signal mask that a child process is to begin with.
sigset_t mask_for_children();

/// The signals that a child process is to take as by default.
sigset_t defaults_for_children();

}  // namespace tzc::rewriter
