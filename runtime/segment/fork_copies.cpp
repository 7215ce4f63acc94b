// SPDX-License-Identifier: BSD-3-Clause
#include "segment/fork_copies.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>
#include <utility>
#include <vector>

#include "posix/packet.h"
#include "posix/socket.h"
#include "segment/registry.h"

namespace tzc {
namespace segment {
namespace {

/// Only a child that is stopped, or has no memory to run in, takes longer than its copies do.
constexpr std::chrono::milliseconds longest_wait{5000};

// What the child reports: a byte.
constexpr char has_copies = 'c', lacks_copies = 'l';

/// Why a child may lack copies.
struct Cause {
  const char* text;
  bool said = false;
};

struct Forks {
  std::mutex mutex;  // a fork has it from its beginning until its child is done
  std::vector<ForkCopied*> copied;
  bool held = false;
  posix::SocketPair report;  // the child's end is `theirs`
  Cause no_memory{"the system refuses it the memory for copies"};
  Cause no_time{"it has been stopped, or had no memory to run in, for five seconds"};
  Cause no_descriptors{"this process has no descriptors left to wait for its copies"};
};

Forks& forks();

void before_fork() {
  Forks& all = forks();
  all.mutex.lock();
  for (ForkCopied* const one : all.copied) all.held = one->hold_for_child() || all.held;
  if (all.held) all.report = posix::make_brief_socket_pair();
}

// Neither memory nor locks: other threads go on, and may have those of a log.
void say(Cause& cause) {
  if (std::exchange(cause.said, true)) return;
  constexpr char begin[] =
      "TZC: a forked child may see later messages in place of those that this process held at the fork: ";
  constexpr char end[] = ". Copy what it needs before the fork\n";
  char line[sizeof begin + sizeof end + 128];
  char* at = line;
  for (const char* const part : {begin, cause.text, end}) {
    const std::size_t size = std::strlen(part);
    at = static_cast<char*>(std::memcpy(at, part, size)) + size;
  }
  (void)!::write(STDERR_FILENO, line, static_cast<std::size_t>(at - line));
}

/// Until it has its copies, or cannot have them, or is gone: the end of the connection is seen then, too. Without descriptors nothing is
/// known.
void wait_for_child(Forks& all) {
  posix::SocketPair& report = all.report;
  report.theirs.reset();
  if (!report.ours) return say(all.no_descriptors);
  if (!posix::wait_readable(report.ours.get(), longest_wait)) return say(all.no_time);
  char outcome = has_copies;
  posix::ReceivedPacket packet;
  posix::receive_packet(report.ours.get(), &outcome, sizeof outcome, posix::Waiting::return_at_once, false,
                        packet);
  if (outcome == lacks_copies) say(all.no_memory);
}

// Also when the fork has failed, whose errno must be seen.
void in_parent() {
  const int saved = errno;
  Forks& all = forks();
  if (all.held) {
    wait_for_child(all);
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
    bool complete = true;
    for (ForkCopied* const one : all.copied) complete = one->copy_in_child() && complete;
    if (all.report.theirs)
      posix::send_packet(all.report.theirs.get(), complete ? &has_copies : &lacks_copies, 1);
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
