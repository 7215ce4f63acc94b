// SPDX-License-Identifier: BSD-3-Clause
#include "interruption/interruption.h"

#include <pthread.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <mutex>
#include <set>
#include <thread>

namespace tzc::rewriter {
namespace {

/// What an interruption ends. Under its mutex, which an interruption never gives back.
struct Temporary {
  std::mutex mutex;
  std::set<std::string> folders;
  std::set<pid_t> children;
};

Temporary& temporary() {
  static auto* const instance = new Temporary;  // outlives static objects: the thread that waits does
  return *instance;
}

bool is_ignored(int signal) {
  struct sigaction action{};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// The signals that interrupt this process.
sigset_t interruptions() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(signal)) sigaddset(&set, signal);
  return set;
}

void remove_folders(const std::set<std::string>& folders) {
  std::error_code ignored;
  for (const std::string& folder : folders) std::filesystem::remove_all(folder, ignored);
}

void wait_for_interruption(const std::string& message) {
  const sigset_t set = interruptions();
  int signal = 0;
  if (sigwait(&set, &signal) != 0) return;
  Temporary& all = temporary();
  all.mutex.lock();
  for (const pid_t child : all.children) ::kill(child, SIGTERM);
  remove_folders(all.folders);
  std::cerr << (::isatty(STDERR_FILENO) != 0 ? "\n" : "") << message << std::endl;
  ::signal(signal, SIG_DFL);
  ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  ::raise(signal);
}

}  // namespace

void handle_interruptions(const std::string& message) {
  const sigset_t set = interruptions();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::thread(wait_for_interruption, message).detach();
}

RemovedWhenInterrupted::RemovedWhenInterrupted(std::string folder) : folder_(std::move(folder)) {
  const std::lock_guard<std::mutex> lock(temporary().mutex);
  temporary().folders.insert(folder_);
}
RemovedWhenInterrupted::~RemovedWhenInterrupted() {
  if (folder_.empty()) return;
  const std::lock_guard<std::mutex> lock(temporary().mutex);
  temporary().folders.erase(folder_);
}

EndedWhenInterrupted::EndedWhenInterrupted(const std::function<pid_t()>& start) {
  const std::lock_guard<std::mutex> lock(temporary().mutex);
  child_ = start();
  if (child_ > 0) temporary().children.insert(child_);
}
EndedWhenInterrupted::~EndedWhenInterrupted() {
  const std::lock_guard<std::mutex> lock(temporary().mutex);
  temporary().children.erase(child_);
}

InterruptionDelay::InterruptionDelay() {
  const sigset_t set = interruptions();
  ::pthread_sigmask(SIG_BLOCK, &set, &before_);
  temporary().mutex.lock();
}
InterruptionDelay::~InterruptionDelay() {
  temporary().mutex.unlock();
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

sigset_t mask_for_children() {
  sigset_t mask;
  ::pthread_sigmask(SIG_SETMASK, nullptr, &mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigdelset(&mask, signal);
  return mask;
}

sigset_t defaults_for_children() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGPIPE);
  return set;
}

}  // namespace tzc::rewriter
