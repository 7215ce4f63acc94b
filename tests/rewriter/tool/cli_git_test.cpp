// SPDX-License-Identifier: BSD-3-Clause
// What git knows of the files, what it refuses to say, and what is written then.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tool/cli_case.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
using test::Cli;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A workspace in git, and environments in which git does not answer.
class CliGit : public Cli {
 protected:
  CliGit() {
    ws.rewrite({});  // writes plan.json
    std::filesystem::create_directories(ws.folder() / "home");
    std::filesystem::create_directories(ws.folder() / "no_programs");
  }

  /// A home of its own, so that the settings of whoever runs the test do not count.
  std::map<std::string, std::string> environment(std::map<std::string, std::string> more = {}) const {
    more.insert({{"HOME", ws.folder() / "home"},
                 {"XDG_CONFIG_HOME", ws.folder() / "home"},
                 {"GIT_CONFIG_NOSYSTEM", "1"}});
    return more;
  }

  /// Git's own switch for its tests: it sees every repository as that of another user, also one of root's.
  std::map<std::string, std::string> another_user() const {
    return environment({{"GIT_TEST_ASSUME_DIFFERENT_OWNER", "1"}});
  }

  std::map<std::string, std::string> no_git() const {
    return environment({{"PATH", ws.folder() / "no_programs"}});
  }

  void commit(const std::string& folder) const {
    ASSERT_EQ(
        ws.shell("cd " + folder +
                 " && git init -q . && git add -A . && git -c user.name=a -c user.email=a@b commit -qm x"),
        0);
  }

  void change_something() const {
    ws.folder().write("ws/src/demo/src/node.cpp", "// mine\n#include <ros/ros.h>\nros::Publisher pub;\n");
  }

  /// The only line of a text that begins with these words, without what it is indented by.
  static std::string line_with(const std::string& text, const std::string& words) {
    const std::size_t begin = text.find(words);
    return begin == std::string::npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
  }

  ProcessResult apply(const std::map<std::string, std::string>& environment,
                      std::vector<std::string> words = {}) {
    words.emplace_back("--apply");
    return ws.rewrite(words, environment);
  }

  std::string srcroot(const std::map<std::string, std::string>& environment) {
    const std::string file = ws.folder() / "tzc.sarif";
    ws.rewrite({"--check", "--no-cache", "--report", file}, environment);
    return json::parse(ws.folder().read("tzc.sarif"))["runs"][0]["originalUriBaseIds"]["SRCROOT"]["uri"];
  }
};

TEST_F(CliGit, a_repository_that_git_refuses_is_not_written_to_until_the_user_trusts_it) {
  commit(".");
  change_something();
  const auto refused = apply(another_user());
  EXPECT_EQ(refused.status, 2);
  EXPECT_FALSE(is_ported());
  EXPECT_THAT(refused.errors,
              AllOf(HasSubstr((ws.folder() / "ws") + ": belongs to another user"), HasSubstr("--force")));
  const std::string line = line_with(refused.errors, "git config");
  std::string variables;
  for (const auto& [name, value] : another_user()) variables += name + "='" + value + "' ";
  ASSERT_EQ(ws.shell("env " + variables + line), 0) << refused.errors;
  const auto dirty = apply(another_user());
  EXPECT_EQ(dirty.status, 2);
  EXPECT_THAT(dirty.errors, HasSubstr("node.cpp: has changes that git does not have"));
  commit(".");
  EXPECT_EQ(apply(another_user()).status, 0);
  EXPECT_TRUE(is_ported());
}

TEST_F(CliGit, files_that_git_does_not_look_at_are_not_written_over) {
  commit(".");
  for (const char* told : {"--assume-unchanged", "--skip-worktree"}) {
    ASSERT_EQ(ws.shell(std::string("git update-index ") + told + " src/demo/src/node.cpp"), 0);
    change_something();
    const auto refused = apply(environment());
    EXPECT_EQ(refused.status, 2) << told;
    EXPECT_FALSE(is_ported()) << told;
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("node.cpp: git was told not to look"), HasSubstr("--force")));
    for (const char* option : {"--no-assume-unchanged", "--no-skip-worktree"})
      ASSERT_EQ(ws.shell(std::string("git update-index ") + option + " src/demo/src/node.cpp"), 0);
    ASSERT_EQ(ws.shell("git checkout -q ."), 0);
  }
  const auto written = apply(environment());
  EXPECT_EQ(written.status, 0) << written.errors;
}

