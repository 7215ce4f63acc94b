// SPDX-License-Identifier: BSD-3-Clause
#include "segment/fork_copies.h"

#include <pthread.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <vector>

#include "posix/packet.h"
#include "posix/socket.h"
#include "segment/registry.h"

namespace tzc {
namespace segment {
namespace {

/// Only a child that is stopped, or has no memory to run in, takes longer than its copies do.
constexpr std::chrono::milliseconds longest_wait{5000};

struct Forks {
  std::mutex mutex;  // a fork has it from its beginning until its child is done
  std::vector<ForkCopied*> copied;
  bool held = false;
  posix::SocketPair report;  // the child's end is `theirs`
};

Forks& forks();

void before_fork() {
  Forks& all = forks();
  all.mutex.lock();
  for (ForkCopied* const one : all.copied) all.held = one->hold_for_child() || all.held;
  if (all.held) all.report = posix::make_brief_socket_pair();
}

/// Until it has its copies, or cannot have them, or is gone: the end of the connection is seen then, too. Without descriptors nothing is
/// known.
void wait_for_child(posix::SocketPair& report) {
  report.theirs.reset();
  if (report.ours) (void)posix::wait_readable(report.ours.get(), longest_wait);
}

// Also when the fork has failed, whose errno must be seen.
void in_parent() {
  const int saved = errno;
  Forks& all = forks();
  if (all.held) {
    wait_for_child(all.report);
    for (ForkCopied* const one : all.copied) one->release_for_child();
  }
  all.report = posix::SocketPair();
  all.held = false;
  all.mutex.unlock();
  errno = saved;
}

// What it inherited needs nothing more when it forks itself.
void in_child() {
  Forks& all = forks();
  if (all.held) {
    for (ForkCopied* const one : all.copied) one->copy_in_child();
    if (all.report.theirs) posix::send_packet(all.report.theirs.get(), "", 1);
  }
  all.report = posix::SocketPair();
  all.held = false;
  all.copied.clear();
  all.mutex.unlock();
}

// The registry's handlers come first, so the parent does not have its lock while it waits.
Forks* watch_forks() {
  registry();
  ::pthread_atfork(before_fork, in_parent, in_child);
  return new Forks;
}

/// Never destroyed: messages may outlive static destruction.
Forks& forks() {
  static Forks* const one = watch_forks();
  return *one;
}

}  // namespace

void copy_at_forks(ForkCopied& copied) {
  Forks& all = forks();
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.copied.push_back(&copied);
}

void forget_at_forks(ForkCopied& copied) noexcept {
  Forks& all = forks();
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.copied.erase(std::remove(all.copied.begin(), all.copied.end(), &copied), all.copied.end());
}

}  // namespace segment
}  // namespace tzc
