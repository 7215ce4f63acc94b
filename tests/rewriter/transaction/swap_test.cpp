// SPDX-License-Identifier: BSD-3-Clause
#include "transaction/swap.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

/// A package of three files, "old" in each of them.
class SwapTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : names) contents_[package_.write(name, "old")] = "new";
    before_ = snapshot(package_.path());
  }
  std::string state() const {
    std::string all;
    for (const char* name : names) all += (all.empty() ? "" : " ") + package_.read(name);
    return all;
  }
  bool clean() const { return !std::filesystem::exists(package_ / ".tzc-rewrite"); }

  /// The swap in a child that dies by SIGKILL when it has passed `step` for the `nth` time.
  void killed_after(const std::string& step, int nth) {
    const pid_t child = fork();
    if (child == 0) {
      wanted_step = step;
      countdown = nth;
      swap_observer = [](const char* at) {
        if (at == wanted_step && --countdown == 0) kill(getpid(), SIGKILL);
      };
      (void)swap_in(package_.path(), contents_, before_);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
  }

  static constexpr const char* names[] = {"CMakeLists.txt", "package.xml", "src/node.cpp"};
  static std::string wanted_step;
  static int countdown;
  tzc::test::TempDir package_;
  FileContents contents_;
  Snapshot before_;
};
std::string SwapTest::wanted_step;
int SwapTest::countdown;

TEST_F(SwapTest, replaces_all) {
  ASSERT_TRUE(swap_in(package_.path(), contents_, before_));
  EXPECT_EQ(state(), "new new new");
  EXPECT_TRUE(clean());
}

TEST_F(SwapTest, keeps_modes) {
  chmod((package_ / "src/node.cpp").c_str(), 0751);
  ASSERT_TRUE(swap_in(package_.path(), contents_, before_));
  struct stat state{};
  stat((package_ / "src/node.cpp").c_str(), &state);
  EXPECT_EQ(state.st_mode & 07777, 0751u);
}

TEST_F(SwapTest, nothing_to_do_leaves_no_trace) {
  ASSERT_TRUE(swap_in(package_.path(), {}, before_));
  EXPECT_TRUE(clean());
}

TEST_F(SwapTest, a_file_changed_since_the_analysis_stops_everything) {
  package_.write("package.xml", "mine");
  const Expected<void> done = swap_in(package_.path(), contents_, before_);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().where, package_ / "package.xml");
  EXPECT_EQ(state(), "old mine old");
  EXPECT_TRUE(clean());
}

TEST_F(SwapTest, so_does_a_file_that_is_not_edited_but_was_read) {
  package_.write("src/node.h", "changed");
  EXPECT_FALSE(swap_in(package_.path(), contents_, before_));
  EXPECT_EQ(state(), "old old old");
}

TEST_F(SwapTest, and_a_file_that_vanished) {
  std::filesystem::remove(package_ / "package.xml");
  EXPECT_FALSE(swap_in(package_.path(), contents_, before_));
  EXPECT_EQ(state(), "old  old");
  EXPECT_TRUE(clean());
}

TEST_F(SwapTest, killed_before_the_journal_leaves_the_package_untouched) {
  killed_after("staged", 1);
  EXPECT_EQ(state(), "old old old");
  const auto recovered = recover(package_.path());
  ASSERT_TRUE(recovered);
  EXPECT_TRUE(recovered->empty());
  EXPECT_EQ(state(), "old old old");
  EXPECT_TRUE(clean());
}

TEST_F(SwapTest, killed_after_the_journal_is_finished_by_the_next_start) {
  killed_after("journal", 1);
  EXPECT_EQ(state(), "old old old");
  const auto recovered = recover(package_.path());
  ASSERT_TRUE(recovered) << to_string(recovered.error());
  EXPECT_EQ(recovered->size(), 3u);
  EXPECT_EQ(state(), "new new new");
  EXPECT_TRUE(clean());
}

TEST_F(SwapTest, killed_in_the_middle_is_finished_by_the_next_start) {
  for (int files = 1; files <= 3; ++files) {
    SetUp();
    killed_after("swapped", files);
    ASSERT_TRUE(recover(package_.path()));
    EXPECT_EQ(state(), "new new new");
    EXPECT_TRUE(clean());
  }
}

TEST_F(SwapTest, recovery_that_is_killed_is_finished_by_the_one_after) {
  killed_after("swapped", 1);
  const pid_t child = fork();
  if (child == 0) {
    swap_observer = [](const char*) { kill(getpid(), SIGKILL); };
    (void)recover(package_.path());
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(recover(package_.path()));
  EXPECT_EQ(state(), "new new new");
}

TEST_F(SwapTest, an_edit_between_the_kill_and_the_recovery_is_not_overwritten) {
  killed_after("swapped", 1);
  package_.write("src/node.cpp", "mine");
  const auto recovered = recover(package_.path());
  ASSERT_FALSE(recovered);
  EXPECT_EQ(recovered.error().where, package_ / "src/node.cpp");
  EXPECT_EQ(state(), "new old mine");
}

TEST_F(SwapTest, ctrl_c_waits_for_the_end) {
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGINT, SIG_DFL);
    swap_observer = [](const char* at) {
      if (std::string(at) == "swapped") kill(getpid(), SIGINT);
    };
    (void)swap_in(package_.path(), contents_, before_);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
  EXPECT_EQ(state(), "new new new");
  EXPECT_TRUE(clean());
}

TEST_F(SwapTest, two_runs_at_a_time_are_refused) {
  static std::string package;
  static bool refused;
  package = package_.path();
  swap_observer = [](const char*) { refused = !recover(package); };
  ASSERT_TRUE(swap_in(package_.path(), contents_, before_));
  swap_observer = nullptr;
  EXPECT_TRUE(refused);
}

TEST_F(SwapTest, a_journal_that_reaches_out_of_the_package_is_refused) {
  tzc::test::TempDir victim;
  victim.write("file", "precious");
  package_.write(".tzc-rewrite/0", "evil");
  package_.write(".tzc-rewrite/journal.json", R"({"version":1,"files":[{"staged":"0","target":"../)" +
                                                  std::filesystem::path(victim.path()).filename().string() +
                                                  R"(/file","old":0,"new":0}]})");
  EXPECT_FALSE(recover(package_.path()));
  EXPECT_EQ(victim.read("file"), "precious");
}

TEST_F(SwapTest, a_broken_journal_is_an_error_not_a_crash) {
  for (const char* text :
       {"", "{", "[]", "{\"version\":1}", "{\"version\":1,\"files\":[1]}", "{\"version\":2,\"files\":[]}"}) {
    package_.write(".tzc-rewrite/journal.json", text);
    EXPECT_FALSE(recover(package_.path())) << text;
  }
}

}  // namespace
}  // namespace tzc::rewriter
