// SPDX-License-Identifier: BSD-3-Clause
// What --out-dir writes over: the folder may be another workspace, in which somebody works.
#include <gmock/gmock.h>

#include <filesystem>

#include "tool/cli_case.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CliOutDir : public test::Cli {
 protected:
  ProcessResult write(std::vector<std::string> words = {}) {
    words.insert(words.end(), {"--out-dir", out_});
    return ws.rewrite(words);
  }
  std::string source() const { return ws.folder().read("out/demo/src/node.cpp"); }
  void work() const { ws.folder().write("out/demo/src/node.cpp", "int work;\n"); }
  void commit() {
    ASSERT_EQ(
        ws.shell("cd ../out/demo && git init -q . && git add -A && git -c user.name=a -c user.email=a@b.org "
                 "commit -qm a"),
        0);
  }

  const std::string out_ = ws.folder() / "out";
};

TEST_F(CliOutDir, a_copy_that_nobody_has_changed_is_written_again) {
  EXPECT_EQ(write().status, 0);
  const auto again = write();
  EXPECT_EQ(again.status, 0) << again.errors;
  EXPECT_THAT(again.errors, Not(HasSubstr("warning")));
}

TEST_F(CliOutDir, changes_that_git_does_not_have_are_not_written_over) {
  EXPECT_EQ(write().status, 0);
  commit();
  work();
  const auto refused = write();
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("out/demo/src/node.cpp: has changes that git does not have"),
                                    HasSubstr("--force")));
  EXPECT_EQ(source(), "int work;\n");
  EXPECT_EQ(write({"--force"}).status, 0);
  EXPECT_THAT(source(), HasSubstr("tzc::Publisher"));
}

TEST_F(CliOutDir, what_git_has_is_written_over) {
  EXPECT_EQ(write().status, 0);
  work();
  commit();
  const auto written = write();
  EXPECT_EQ(written.status, 0) << written.errors;
  EXPECT_THAT(source(), HasSubstr("tzc::Publisher"));
  EXPECT_THAT(written.errors, Not(HasSubstr("warning")));
}

TEST_F(CliOutDir, what_no_repository_has_comes_back_from_a_patch) {
  EXPECT_EQ(write().status, 0);
  work();
  const auto written = write();
  EXPECT_EQ(written.status, 0) << written.errors;
  EXPECT_THAT(source(), HasSubstr("tzc::Publisher"));
  const std::string begin = "brings it back: ";
  ASSERT_THAT(written.errors, AllOf(HasSubstr("out/demo/src/node.cpp"), HasSubstr(begin)));
  const std::size_t at = written.errors.find(begin) + begin.size();
  ASSERT_EQ(ws.shell(written.errors.substr(at, written.errors.find('\n', at) - at)), 0) << written.errors;
  EXPECT_EQ(source(), "int work;\n");
}

TEST_F(CliOutDir, what_a_patch_cannot_bring_back_is_not_written_over) {
  ws.folder().write("ws/src/demo/data.bin", std::string("new\0", 4));
  ws.folder().write("out/demo/data.bin", std::string("old\0", 4));
  EXPECT_EQ(write().status, 2);
  EXPECT_EQ(ws.folder().read("out/demo/data.bin"), std::string("old\0", 4));
  EXPECT_EQ(write({"--force"}).status, 0);
  EXPECT_EQ(ws.folder().read("out/demo/data.bin"), std::string("new\0", 4));
}

TEST_F(CliOutDir, a_folder_in_the_place_of_a_file_stays) {
  ws.folder().write("out/demo/src/node.cpp/work.txt", "work\n");
  EXPECT_EQ(write().status, 2);
  EXPECT_TRUE(fs::exists(ws.folder() / "out/demo/src/node.cpp/work.txt"));
}

}  // namespace
}  // namespace tzc::rewriter
