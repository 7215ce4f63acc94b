// SPDX-License-Identifier: BSD-3-Clause
#include "transaction/swap.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>

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
  Expected<void> swap(const FileContents& contents) const {
    return swap_in({{package_.path(), contents, before_}});
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
      (void)swap(contents_);
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
  ASSERT_TRUE(swap(contents_));
  EXPECT_EQ(state(), "new new new");
  EXPECT_TRUE(clean());
}

/// Takes another user's rights for a while; root may write everywhere.
class AsNobody {
 public:
  AsNobody() : is_one_(::geteuid() != 0 || ::seteuid(65534) == 0) {}
  ~AsNobody() {
    if (::getuid() == 0) (void)!::seteuid(0);
  }
  explicit operator bool() const { return is_one_; }

 private:
  bool is_one_;
};

TEST_F(SwapTest, a_folder_of_somebody_else_is_named_with_the_reason) {
  chmod(package_.path().c_str(), 0555);
  Expected<void> done = Error{"", "", ""};
  {
    const AsNobody nobody;
    ASSERT_TRUE(nobody);
    done = swap(contents_);
  }
  chmod(package_.path().c_str(), 0755);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what, "cannot be written: Permission denied");
  EXPECT_EQ(done.error().where, package_.path());
  EXPECT_NE(done.error().hint.find("--out-dir"), std::string::npos) << done.error().hint;
  EXPECT_EQ(state(), "old old old");
}

TEST_F(SwapTest, keeps_modes) {
  chmod((package_ / "src/node.cpp").c_str(), 0751);
  ASSERT_TRUE(swap(contents_));
  struct stat state{};
  stat((package_ / "src/node.cpp").c_str(), &state);
  EXPECT_EQ(state.st_mode & 07777, 0751u);
}

/// As in a container, where the user is root and the workspace is not root's.
TEST_F(SwapTest, root_leaves_files_to_their_owners) {
  const std::string node = package_ / "src/node.cpp";
  struct stat before{}, after{};
  if (geteuid() == 0) {
    ASSERT_EQ(chown(node.c_str(), 12345, 23456), 0);
  }
  stat(node.c_str(), &before);
  ASSERT_TRUE(swap(contents_));
  stat(node.c_str(), &after);
  EXPECT_EQ(after.st_uid, before.st_uid);
  EXPECT_EQ(after.st_gid, before.st_gid);
}

TEST_F(SwapTest, nothing_to_do_leaves_no_trace) {
  ASSERT_TRUE(swap({}));
  EXPECT_TRUE(clean());
}

TEST_F(SwapTest, a_file_changed_since_the_analysis_stops_everything) {
  package_.write("package.xml", "mine");
  const Expected<void> done = swap(contents_);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().where, package_ / "package.xml");
  EXPECT_EQ(state(), "old mine old");
  EXPECT_TRUE(clean());
}

TEST_F(SwapTest, so_does_a_file_that_is_not_edited_but_was_read) {
  package_.write("src/node.h", "changed");
  EXPECT_FALSE(swap(contents_));
  EXPECT_EQ(state(), "old old old");
}

