// SPDX-License-Identifier: BSD-3-Clause
#include "interruption/interruption.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "proof/process.h"
#include "proof/scratch_folder.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;

/// A pipe; both of its ends are closed with it.
class Pipe {
 public:
  Pipe() {
    if (::pipe(ends_) != 0) std::abort();
  }
  ~Pipe() {
    for (const int end : ends_)
      if (end >= 0) ::close(end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void tell(const std::string& line) const {
    const std::string text = line + "\n";
    if (::write(ends_[1], text.data(), text.size()) != static_cast<ssize_t>(text.size())) std::abort();
  }
  /// Waits for a line, without its end.
  std::string next() const {
    std::string line;
    for (char c = 0; ::read(ends_[0], &c, 1) == 1 && c != '\n';) line += c;
    return line;
  }
  int writing_end() const { return ends_[1]; }
  void stop_reading() {
    ::close(ends_[0]);
    ends_[0] = -1;
  }

 private:
  int ends_[2];
};

/// Runs something in a process of its own that handles interruptions.
class Interruption : public ::testing::Test {
 protected:
  /// A shell lets what it starts in the background ignore Ctrl-C.
  void SetUp() override {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
  }
  void start(const std::function<void()>& work) {
    child_ = ::fork();
    ASSERT_GE(child_, 0);
    if (child_ > 0) return;
    ::dup2(errors_.writing_end(), STDERR_FILENO);
    handle_interruptions("interrupted");
    work();
    std::_Exit(0);
  }
  /// How the process ends: "exit 0", "signal 15".
  std::string end() const {
    int status = 0;
    ::waitpid(child_, &status, 0);
    return WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                               : "exit " + std::to_string(WEXITSTATUS(status));
  }
  bool is_running() const { return ::waitpid(child_, nullptr, WNOHANG) == 0; }

  tzc::test::TempDir temp_;
  Pipe told_, answer_, errors_;
  pid_t child_ = -1;
};

TEST_F(Interruption, removes_folders_and_ends_children) {
  const char* const script =
      "trap 'echo > \"$1/ended\"; exit' TERM; echo > \"$1/begun\"; for i in $(seq 6000); do sleep 0.01; done";
  start([&] {
    ::setenv("TMPDIR", temp_.path().c_str(), 1);
    const Expected<ScratchFolder> folder = ScratchFolder::make();
    std::ofstream(*folder / "file") << "content";
    told_.tell(folder->path());
    run_process({"sh", "-c", script, "sh", temp_.path()});
  });
  const std::string folder = told_.next();
  ASSERT_TRUE(fs::exists(folder));
  while (!fs::exists(temp_ / "begun")) ::usleep(1000);
  ::kill(child_, SIGTERM);
  EXPECT_EQ(end(), "signal 15");
  EXPECT_EQ(errors_.next(), "interrupted");
  EXPECT_FALSE(fs::exists(folder));
  while (!fs::exists(temp_ / "ended")) ::usleep(1000);  // or this test never ends
}

/// As when Ctrl-C ends the reader of a pipe, too.
TEST_F(Interruption, removes_folders_though_nobody_reads_what_it_says) {
  errors_.stop_reading();
  start([&] {
    ::setenv("TMPDIR", temp_.path().c_str(), 1);
    const Expected<ScratchFolder> folder = ScratchFolder::make();
    told_.tell(folder->path());
    for (;;) ::pause();
  });
  const std::string folder = told_.next();
  ASSERT_TRUE(fs::exists(folder));
  ::kill(child_, SIGTERM);
  end();
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(Interruption, waits_for_a_delay) {
  start([&] {
    {
      const InterruptionDelay delay;
      told_.tell("delayed");
      answer_.next();
      std::ofstream(temp_ / "done") << "done";
    }
    for (;;) ::pause();
  });
  told_.next();
  ::kill(child_, SIGINT);
  ::usleep(100000);
  EXPECT_TRUE(is_running());
  answer_.tell("go on");
  EXPECT_EQ(end(), "signal 2");
  EXPECT_TRUE(fs::exists(temp_ / "done"));
}

TEST_F(Interruption, what_is_ignored_stays_ignored) {
  ::signal(SIGHUP, SIG_IGN);
  start([&] {
    told_.tell("begun");
    answer_.next();
  });
  ::signal(SIGHUP, SIG_DFL);
  told_.next();
  ::kill(child_, SIGHUP);
  ::usleep(100000);
  EXPECT_TRUE(is_running());
  answer_.tell("end");
  EXPECT_EQ(end(), "exit 0");
}

TEST_F(Interruption, children_take_signals) {
  start([&] {
    ::signal(SIGPIPE, SIG_IGN);
    for (const char* signal : {"TERM", "PIPE"}) {
      const ProcessResult result =
          run_process({"sh", "-c", std::string("kill -") + signal + " $$; echo survived"});
      told_.tell(result.output.empty() ? "ended" : result.output);
    }
  });
  EXPECT_EQ(told_.next(), "ended");
  EXPECT_EQ(told_.next(), "ended");
  EXPECT_EQ(end(), "exit 0");
}

}  // namespace
}  // namespace tzc::rewriter
