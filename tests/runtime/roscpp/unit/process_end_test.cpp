// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/process_end.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <thread>

namespace tzc {
namespace detail {
namespace {

/// A child process that does `work` and is killed and reaped in the end.
class Child {
 public:
  template <class Work>
  explicit Child(Work work) : pid_(::fork()) {
    if (pid_ != 0) return;
    work();
    ::_exit(0);
  }
  ~Child() { reap(); }
  pid_t pid() const { return pid_; }
  void kill() const { ::kill(pid_, SIGKILL); }
  void reap() {
    if (pid_ <= 0) return;
    kill();
    ::waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }

 private:
  pid_t pid_;
};

void sleep_for_ever() {
  for (;;) ::pause();
}

/// Waits until the kernel has ended it; its parent has not taken note yet.
void wait_for_end(const Child& child) {
  siginfo_t info = {};
  ::waitid(P_PID, static_cast<id_t>(child.pid()), &info, WEXITED | WNOWAIT);
}

TEST(ProcessEnd, of_a_process_that_runs_or_is_stopped) {
  EXPECT_FALSE(has_ended(::getpid()));
  const Child child(sleep_for_ever);
  EXPECT_FALSE(has_ended(child.pid()));
  ::kill(child.pid(), SIGSTOP);
  EXPECT_FALSE(has_ended(child.pid()));
}

TEST(ProcessEnd, before_and_after_the_parent_takes_note) {
  Child child(sleep_for_ever);
  child.kill();
  wait_for_end(child);
  EXPECT_TRUE(has_ended(child.pid()));
  const pid_t pid = child.pid();
  child.reap();
  EXPECT_TRUE(has_ended(pid));
}

TEST(ProcessEnd, of_the_first_thread_alone_is_none) {
  const Child child([] {
    std::thread(sleep_for_ever).detach();
    ::syscall(SYS_exit, 0);
  });
  const std::string first = "/proc/" + std::to_string(child.pid()) + "/stat";
  std::string line;
  for (int i = 0; i < 1000 && line.find(") Z ") == std::string::npos; ++i) {
    ::usleep(10'000);
    std::ifstream file(first);
    std::getline(file, line);
  }
  ASSERT_NE(line.find(") Z "), std::string::npos) << line;
  EXPECT_FALSE(has_ended(child.pid()));
}

// What it is for: the hang-up of one socket tells that the process has ended, also when others are still open.
TEST(ProcessEnd, is_told_as_soon_as_a_socket_of_a_killed_process_is_closed) {
  for (int round = 0; round < 50; ++round) {
    int ends[2];
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
    const Child child([&] {
      ::close(ends[0]);
      for (int i = 0; i < 500; ++i) (void)!::dup(STDERR_FILENO);  // there is more to close than the socket
      (void)!::write(ends[1], "x", 1);
      sleep_for_ever();
    });
    ::close(ends[1]);
    char byte = 0;
    ASSERT_EQ(::read(ends[0], &byte, 1), 1);
    child.kill();
    EXPECT_EQ(::read(ends[0], &byte, 1), 0);
    EXPECT_TRUE(has_ended(child.pid()));
    ::close(ends[0]);
  }
}

TEST(ProcessEnd, of_a_process_that_the_kernel_does_not_name) {
  EXPECT_FALSE(has_ended(0));
  EXPECT_FALSE(has_ended(-1));
}

}  // namespace
}  // namespace detail
}  // namespace tzc
