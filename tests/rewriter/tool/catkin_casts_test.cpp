// SPDX-License-Identifier: BSD-3-Clause
// Subscriptions of a package that gives what it receives to other packages of the workspace.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tool/catkin_case.h"

namespace tzc::rewriter {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// `demo` gives the images that it receives to `lib`.
class CatkinWithCasts : public test::Catkin {
 protected:
  CatkinWithCasts() {
    std::string manifest = folder_.read("ws/src/demo/package.xml");
    std::string of_lib = manifest;
    of_lib.replace(of_lib.find("<name>demo"), 10, "<name>lib");
    put("lib/package.xml", of_lib);
    manifest.insert(manifest.find("  <depend>sensor_msgs"), "  <depend>lib</depend>\n");
    put("demo/package.xml", manifest);
    put("lib/include/lib/look.h",
        "#pragma once\n#include <sensor_msgs/Image.h>\n\nnamespace lib {\n"
        "void look(const sensor_msgs::Image& image);\n}\n");
    put("lib/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.0.2)\nproject(lib)\n"
        "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)\n"
        "catkin_package(INCLUDE_DIRS include LIBRARIES look)\ninclude_directories(include "
        "${catkin_INCLUDE_DIRS})\n"
        "add_library(look src/look.cpp)\ntarget_link_libraries(look ${catkin_LIBRARIES})\n");
    put("demo/src/node.cpp",
        "#include <lib/look.h>\n#include <ros/ros.h>\n\n"
        "void on_image(const sensor_msgs::ImageConstPtr& image) { lib::look(*image); }\n\n"
        "int main(int argc, char** argv) {\n  ros::init(argc, argv, \"node\");\n  ros::NodeHandle nh;\n"
        "  ros::Subscriber sub = nh.subscribe(\"image\", 1, on_image);\n  ros::spin();\n}\n");
  }
  ProcessResult ported(const std::string& body) const {
    put("lib/src/look.cpp",
        "#include <lib/look.h>\n\nvoid lib::look(const sensor_msgs::Image& image) { " + body + " }\n");
    configure(
        "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs lib)\ncatkin_package()\n"
        "include_directories(${catkin_INCLUDE_DIRS})\n" +
        target + "target_link_libraries(node ${catkin_LIBRARIES})\n");
    return rewrite({});
  }
};

TEST_F(CatkinWithCasts, a_package_that_reads_them_shares_them) {
  const ProcessResult result = ported("const_cast<std::string&>(image.encoding).size();");
  EXPECT_THAT(result.errors + result.output, HasSubstr("subscribe  1 site: 1 shared"));
}

TEST_F(CatkinWithCasts, a_package_that_casts_their_const_away_gets_those_of_roscpp) {
  const ProcessResult result = ported("const_cast<sensor_msgs::Image&>(image).data.resize(5);");
  EXPECT_THAT(result.errors + result.output, AllOf(HasSubstr("subscribe  1 site: 1 plain"),
                                                   HasSubstr("TZC2002"), HasSubstr("lib/src/look.cpp:3")));
}

}  // namespace
}  // namespace tzc::rewriter
