// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tool/workspace.h"

namespace tzc::rewriter {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

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

/// A field `delete` is no fault to genmsg.
TEST_F(OwnMessages, one_that_only_python_uses_stops_no_run) {
  ws.folder().write("ws/src/demo/msg/PythonOnly.msg", "string delete\n");
  EXPECT_EQ(ws.rewrite({"-q"}).status, 2) << "not built";
  ws.folder().write("ws/devel/include/demo/PythonOnly.h", "// as gencpp makes it\n");
  ws.folder().write("ws/build/CMakeCache.txt",
                    "CATKIN_DEVEL_PREFIX:PATH=" + (ws.folder() / "ws/devel") + "\n");
  const auto result = ws.rewrite({"-q"});
  EXPECT_EQ(result.status, 1) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/demo/Blob.h\n"));
}

TEST_F(OwnMessages, broken_ones_of_another_package_do_not) {
  ws.folder().write("ws/src/other_msgs/msg/Pair.msg", "uint8[ bytes\n");
  EXPECT_EQ(ws.rewrite({}).status, 1);
}

TEST_F(OwnMessages, a_broken_one_of_another_package_costs_no_other_its_header) {
  ws.folder().write("ws/src/other_msgs/srv/Broken.srv", "nowhere_msgs/Blob blob\n---\n");
  const auto result = ws.rewrite({"-q"});
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/other_msgs/Pair.h\n"));
}

/// A workspace below this one: its messages stay with its sources, and what is made of its actions lies in its devel space.
class MessagesBelow : public OwnMessages {
 protected:
  MessagesBelow() {
    const std::string below = ws.folder() / "below";
    ws.folder().write("below/src/far_msgs/msg/Part.msg", "uint8[] bytes\n");
    ws.folder().write("below/devel/share/far_msgs/msg/MadeGoal.msg", "uint8[] bytes\n");
    ws.folder().write("below/devel/share/far_msgs/cmake/far_msgs-msg-paths.cmake",
                      "set(far_msgs_MSG_INCLUDE_DIRS \"" + below + "/src/far_msgs/msg;" + below +
                          "/devel/share/far_msgs/msg\")\nset(far_msgs_MSG_DEPENDENCIES )\n");
    ws.folder().write("ws/src/other_msgs/msg/Whole.msg", "far_msgs/Part part\nfar_msgs/MadeGoal goal\n");
  }
};

TEST_F(MessagesBelow, are_found_through_the_environment) {
  const auto result = ws.rewrite({"-q"}, {{"CMAKE_PREFIX_PATH", ws.folder() / "below/devel"}});
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/other_msgs/Whole.h\n"));
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/other_msgs/Pair.h\n"));
}

TEST_F(MessagesBelow, are_found_where_cmake_has_found_them) {
  ws.folder().write("ws/build/CMakeCache.txt",
                    "far_msgs_DIR:PATH=" + (ws.folder() / "below/devel/share/far_msgs/cmake") + "\n");
  EXPECT_THAT(ws.rewrite({"-q"}).errors, HasSubstr("twin: /tzc/other_msgs/Whole.h\n"));
}

TEST_F(MessagesBelow, that_are_nowhere_cost_no_other_its_header) {
  const auto result = ws.rewrite({"-q"});
  EXPECT_THAT(result.errors, Not(HasSubstr("Whole.h")));
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/other_msgs/Pair.h\n"));
}

/// genmsg has configured the packages: what it builds is in the devel space's files.
class MessagesOfGenmsg : public OwnMessages {
 protected:
  MessagesOfGenmsg() {
    ws.folder().write("ws/build/CMakeCache.txt",
                      "CATKIN_DEVEL_PREFIX:PATH=" + (ws.folder() / "ws/devel") + "\n");
  }
  void configured(const std::string& package, const std::string& folders, const std::string& messages) {
    const std::string cmake = "ws/devel/share/" + package + "/cmake/" + package;
    ws.folder().write(cmake + "-msg-paths.cmake",
                      "set(" + package + "_MSG_INCLUDE_DIRS \"" + folders + "\")\n");
    ws.folder().write(cmake + "-msg-extras.cmake", "set(" + package + "_MESSAGE_FILES \"" + messages +
                                                       "\")\nset(" + package + "_SERVICE_FILES \"\")\n");
  }
};

TEST_F(MessagesOfGenmsg, that_it_does_not_build_stop_nobody) {
  ws.folder().write("ws/src/demo/msg/Abandoned.msg", "nowhere_msgs/Blob blob\n");
  const std::string msg = ws.folder() / "ws/src/demo/msg";
  configured("demo", msg, msg + "/Blob.msg");
  const auto result = ws.rewrite({"-q"});
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/demo/Blob.h\n"));
  EXPECT_THAT(result.errors, Not(HasSubstr("Abandoned")));
}

TEST_F(MessagesOfGenmsg, may_lie_in_any_folder) {
  ws.folder().write("ws/src/demo/definitions/Half.msg", "uint8[] bytes\n");
  ws.folder().write("ws/src/demo/definitions/Both.msg", "Half left\nHalf right\n");
  const std::string folder = ws.folder() / "ws/src/demo/definitions";
  configured("demo", folder, folder + "/Both.msg;" + folder + "/Half.msg");
  EXPECT_THAT(ws.rewrite({"-q"}).errors, HasSubstr("twin: /tzc/demo/Both.h\n"));
}

TEST_F(MessagesOfGenmsg, may_be_many) {
  const std::string folder = ws.folder() / "ws/src/demo/msg";
  std::string all = folder + "/Blob.msg";
  for (int i = 100; i < 400; ++i) {
    const std::string name = "Part" + std::to_string(i) + ".msg";
    ws.folder().write("ws/src/demo/msg/" + name, "uint8[] bytes\n");
    all += ";" + folder + "/" + name;
  }
  configured("demo", folder, all);
  const auto result = ws.rewrite({"-q"});
  for (const char* name : {"Blob", "Part100", "Part399"})
    EXPECT_THAT(result.errors, HasSubstr(std::string("twin: /tzc/demo/") + name + ".h\n"));
}

TEST_F(MessagesOfGenmsg, of_actions_may_be_parts_of_others) {
  const std::string msg = ws.folder() / "ws/src/demo/msg", made = ws.folder() / "ws/devel/share/demo/msg";
  ws.folder().write("ws/devel/share/demo/msg/LiftGoal.msg", "uint8[] map\n");
  ws.folder().write("ws/src/demo/msg/Plan.msg", "LiftGoal goal\n");
  configured("demo", msg + ";" + made, msg + "/Plan.msg;" + made + "/LiftGoal.msg");
  const auto result = ws.rewrite({"-q"});
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/demo/LiftGoal.h\n"));
  EXPECT_THAT(result.errors, HasSubstr("twin: /tzc/demo/Plan.h\n"));
}

}  // namespace
}  // namespace tzc::rewriter
