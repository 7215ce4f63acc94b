// SPDX-License-Identifier: BSD-3-Clause
// Packages that have a build tree each, as catkin build makes them, of which one compiles or includes a file of another.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tool/catkin_case.h"

namespace tzc::rewriter {
namespace {

using ::testing::HasSubstr;

/// `demo` exports a class with a private publisher; `user` is another package.
class CatkinUserTrees : public test::Catkin {
 protected:
  CatkinUserTrees() {
    manifest_ = folder_.read("ws/src/demo/package.xml");
    put("demo/include/demo/driver.h",
        "#pragma once\n#include <ros/ros.h>\n\nclass Driver {\n public:\n  void step();\n\n private:\n"
        "  ros::NodeHandle nh_;\n  ros::Publisher pub_;\n};\n");
    put("demo/src/node.cpp",
        "#include <demo/driver.h>\n#include <sensor_msgs/Image.h>\n\nvoid Driver::step() {\n"
        "  pub_ = nh_.advertise<sensor_msgs::Image>(\"image\", 10);\n  sensor_msgs::Image image;\n"
        "  image.data.resize(640 * 480);\n  pub_.publish(image);\n}\n\nint main() { Driver().step(); }\n");
    put("demo/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.0.2)\nproject(demo)\n"
        "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)\n"
        "catkin_package(INCLUDE_DIRS include CATKIN_DEPENDS roscpp sensor_msgs)\n"
        "include_directories(include ${catkin_INCLUDE_DIRS})\n" +
            target + "target_link_libraries(node ${catkin_LIBRARIES})\n");
    put("user/src/user.cpp", "#include <demo/driver.h>\n\nint main() { Driver(); }\n");
    test::fs::create_directories(folder_ / "ws/.catkin_tools");
    configure_tree("demo");
  }

  void configure_tree(const std::string& package) const {
    const std::string devel = folder_ / "ws/devel";
    const ProcessResult result = run_process(
        {"cmake", "-S", folder_ / ("ws/src/" + package), "-B", folder_ / ("ws/build/" + package), "-G",
         "Unix Makefiles", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DPYTHON_EXECUTABLE=/usr/bin/python3",
         "-DCATKIN_DEVEL_PREFIX=" + devel, "-DCMAKE_PREFIX_PATH=" + devel});
    ASSERT_EQ(result.status, 0) << result.errors;
  }
  void configure_user(const std::string& depends, const std::string& components,
                      const std::string& rest) const {
    std::string of_user = manifest_;
    of_user.replace(of_user.find("<name>demo"), 10, "<name>user");
    of_user.insert(of_user.find("  <depend>sensor_msgs"), depends);
    put("user/package.xml", of_user);
    put("user/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.0.2)\nproject(user)\nadd_compile_options(-std=c++17)\n"
        "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs" +
            components + ")\ncatkin_package()\n" + rest +
            "target_link_libraries(user ${catkin_LIBRARIES})\n");
    configure_tree("user");
  }
  void expect_refused(const std::string& why) const {
    const ProcessResult result = rewrite({"--apply"});
    EXPECT_EQ(result.status, 1) << result.errors << result.output;
    EXPECT_THAT(result.output, HasSubstr(why));
    EXPECT_THAT(folder_.read("ws/src/demo/include/demo/driver.h"), HasSubstr("ros::Publisher pub_"));
  }

  std::string manifest_;
};

TEST_F(CatkinUserTrees, a_user_that_finds_the_package_by_catkin_gets_tzc_from_it) {
  configure_user("  <depend>demo</depend>\n", " demo",
                 "include_directories(${catkin_INCLUDE_DIRS})\nadd_executable(user src/user.cpp)\n");
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(folder_.read("ws/src/demo/include/demo/driver.h"), HasSubstr("tzc::Publisher pub_"));
}

TEST_F(CatkinUserTrees, a_user_that_includes_the_header_by_its_path_keeps_it) {
  configure_user(
      "", "",
      "include_directories(../demo/include ${catkin_INCLUDE_DIRS})\nadd_executable(user src/user.cpp)\n");
  expect_refused("includes a header that the port changes");
}

TEST_F(CatkinUserTrees, a_user_that_compiles_the_file_by_its_path_keeps_it) {
  configure_user("", "",
                 "include_directories(../demo/include ${catkin_INCLUDE_DIRS})\n"
                 "add_executable(user ../demo/src/node.cpp)\n");
  expect_refused("compiles this file, which the port changes");
}

TEST_F(CatkinUserTrees, likewise_by_a_link) {
  test::fs::create_symlink(folder_ / "ws/src/demo/src/node.cpp", folder_ / "ws/src/user/src/node.cpp");
  configure_user(
      "", "",
      "include_directories(../demo/include ${catkin_INCLUDE_DIRS})\nadd_executable(user src/node.cpp)\n");
  expect_refused("compiles this file, which the port changes");
}

}  // namespace
}  // namespace tzc::rewriter