TEST_F(SwapTest, and_a_file_that_vanished) {
  std::filesystem::remove(package_ / "package.xml");
  EXPECT_FALSE(swap(contents_));
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
    (void)swap(contents_);
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
  ASSERT_TRUE(swap(contents_));
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

/// Two packages of a workspace, "old" in both.
class SwapOfTwo : public ::testing::Test {
 protected:
  SwapOfTwo() {
    for (const char* name : {"a", "b"}) {
      contents_[name][workspace_.write(std::string(name) + "/package.xml", "old")] = "new";
      before_[name] = snapshot(workspace_ / name);
    }
  }
  Expected<void> swap() const {
    return swap_in({{workspace_ / "a", contents_.at("a"), before_.at("a")},
                    {workspace_ / "b", contents_.at("b"), before_.at("b")}});
  }
  std::string state() const {
    return workspace_.read("a/package.xml") + " " + workspace_.read("b/package.xml");
  }
  bool clean() const {
    for (const char* folder : {".tzc-rewrite", "a/.tzc-rewrite", "b/.tzc-rewrite"})
      if (std::filesystem::exists(workspace_ / folder)) return false;
    return true;
  }
  void killed_at(const char* step) const {
    const pid_t child = fork();
    if (child == 0) {
      static const char* wanted = nullptr;
      wanted = step;
      swap_observer = [](const char* at) {
        if (std::string(at) == wanted) kill(getpid(), SIGKILL);
      };
      (void)swap();
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
  }
  void recover_all(const std::vector<std::string>& packages) const {
    for (const std::string& folder : swap_folders(packages, ::geteuid()))
      ASSERT_TRUE(recover(folder)) << folder;
  }

  tzc::test::TempDir workspace_;
  std::map<std::string, FileContents> contents_;
  std::map<std::string, Snapshot> before_;
};

TEST_F(SwapOfTwo, replaces_both) {
  ASSERT_TRUE(swap());
  EXPECT_EQ(state(), "new new");
  EXPECT_TRUE(clean());
}

TEST_F(SwapOfTwo, a_change_in_one_keeps_both) {
  workspace_.write("b/package.xml", "mine");
  const Expected<void> done = swap();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().where, workspace_ / "b/package.xml");
  EXPECT_EQ(state(), "old mine");
  EXPECT_TRUE(clean());
}

TEST_F(SwapOfTwo, killed_before_the_journal_leaves_both_as_they_were) {
  killed_at("staged");
  recover_all({workspace_ / "a", workspace_ / "b"});
  EXPECT_EQ(state(), "old old");
  EXPECT_TRUE(clean());
}

TEST_F(SwapOfTwo, killed_after_it_is_finished_by_a_run_on_either) {
  for (const char* package : {"a", "b"}) {
    workspace_.write("a/package.xml", "old");
    workspace_.write("b/package.xml", "old");
    killed_at("swapped");
    EXPECT_EQ(state(), "new old");
    recover_all({workspace_ / package});
    EXPECT_EQ(state(), "new new");
  }
}

TEST_F(SwapOfTwo, a_run_on_one_of_them_is_refused_meanwhile) {
  static std::string package;
  static bool refused;
  package = workspace_ / "b";
  swap_observer = [](const char*) { refused = !recover(package); };
  ASSERT_TRUE(swap());
  swap_observer = nullptr;
  EXPECT_TRUE(refused);
  EXPECT_TRUE(clean());
}

TEST_F(SwapOfTwo, a_package_in_use_keeps_both_and_its_traces_stay) {
  workspace_.write("b/.tzc-rewrite/0", "staged by another run");
  const int lock = ::open((workspace_ / "b/.tzc-rewrite/lock").c_str(), O_RDWR | O_CREAT, 0644);
  ASSERT_EQ(::flock(lock, LOCK_EX), 0);
  EXPECT_FALSE(swap());
  EXPECT_EQ(state(), "old old");
  EXPECT_TRUE(std::filesystem::exists(workspace_ / "b/.tzc-rewrite/0"));
  EXPECT_FALSE(std::filesystem::exists(workspace_ / "a/.tzc-rewrite"));
  ::close(lock);
}

TEST_F(SwapOfTwo, what_another_user_left_above_is_not_looked_at) {
  workspace_.write(".tzc-rewrite/0", "left by the user of this test");
  const std::vector<std::string> package = {workspace_ / "a"};
  EXPECT_EQ(swap_folders(package, ::geteuid() + 1), package);
  EXPECT_EQ(swap_folders(package, ::geteuid()),
            (std::vector<std::string>{workspace_.path(), workspace_ / "a"}));
}

TEST_F(SwapOfTwo, a_link_above_is_not_followed) {
  workspace_.write("elsewhere/0", "evil");
  std::filesystem::create_directory_symlink(workspace_ / "elsewhere", workspace_ / ".tzc-rewrite");
  const std::vector<std::string> package = {workspace_ / "a"};
  EXPECT_EQ(swap_folders(package, ::geteuid()), package);
}

}  // namespace
}  // namespace tzc::rewriter
