// SPDX-License-Identifier: BSD-3-Clause
// What may not be read, entered or written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tool/cli_case.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;
using test::Cli;
using ::testing::AllOf;
using ::testing::HasSubstr;

class CliModes : public Cli {
 protected:
  CliModes() {
    ws.rewrite({});  // writes plan.json
    ws.respect_modes();
  }
  ~CliModes() override { ws.shell("chmod -R u+rwX .."); }

  fs::perms mode_of(const std::string& file) const {
    return fs::status(ws.folder() / file).permissions() & fs::perms::owner_all;
  }
};

TEST_F(CliModes, the_copy_of_what_may_not_be_written_may) {
  ws.folder().write("ws/src/demo/src/tool.sh", "#!/bin/sh\n");
  ASSERT_EQ(
      ws.shell("chmod 555 src/demo/src/tool.sh; chmod 444 src/demo/src/node.cpp; chmod 555 src/demo/src"), 0);
  const auto in_place = ws.rewrite({"--apply"});
  EXPECT_EQ(in_place.status, 2);
  EXPECT_THAT(in_place.errors, AllOf(HasSubstr("its folder cannot be written"), HasSubstr("--out-dir")));
  const auto copied = ws.rewrite({"--out-dir", ws.folder() / "out"});
  EXPECT_EQ(copied.status, 0) << copied.errors;
  EXPECT_THAT(ws.folder().read("out/demo/src/node.cpp"), HasSubstr("tzc::Publisher pub;"));
  EXPECT_EQ(mode_of("out/demo/src"), fs::perms::owner_all);
  EXPECT_EQ(mode_of("out/demo/src/node.cpp"), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(mode_of("out/demo/src/tool.sh"), fs::perms::owner_all);
  EXPECT_EQ(ws.rewrite({"--out-dir", ws.folder() / "out"}).status, 0) << "over the copy";
}

TEST_F(CliModes, folders_that_may_not_be_entered_are_no_part_of_a_workspace) {
  ASSERT_EQ(ws.shell("mkdir -p src/database src/demo/private && chmod 0 src/database src/demo/private"), 0);
  for (const std::string& named : {ws.package(), ws.folder() / "ws/src"}) {
    const auto looked = ws.run({"--check", named});
    EXPECT_EQ(looked.status, 1) << looked.errors;
    EXPECT_THAT(looked.output, HasSubstr("zero_copy"));
  }
  EXPECT_EQ(ws.rewrite({"--apply"}).status, 0);
  EXPECT_TRUE(is_ported());
}

TEST_F(CliModes, what_the_system_refuses_in_one_package_leaves_the_others_and_the_report) {
  ws.folder().write("other/src/broken/package.xml", ws.file("package.xml"));
  ws.folder().write("other/src/broken/plan.json", R"({"throws": "no entry"})");
  const std::string source = ws.folder().write("other/src/broken/src/node.cpp", "int main() {}\n");
  ws.folder().write("other/build/compile_commands.json",
                    nlohmann::json::array({{{"directory", ws.folder().path()},
                                            {"file", source},
                                            {"command", "c++ -o CMakeFiles/node.dir/node.cpp.o -c x"}}})
                        .dump());
  const auto done =
      ws.run({"--apply", "--report", ws.folder() / "report.json", ws.package(), ws.folder() / "other/src"});
  EXPECT_EQ(done.status, 1) << done.errors;
  EXPECT_TRUE(is_ported());
  EXPECT_THAT(done.errors, HasSubstr("other/src/broken: no entry"));
  EXPECT_THAT(ws.folder().read("report.json"), HasSubstr("\"demo\""));
}

}  // namespace
}  // namespace tzc::rewriter