/// A way in which git fails.
struct Failure {
  const char* name;
  const char* damage;  ///< a shell command in the repository's top
  std::map<std::string, std::string> environment;
};

/// However git fails, a file of a repository is written over only with --force.
TEST_F(CliGit, what_git_does_not_say_is_not_written_over) {
  const Failure failures[] = {
      {"another user", "true", another_user()},
      {"no git", "true", no_git()},
      {"no HEAD", "rm .git/HEAD", environment()},
      {"an empty .git", "rm -rf .git; mkdir .git", environment()},
      {"a .git that leads nowhere", "rm -rf .git; echo gitdir: /nowhere >.git", environment()},
      {"settings that are none", "echo '[' >.git/config", environment()},
      {"an index that is none", "echo none >.git/index", environment()},
  };
  const std::string before = ws.file("src/node.cpp");
  for (const std::string& top : {ws.folder() / "ws", ws.folder() / "ws/src", ws.package()}) {
    for (const Failure& failure : failures) {
      SCOPED_TRACE(std::string(failure.name) + " in " + top);
      commit(top);
      ASSERT_EQ(ws.shell("cd " + top + " && " + failure.damage), 0);
      const auto refused = apply(failure.environment);
      EXPECT_EQ(refused.status, 2);
      EXPECT_EQ(ws.file("src/node.cpp"), before);
      EXPECT_THAT(refused.errors, AllOf(HasSubstr(top + ": "), HasSubstr("--force")));
      EXPECT_EQ(srcroot(failure.environment), "file://" + top + "/");
      const auto forced = apply(failure.environment, {"--force"});
      EXPECT_EQ(forced.status, 0) << forced.errors;
      EXPECT_EQ(ws.shell(line_with(forced.errors, "patch -p1")), 0) << forced.errors;
      EXPECT_EQ(ws.file("src/node.cpp"), before);
      ASSERT_EQ(ws.shell("rm -rf " + top + "/.git"), 0);
    }
  }
}

TEST_F(CliGit, a_repository_in_the_package_is_asked_for_its_own_files) {
  commit("src/demo/src");
  commit(".");
  change_something();
  const auto refused = apply(environment());
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.errors, HasSubstr("src/node.cpp: has changes that git does not have"));
  commit("src/demo/src");
  EXPECT_EQ(apply(environment()).status, 0);
}

/// The warning is one line, and what it says to type brings everything back.
TEST_F(CliGit, files_that_no_repository_holds_are_written_with_a_word) {
  const char* names[] = {"CMakeLists.txt", "package.xml", "src/node.cpp"};
  std::map<std::string, std::string> before;
  for (const char* name : names) before[name] = ws.file(name);
  for (const auto& variables : {environment(), no_git()}) {
    const auto applied = apply(variables, {"-q"});
    EXPECT_EQ(applied.status, 0);
    EXPECT_TRUE(is_ported());
    EXPECT_THAT(applied.errors, HasSubstr("warning: git does not have what was in " + ws.package()));
    EXPECT_EQ(std::count(applied.errors.begin(), applied.errors.end(), '\n'), 1) << applied.errors;
    EXPECT_EQ(ws.shell(line_with(applied.errors, "patch -p1")), 0) << applied.errors;
    for (const char* name : names) EXPECT_EQ(ws.file(name), before[name]) << name;
  }
}

TEST_F(CliGit, so_are_files_that_their_repository_ignores) {
  ws.folder().write("ws/.gitignore", "node.cpp\n");
  commit(".");
  const auto applied = apply(environment());
  EXPECT_EQ(applied.status, 0);
  EXPECT_THAT(applied.errors, HasSubstr("git does not have what was in " + ws.package() + "/src/node.cpp;"));
}

TEST_F(CliGit, what_git_can_bring_back_is_written_without_a_word) {
  commit(".");
  EXPECT_THAT(apply(environment()).errors, Not(HasSubstr("warning")));
  EXPECT_TRUE(is_ported());
  EXPECT_THAT(apply(environment()).errors, Not(HasSubstr("warning"))) << "the second run writes nothing";
}

TEST_F(CliGit, without_git_and_without_an_undo_patch_nothing_is_written) {
  ws.folder().write("state", "a file, not a folder");
  const auto refused = apply(environment());
  EXPECT_EQ(refused.status, 2);
  EXPECT_FALSE(is_ported());
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("--undo"), HasSubstr("--force")));
  EXPECT_EQ(apply(environment(), {"--undo", ws.folder() / "undo.patch"}).status, 0);
  EXPECT_TRUE(is_ported());
}

}  // namespace
}  // namespace tzc::rewriter
