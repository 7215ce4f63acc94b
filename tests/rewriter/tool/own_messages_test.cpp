// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tool/workspace.h"

namespace tzc::rewriter {
namespace {

using ::testing::HasSubstr;

/// The workspace with a message in the package and one in a package beside it.
class OwnMessages : public ::testing::Test {
 protected:
  OwnMessages() {
    ws.plan()["echo"] = true;
    ws.folder().write("ws/src/demo/msg/Blob.msg", "uint8[] bytes\n");
    ws.folder().write("ws/src/other_msgs/package.xml",
                      "<package format=\"2\"><name>other_msgs</name></package>");
    ws.folder().write("ws/src/other_msgs/msg/Pair.msg", "demo/Blob left\ndemo/Blob right\n");
    ws.folder().write("ws/src/other_msgs/CMakeLists.txt",
                      "find_package(catkin REQUIRED COMPONENTS message_generation)\n");
  }
  test::Workspace ws;
};

TEST_F(OwnMessages, are_generated_for_the_analysis) {
  const auto result = ws.rewrite({"-q"});
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/demo/Blob.h\n"));
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/other_msgs/Pair.h\n"));
}

TEST_F(OwnMessages, broken_ones_stop_the_run_with_their_place) {
  ws.folder().write("ws/src/demo/msg/Blob.msg", "uint8[ bytes\n");
  const auto result = ws.rewrite({"--apply"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors, HasSubstr("Blob.msg:1:"));
}

TEST_F(OwnMessages, broken_ones_of_another_package_do_not) {
  ws.folder().write("ws/src/other_msgs/msg/Pair.msg", "uint8[ bytes\n");
  EXPECT_EQ(ws.rewrite({}).status, 1);
}

}  // namespace
}  // namespace tzc::rewriter
