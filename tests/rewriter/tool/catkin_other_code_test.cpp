// SPDX-License-Identifier: BSD-3-Clause
// What must stay, or be refused, because of code that this run does not analyse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tool/catkin_case.h"

namespace tzc::rewriter {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CatkinBesideOthers : public test::Catkin {
 protected:
  CatkinBesideOthers() {
    put("demo/src/core.h",
        "#pragma once\n#include <ros/ros.h>\n#include <sensor_msgs/Image.h>\n\n"
        "struct Core {\n  void step();\n  ros::NodeHandle nh;\n  ros::Publisher pub;\n};\n");
    put("demo/src/node.cpp",
        "#include \"core.h\"\n\nvoid Core::step() {\n  pub = nh.advertise<sensor_msgs::Image>(\"image\", "
        "10);\n"
        "  sensor_msgs::Image image;\n  image.data.resize(640 * 480);\n  pub.publish(image);\n}\n\n"
        "int main(int argc, char** argv) {\n  ros::init(argc, argv, \"node\");\n  Core().step();\n}\n");
  }
  std::string core() const { return folder_.read("ws/src/demo/src/core.h"); }

  const std::string use =
      "#include \"core.h\"\n\nvoid send(ros::Publisher& out);\nvoid use(Core& core) { send(core.pub); }\n";
  const std::string node_target = find + "include_directories(src ${catkin_INCLUDE_DIRS})\n" + target +
                                  "target_link_libraries(node ${catkin_LIBRARIES})\n";
};

TEST_F(CatkinBesideOthers, a_member_that_nothing_else_names_is_ported) {
  put("demo/test/other.cpp", "#include \"core.h\"\n\nvoid use(Core& core) { core.step(); }\n");
  configure(node_target);
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(core(), HasSubstr("tzc::Publisher pub"));
}

TEST_F(CatkinBesideOthers, a_member_that_a_file_names_which_is_not_compiled_stays) {
  put("demo/test/use.cpp", use);
  configure(node_target);
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_THAT(core(), HasSubstr("ros::Publisher pub"));
  EXPECT_THAT(result.output, HasSubstr("publish    1 site: 1 zero_copy"));
}

TEST_F(CatkinBesideOthers, unless_the_file_is_said_to_be_dead) {
  put("demo/test/use.cpp", use);
  put("demo/test/more.cpp", use);
  configure(node_target);
  const ProcessResult one = rewrite({"--dead-files=test/use.*"});
  EXPECT_THAT(one.output, HasSubstr("+++"));
  EXPECT_THAT(one.output, Not(HasSubstr("tzc::Publisher pub")));
  const ProcessResult both = rewrite({"--apply", "--dead-files=test/use.*,test/more.cpp"});
  EXPECT_EQ(both.status, 0) << both.errors << both.output;
  EXPECT_THAT(core(), HasSubstr("tzc::Publisher pub"));
}

TEST_F(CatkinBesideOthers, a_member_that_a_generated_source_names_stays) {
  put("demo/src/use.cpp.in", use);
  configure(find +
            "include_directories(src ${catkin_INCLUDE_DIRS})\n"
            "configure_file(src/use.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/generated/use.cpp)\n"
            "add_executable(node src/node.cpp ${CMAKE_CURRENT_BINARY_DIR}/generated/use.cpp)\n"
            "target_link_libraries(node ${catkin_LIBRARIES})\n");
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_THAT(core(), HasSubstr("ros::Publisher pub"));
  EXPECT_THAT(result.output, HasSubstr("publish    1 site: 1 zero_copy"));
}

/// `demo` exports a class with a private publisher, which the package `user` includes.
class CatkinWithUser : public test::Catkin {
 protected:
  CatkinWithUser() {
    manifest = folder_.read("ws/src/demo/package.xml");
    std::string of_user = manifest;
    of_user.replace(of_user.find("<name>demo"), 10, "<name>user");
    of_user.insert(of_user.find("  <depend>sensor_msgs"), "  <depend>demo</depend>\n");
    put("user/package.xml", of_user);
    put("user/src/user.cpp", "#include <demo/driver.h>\n\nint main() { Driver().step(); }\n");
    put("demo/include/demo/driver.h",
        "#pragma once\n#include <ros/ros.h>\n\nclass Driver {\n public:\n  void step();\n\n private:\n"
        "  ros::NodeHandle nh_;\n  ros::Publisher pub_;\n};\n");
    put("demo/src/node.cpp",
        "#include <demo/driver.h>\n#include <sensor_msgs/Image.h>\n\nvoid Driver::step() {\n"
        "  pub_ = nh_.advertise<sensor_msgs::Image>(\"image\", 10);\n  sensor_msgs::Image image;\n"
        "  image.data.resize(640 * 480);\n  pub_.publish(image);\n}\n");
  }
  void put_user(const std::string& standard) const {
    put("user/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.0.2)\nproject(user)\nadd_compile_options(" + standard +
            ")\nfind_package(catkin REQUIRED COMPONENTS roscpp demo)\ncatkin_package()\n"
            "include_directories(${catkin_INCLUDE_DIRS})\nadd_executable(user src/user.cpp)\n"
            "target_link_libraries(user ${catkin_LIBRARIES})\n"
            "if(catkin_EXPORTED_TARGETS)\n  add_dependencies(user ${catkin_EXPORTED_TARGETS})\nendif()\n");
  }
  void configure_both(const std::string& standard_of_user) const {
    put_user(standard_of_user);
    configure(
        "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)\n"
        "catkin_package(INCLUDE_DIRS include LIBRARIES driver CATKIN_DEPENDS roscpp sensor_msgs)\n"
        "include_directories(include ${catkin_INCLUDE_DIRS})\nadd_library(driver src/node.cpp)\n"
        "target_link_libraries(driver ${catkin_LIBRARIES})\n");
  }
  std::string header() const { return folder_.read("ws/src/demo/include/demo/driver.h"); }
  std::string manifest;
};

TEST_F(CatkinWithUser, a_private_member_is_ported_and_the_user_builds) {
  configure_both("-std=c++14");
  const ProcessResult result = rewrite({"--apply", "--verify=build"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(header(), HasSubstr("tzc::Publisher pub_"));
}

TEST_F(CatkinWithUser, a_user_that_is_compiled_with_an_older_standard_keeps_the_header) {
  configure_both("-std=c++11");
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_EQ(result.status, 1) << result.errors;
  EXPECT_THAT(header(), HasSubstr("ros::Publisher pub_"));
  EXPECT_THAT(result.output, HasSubstr("user/src/user.cpp:1:1"));
  EXPECT_THAT(result.output,
              HasSubstr("it includes a header that the port changes, and it is compiled with -std=c++11"));
}

/// As catkin build and catkin_make_isolated do.
TEST_F(CatkinWithUser, likewise_one_that_has_a_build_tree_of_its_own) {
  configure_both("-std=c++14");
  const std::string source = folder_ / "ws/src/user/src/user.cpp";
  const test::json command = {
      {"directory", folder_.path()},
      {"file", source},
      {"command", "c++ -std=c++11 -I" + (folder_ / "ws/src/demo/include") + " -o user.o -c " + source}};
  test::fs::remove_all(folder_ / "ws/build/user");
  folder_.write("ws/build/user/compile_commands.json", test::json::array({command}).dump());
  const ProcessResult result = rewrite({"--apply", "-p", folder_ / "ws/build"});
  EXPECT_EQ(result.status, 1) << result.errors << result.output;
  EXPECT_THAT(header(), HasSubstr("ros::Publisher pub_"));
}

/// Messages of the workspace whose package does not make TZC headers: the port makes them in the build folder of `demo`.
class CatkinWithMessages : public CatkinWithUser {
 protected:
  CatkinWithMessages() {
    std::string of_messages = manifest;
    of_messages.replace(of_messages.find("<name>demo"), 10, "<name>blobs");
    of_messages.insert(of_messages.find("  <depend>roscpp"), "  <depend>message_generation</depend>\n");
    put("blobs/package.xml", of_messages);
    put("blobs/msg/Blob.msg", "uint8[] data\n");
    put("blobs/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.0.2)\nproject(blobs)\n"
        "find_package(catkin REQUIRED COMPONENTS message_generation)\nadd_message_files(FILES Blob.msg)\n"
        "generate_messages()\ncatkin_package()\n");
    std::string with_messages = manifest;
    with_messages.insert(with_messages.find("  <depend>roscpp"), "  <depend>blobs</depend>\n");
    put("demo/package.xml", with_messages);
  }
  void configure_demo() const {
    configure(
        "find_package(catkin REQUIRED COMPONENTS roscpp blobs)\n"
        "catkin_package(INCLUDE_DIRS include CATKIN_DEPENDS roscpp blobs)\n"
        "include_directories(include src ${catkin_INCLUDE_DIRS})\n" +
        target +
        "target_link_libraries(node ${catkin_LIBRARIES})\nadd_dependencies(node "
        "${catkin_EXPORTED_TARGETS})\n");
    ASSERT_EQ(
        run_process({"cmake", "--build", folder_ / "ws/build", "--target", "blobs_generate_messages_cpp"})
            .status,
        0);
  }
  /// A class that publishes in the header itself.
  static std::string publisher_class() {
    return "#pragma once\n#include <blobs/Blob.h>\n#include <ros/ros.h>\n\nclass Blobs {\n public:\n  void "
           "step() {\n"
           "    pub_ = nh_.advertise<blobs::Blob>(\"blob\", 10);\n    blobs::Blob blob;\n    "
           "blob.data.resize(640 * 480);\n"
           "    pub_.publish(blob);\n  }\n\n private:\n  ros::NodeHandle nh_;\n  ros::Publisher pub_;\n};\n";
  }
};

/// Everybody has what tzc::attached needs, whatever the message: the ported package exports that it depends on tzc_roscpp.
TEST_F(CatkinWithMessages, an_exported_header_does_not_include_what_others_do_not_have) {
  put("demo/include/demo/blobs.h", publisher_class());
  put("demo/src/node.cpp", "#include <demo/blobs.h>\n\nint main() { Blobs().step(); }\n");
  put("user/src/user.cpp", "#include <demo/blobs.h>\n\nint main() { Blobs().step(); }\n");
  put_user("-std=c++14");
  configure_demo();
  const ProcessResult result = rewrite({"--apply", "--verify=build"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(folder_.read("ws/src/demo/include/demo/blobs.h"),
              AllOf(Not(HasSubstr("<tzc/blobs")), HasSubstr("ros::Publisher pub_"),
                    HasSubstr("tzc::attached<blobs::Blob>(")));
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("<tzc/blobs/Blob.h> would be generated in this package's build folder only"),
                    HasSubstr("publish    1 site: 1 one_copy")));
}

TEST_F(CatkinWithMessages, a_header_of_its_own_does) {
  test::fs::remove_all(folder_ / "ws/src/user");
  put("demo/src/blobs.h", publisher_class());
  put("demo/src/node.cpp", "#include \"blobs.h\"\n\nint main() { Blobs().step(); }\n");
  configure_demo();
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(folder_.read("ws/src/demo/src/blobs.h"), HasSubstr("#include <tzc/blobs/Blob.h>"));
}

}  // namespace
}  // namespace tzc::rewriter
