// SPDX-License-Identifier: BSD-3-Clause
// When the system has no more to give: an error that says so, nothing lost silently, and recovery afterwards.
// Each test runs in a child process of its own, whose limits it may ruin.
#include <fcntl.h>
#include <malloc.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

constexpr int skipped = 77;

#define EXPECT_IN_CHILD(condition)                                                 \
  if (!(condition)) {                                                              \
    std::fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition); \
    return 1;                                                                      \
  }

void limit(int resource, rlim_t value) {
  rlimit both{};
  ::getrlimit(static_cast<__rlimit_resource>(resource), &both);
  both.rlim_cur = value;
  ::setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

bool mentions(const std::string& text, const char* what) {
  return text.find(what) != std::string::npos;
}

int publisher_without_descriptors() {
  const auto out = publisher();
  std::vector<std::shared_ptr<Subscriber>> some;
  some.push_back(idle_subscriber(out->address()));
  SubscriberOptions late;
  late.address = out->address();
  late.own_thread = false;
  limit(RLIMIT_NOFILE, 0);  // what is open stays open
  const auto refused = Subscriber::create(late);
  EXPECT_IN_CHILD(!refused && mentions(refused.error().text(), "too many open files"));
  PublisherOptions elsewhere;
  elsewhere.address = "@tzc-exhaustion-elsewhere-" + std::to_string(::getpid());
  EXPECT_IN_CHILD(!Publisher::create(elsewhere));
  EXPECT_IN_CHILD(Publisher::create({}));  // its socket is there
  EXPECT_IN_CHILD(!SegmentMemory::create(MemoryOptions{mb}));
  EXPECT_IN_CHILD(out->publish(text_record("no memory needed")) == 1);
  // The subscriber cannot be offered a segment now: the caller learns it and may send the message without
  // memory.
  const ConnectionPtr connection = out->connections()[0];
  EXPECT_IN_CHILD(!connection->send(text_record("x", {filled(*out->memory(), 1000, 1)})));
  EXPECT_IN_CHILD(connection->alive() && mentions(connection->last_failure().text(), "too many open files"));
  limit(RLIMIT_NOFILE, 1000);
  EXPECT_IN_CHILD(connection->send(text_record("y", {filled(*out->memory(), 1000, 2)})));
  EXPECT_IN_CHILD(Subscriber::create(late));
  EXPECT_IN_CHILD(control_of(some[0]->read()) == "no memory needed");
  EXPECT_IN_CHILD(control_of(some[0]->read()) == "y");
  return 0;
}

int accepting_without_descriptors() {
  PublisherOptions options;
  options.address = "@tzc-exhaustion-" + std::to_string(::getpid());
  int go[2];
  if (::pipe(go) != 0) return 1;
  const pid_t child = in_child([&] {
    char byte = 0;
    (void)!::read(go[0], &byte, 1);
    SubscriberOptions in;
    in.address = options.address;
    in.own_thread = false;
    return Subscriber::create(in) ? 0 : 1;  // waits in the backlog until it has space
  });
  const auto out = publish_with(options);
  limit(RLIMIT_NOFILE, 0);  // what is open stays open
  (void)!::write(go[1], "x", 1);
  EXPECT_IN_CHILD(eventually([&] { return out->stats().accept_failures > 0; }));
  limit(RLIMIT_NOFILE, 1000);
  return exit_status(child);
}

double cpu_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + time.tv_usec / 1e6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// The kernel counts the descriptors that a user (not root) has in flight against the limit on open ones. Each
// of these records lies in a segment of its own, whose two descriptors are in flight to eight subscribers
// that do not read. No other process has this user, because the limit counts what all of its processes have in flight.
int too_many_descriptors_in_flight() {
  const auto user = static_cast<uid_t>(20'000 + ::getpid() % 40'000);
  if (::setresuid(user, user, user) != 0 || ::prctl(PR_SET_DUMPABLE, 1) != 0) return skipped;
  const auto out = publisher();
  std::vector<std::shared_ptr<Subscriber>> idle;
  for (int i = 0; i < 8; ++i) idle.push_back(idle_subscriber(out->address()));
  std::vector<BufferPtr> buffers;
  for (unsigned char i = 0; i < 6; ++i)
    buffers.push_back(filled(**SegmentMemory::create(MemoryOptions{mb}), 1000, i));
  limit(RLIMIT_NOFILE, 76);  // more than are open, fewer than these 96
  const double before = cpu_seconds();
  for (const BufferPtr& buffer : buffers) EXPECT_IN_CHILD(out->publish(text_record("x", {buffer})) == 8);
  EXPECT_IN_CHILD(out->connections()[0]->stats().queued > 0);
  ::usleep(400'000);
  EXPECT_IN_CHILD(cpu_seconds() - before < 0.1);  // the service thread waits, it does not try all the time
  for (const auto& subscriber : idle) {
    for (std::size_t i = 0; i < buffers.size(); ++i)
      EXPECT_IN_CHILD(eventually([&] {
        const MessagePtr message = subscriber->read();
        return message && control_of(message) == "x";
      }));
  }
  return 0;
}

// The heap of all threads has room from now on without a further mapping. A thread's own arena would be one, and
// without it malloc() has nothing for that thread.
void give_heap_room() {
  ::mallopt(M_ARENA_MAX, 1);
  ::mallopt(M_TRIM_THRESHOLD, 8 * mb);
  ::mallopt(M_TOP_PAD, 4 * mb);
  while (::mallinfo2().keepcost < mb) (void)!std::malloc(100'000);
}

int subscriber_that_cannot_map() {
  give_heap_room();
  const auto out = publisher(10, 64 * mb);
  Inbox in(out->address());
  limit(RLIMIT_AS, 1);  // no new mapping succeeds
  const BufferPtr small = out->memory()->allocate(1000);
  out->publish(text_record("x", {small}));
  // The side that could not map it says so: the subscriber by leaving, the publisher by refusing to send.
  const bool told = eventually(
      [&] { return !in.reason().empty() || !out->connections()[0]->last_failure().text().empty(); });
  limit(RLIMIT_AS, RLIM_INFINITY);
  EXPECT_IN_CHILD(told);
  Inbox again(out->address());
  out->publish(text_record("y", {filled(*out->memory(), 1000, 1)}));
  EXPECT_IN_CHILD(again.wait_for(1));
  return 0;
}

/// This process alone in a control group of its own (version 1 or 2) with a limit; false: not permitted here.
class LimitedGroup {
 public:
  explicit LimitedGroup(std::size_t bytes) {
    for (const char* mount : {"/sys/fs/cgroup/memory", "/sys/fs/cgroup"}) {
      folder_ = mount + ("/tzc-test-" + std::to_string(::getpid()));
      if (::mkdir(folder_.c_str(), 0755) != 0) continue;
      joined_ = set_limit(bytes) && write("cgroup.procs", "0");
      if (joined_) return;
      ::rmdir(folder_.c_str());
    }
  }
  explicit operator bool() const { return joined_; }
  bool set_limit(std::size_t bytes) const {
    return write("memory.max", std::to_string(bytes)) ||
           write("memory.limit_in_bytes", std::to_string(bytes));
  }

 private:
  bool write(const char* name, const std::string& text) const {
    const int fd = ::open((folder_ + "/" + name).c_str(), O_WRONLY);
    const bool written =
        fd >= 0 && ::write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    if (fd >= 0) ::close(fd);
    return written;
  }

  std::string folder_;
  bool joined_ = false;
};

// The kernel would kill the process instead of refusing the memory.
int memory_limit() {
  const LimitedGroup group(64 * mb);
  if (!group) return skipped;
  const auto out = publisher(10, 256 * mb);
  Inbox in(out->address());
  std::vector<BufferPtr> held;
  while (BufferPtr buffer = filled(*out->memory(), 4 * mb, 1)) held.push_back(buffer);
  EXPECT_IN_CHILD(held.size() >= 8 && held.size() < 16);
  EXPECT_IN_CHILD(mentions(out->memory()->last_failure().text(), "memory limit"));
  EXPECT_IN_CHILD(out->publish(text_record("without memory")) == 1 && in.wait_for(1));
  EXPECT_IN_CHILD(group.set_limit(128 * mb));
  EXPECT_IN_CHILD(filled(*out->memory(), 4 * mb, 2));
  return 0;
}

int file_size_limit() {
  ::signal(SIGXFSZ, SIG_IGN);
  limit(RLIMIT_FSIZE, 8 * mb);
  const auto memory = SegmentMemory::create(MemoryOptions{64 * mb});
  EXPECT_IN_CHILD(!memory && mentions(memory.error().text(), "ulimit -f"));
  EXPECT_IN_CHILD(SegmentMemory::create(MemoryOptions{mb}));
  return 0;
}

#ifdef TZC_PORTABLE
bool small_private_shm() {
  return ::unshare(CLONE_NEWNS) == 0 && ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         ::mount("tmpfs", "/dev/shm", "tmpfs", 0, "size=8m") == 0;
}

int full_tmpfs() {
  if (!small_private_shm()) return skipped;
  const auto out = publisher(10, 64 * mb);
  Inbox in(out->address());
  std::vector<BufferPtr> held;
  while (BufferPtr buffer = filled(*out->memory(), mb, 1)) held.push_back(buffer);
  EXPECT_IN_CHILD(held.size() >= 6 && held.size() < 8);
  EXPECT_IN_CHILD(mentions(out->memory()->last_failure().text(), "shared memory is full"));
  EXPECT_IN_CHILD(out->publish(text_record("without memory")) == 1 && in.wait_for(1));
  ::mount("none", "/dev/shm", nullptr, MS_REMOUNT, "size=32m");
  EXPECT_IN_CHILD(filled(*out->memory(), mb, 2));
  return 0;
}
#endif

void run(int (*test)()) {
  const int status = exit_status(in_child(test));
  if (status == skipped) GTEST_SKIP() << "not permitted here";
  EXPECT_EQ(status, 0);
}

TEST(Exhaustion, too_many_descriptors_in_a_child) {
  run(publisher_without_descriptors);
}
#ifndef TZC_PORTABLE
TEST(Exhaustion, too_many_descriptors_in_flight_in_a_child) {
  run(too_many_descriptors_in_flight);
}
#endif
TEST(Exhaustion, accepting_without_descriptors_in_a_child) {
  run(accepting_without_descriptors);
}
TEST(Exhaustion, memory_limit_in_a_child) {
  const pid_t child = in_child(memory_limit);
  const int status = exit_status(child);
  for (const char* mount : {"/sys/fs/cgroup/memory", "/sys/fs/cgroup"})
    ::rmdir((mount + ("/tzc-test-" + std::to_string(child)))
                .c_str());  // it can only go when its process has gone
  // Needs root and a mounted hierarchy; memory_limit_test.cpp has the same with files of its own, everywhere.
  if (status == skipped) GTEST_SKIP() << "no control group of version 1 or 2 may be made here";
  EXPECT_EQ(status, 0);
}
TEST(Exhaustion, file_size_limit_in_a_child) {
  run(file_size_limit);
}
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Exhaustion, no_address_space_in_a_child) {
  run(subscriber_that_cannot_map);
}
#endif
#ifdef TZC_PORTABLE
TEST(Exhaustion, full_tmpfs_in_a_child) {
  run(full_tmpfs);
}
#endif

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
