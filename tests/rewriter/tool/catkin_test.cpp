// SPDX-License-Identifier: BSD-3-Clause
// The whole tool on real catkin workspaces: what CMake and GCC say about the port decides.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tool/catkin_case.h"

namespace tzc::rewriter {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using test::Catkin;
using test::json;
using test::node;
namespace fs = std::filesystem;

TEST_F(Catkin, is_ported_and_the_users_build_stays_as_it_is) {
  configure(find + "include_directories(${catkin_INCLUDE_DIRS})\n" + target +
            "target_link_libraries(node ${catkin_LIBRARIES})\n");
  const auto build = files_in("ws/build"), devel = files_in("ws/devel");
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(source(), HasSubstr("tzc::Publisher pub"));
  EXPECT_THAT(result.output, Not(HasSubstr("TZC400")));
  EXPECT_EQ(files_in("ws/build"), build);
  EXPECT_EQ(files_in("ws/devel"), devel);
}

/// `cmake .` in the package's folder.
TEST_F(Catkin, a_package_that_is_its_own_build_folder) {
  put("demo/CMakeLists.txt", "cmake_minimum_required(VERSION 3.0.2)\nproject(demo)\n" + find +
                                 "include_directories(${catkin_INCLUDE_DIRS})\n" + target +
                                 "target_link_libraries(node ${catkin_LIBRARIES})\n");
  const std::string demo = folder_ / "ws/src/demo";
  const ProcessResult configured = run_process(
      Command{{"cmake", ".", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DPYTHON_EXECUTABLE=/usr/bin/python3"},
              demo,
              {}});
  ASSERT_EQ(configured.status, 0) << configured.errors;
  auto before = files_in("ws/src/demo");
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(source(), HasSubstr("tzc::Publisher pub"));
  EXPECT_THAT(result.output, Not(HasSubstr("TZC3001")));
  EXPECT_THAT(result.output, HasSubstr("cmake --build " + demo + "\n"));
  auto after = files_in("ws/src/demo");
  for (const char* ported : {"CMakeLists.txt", "package.xml", "src/node.cpp"})
    EXPECT_NE(after[demo + "/" + ported], before[demo + "/" + ported]) << ported;
  for (const char* ported : {"CMakeLists.txt", "package.xml", "src/node.cpp"})
    after[demo + "/" + ported] = before[demo + "/" + ported];
  EXPECT_EQ(after, before);
}

/// A robot's prefix, whatever it is called, into which this workspace is installed as well.
TEST_F(Catkin, what_was_found_in_the_prefix_of_installation_is_found_there_again) {
  folder_.write("robot/bin/robot_tool", "");
  fs::permissions(folder_ / "robot/bin/robot_tool", fs::perms::owner_all);
  configure(
      find +
          "find_program(ROBOT_TOOL robot_tool)\nif(NOT EXISTS \"${ROBOT_TOOL}\")\n  message(FATAL_ERROR "
          "\"no ${ROBOT_TOOL}\")\nendif()\ninclude_directories(${catkin_INCLUDE_DIRS})\n" +
          target + "target_link_libraries(node ${catkin_LIBRARIES})\n",
      {"-DCMAKE_INSTALL_PREFIX=" + (folder_ / "robot"),
       "-DROBOT_TOOL:FILEPATH=" + (folder_ / "robot/bin/robot_tool")});
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(source(), HasSubstr("tzc::Publisher pub"));
}

TEST_F(Catkin, what_the_package_includes_from_its_own_folder_is_ported) {
  put("demo/cmake/dependencies.cmake", find);
  put("demo/cmake/node.cmake", "include_directories(${catkin_INCLUDE_DIRS})\n" + target +
                                   "target_link_libraries(node ${catkin_LIBRARIES})\n");
  configure("include(cmake/dependencies.cmake)\ninclude(${CMAKE_CURRENT_SOURCE_DIR}/cmake/node.cmake)\n");
  const ProcessResult ported = rewrite({"--apply"});
  EXPECT_EQ(ported.status, 0) << ported.output;
  EXPECT_THAT(source(), HasSubstr("tzc::Publisher pub"));
  EXPECT_THAT(folder_.read("ws/src/demo/cmake/dependencies.cmake"), HasSubstr("tzc"));
}

/// It lies outside of the package.
TEST_F(Catkin, an_included_file_that_keeps_tzc_out_is_refused_and_one_that_lets_it_in_is_ported) {
  put("shared/dependencies.cmake", find);
  put("demo/cmake/node.cmake", "include_directories(${catkin_INCLUDE_DIRS})\n" + target +
                                   "target_link_libraries(node ${catkin_LIBRARIES})\n");
  configure("include(../shared/dependencies.cmake)\ninclude(cmake/node.cmake)\n");
  const ProcessResult refused = rewrite({"--apply"});
  EXPECT_EQ(refused.status, 1) << refused.errors;
  EXPECT_EQ(source(), node);
  EXPECT_EQ(folder_.read("ws/src/demo/package.xml").find("tzc"), std::string::npos);
  EXPECT_THAT(refused.output, HasSubstr("TZC4005"));
  EXPECT_EQ(summary()["publish"]["plain"], 1);

  put("shared/dependencies.cmake",
      "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs tzc)\ncatkin_package()\n");
  const ProcessResult ported = rewrite({"--apply"});
  EXPECT_EQ(ported.status, 0) << ported.output;
  EXPECT_THAT(source(), HasSubstr("tzc::Publisher pub"));
}

/// With the files that the compilers and CMake really read: the second check runs none of them, and sees each change.
TEST_F(Catkin, a_second_check_is_answered_from_the_cache_until_something_changes) {
  put("other/package.xml",
      "<package format=\"2\">\n  <name>other</name>\n  <version>1.0.0</version>\n  "
      "<description>d</description>\n"
      "  <maintainer email=\"a@example.org\">a</maintainer>\n  <license>BSD</license>\n"
      "  <buildtool_depend>catkin</buildtool_depend>\n</package>\n");
  put("other/CMakeLists.txt",
      "cmake_minimum_required(VERSION 3.0.2)\nproject(other)\nfind_package(catkin "
      "REQUIRED)\ncatkin_package()\n");
  folder_.write("early/unrelated.h", "");
  configure(find + "include_directories(" + (folder_ / "early") +
            ")\ninclude_directories(${catkin_INCLUDE_DIRS})\n" + target +
            "target_link_libraries(node ${catkin_LIBRARIES})\n");
  const auto is_hit = [&] {
    const ProcessResult result = rewrite({"--check", "--cache-dir", folder_ / "cache"});
    EXPECT_EQ(result.status, 1) << result.errors;
    EXPECT_EQ(summary()["publish"]["zero_copy"], 1) << result.output;
    return result.errors.find("parsing") == std::string::npos;
  };
  EXPECT_FALSE(is_hit());
  EXPECT_TRUE(is_hit());
  put("other/CMakeLists.txt", folder_.read("ws/src/other/CMakeLists.txt") + "# changed\n");
  EXPECT_FALSE(is_hit()) << "CMake reads it";
  folder_.write("early/sensor_msgs/Image.h", "#include_next <sensor_msgs/Image.h>\n");
  EXPECT_FALSE(is_hit()) << "a header that hides another one";
  EXPECT_TRUE(is_hit());
}

TEST_F(Catkin, the_packages_warnings_are_errors_of_its_own_code_only) {
  configure("add_compile_options(-Wall -Wextra -Werror -Wno-deprecated-declarations)\n" + find +
            "include_directories(SYSTEM ${catkin_INCLUDE_DIRS})\n" + target +
            "target_link_libraries(node ${catkin_LIBRARIES})\n");
  const ProcessResult result = rewrite({"--apply"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_EQ(summary()["publish"]["zero_copy"], 1);
}

/// A library of converters and the package that uses it: an interface changes only with both.
class CatkinOfTwo : public Catkin {
 protected:
  CatkinOfTwo() {
    std::string manifest = folder_.read("ws/src/demo/package.xml");
    manifest.replace(manifest.find("<name>demo"), 10, "<name>fill");
    put("fill/package.xml", manifest);
    manifest.replace(manifest.find("<name>fill"), 10, "<name>demo");
    manifest.insert(manifest.find("  <depend>sensor_msgs"), "  <depend>fill</depend>\n");
    put("demo/package.xml", manifest);
    put("fill/include/fill/fill.h",
        "#pragma once\n#include <sensor_msgs/Image.h>\n\nvoid fill(sensor_msgs::Image& image);\n");
    put("fill/src/fill.cpp",
        "#include <fill/fill.h>\n\nvoid fill(sensor_msgs::Image& image) {\n  image.data.resize(640 * "
        "480);\n}\n");
    put("demo/src/node.cpp", user);
  }
  void configure_both(const std::string& dependencies_of_fill) const {
    put("fill/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.0.2)\nproject(fill)\n" + dependencies_of_fill +
            "catkin_package(INCLUDE_DIRS include LIBRARIES fill CATKIN_DEPENDS sensor_msgs)\n"
            "include_directories(include ${catkin_INCLUDE_DIRS})\nadd_library(fill src/fill.cpp)\n"
            "target_link_libraries(fill ${catkin_LIBRARIES})\n");
    configure_user();
  }
  void configure_user() const {
    configure(
        "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs fill)\ncatkin_package()\n"
        "include_directories(${catkin_INCLUDE_DIRS})\n" +
        target + "target_link_libraries(node ${catkin_LIBRARIES})\n");
  }
  std::string header() const { return folder_.read("ws/src/fill/include/fill/fill.h"); }

  const std::string user =
      "#include <fill/fill.h>\n#include <ros/ros.h>\n\nint main(int argc, char** argv) {\n"
      "  ros::init(argc, argv, \"node\");\n  ros::NodeHandle nh;\n"
      "  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(\"image\", 10);\n  sensor_msgs::Image image;\n"
      "  fill(image);\n  pub.publish(image);\n}\n";
};

TEST_F(CatkinOfTwo, are_ported_as_one_and_build) {
  configure_both("find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)\n");
  const ProcessResult result =
      rewrite({"--apply", "--verify=build", "--exported-headers=change", folder_ / "ws/src/fill"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(header(), HasSubstr("void fill(tzc::sensor_msgs::Image& image)"));
  EXPECT_THAT(source(), HasSubstr("pub.allocate(image);\n  fill(image);"));
  EXPECT_THAT(result.output, HasSubstr("solved as one with it: fill"));
}

TEST_F(CatkinOfTwo, whoever_keeps_the_header_is_told_what_would_port_it) {
  configure_both("find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)\n");
  put("fill/src/fill.cpp", user + "void fill(sensor_msgs::Image& image) { image.data.resize(640 * 480); }\n");
  const ProcessResult result = rewrite({folder_ / "ws/src/fill"});
  EXPECT_EQ(result.status, 1) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("1 site waits for headers that other packages may include"));
}

TEST_F(CatkinOfTwo, one_that_has_nothing_but_headers_is_ported_with_its_user) {
  fs::remove(folder_ / "ws/src/fill/src/fill.cpp");
  put("fill/include/fill/fill.h",
      "#pragma once\n#include <sensor_msgs/Image.h>\n\ninline void fill(sensor_msgs::Image& image) {\n"
      "  image.data.resize(640 * 480);\n}\n");
  put("fill/CMakeLists.txt",
      "cmake_minimum_required(VERSION 3.0.2)\nproject(fill)\n"
      "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)\n"
      "catkin_package(INCLUDE_DIRS include CATKIN_DEPENDS sensor_msgs)\n");
  configure_user();
  const ProcessResult result =
      rewrite({"--apply", "--verify=build", "--exported-headers=change", folder_ / "ws/src/fill"});
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_THAT(header(), HasSubstr("void fill(tzc::sensor_msgs::Image& image)"));
  EXPECT_THAT(source(), HasSubstr("pub.allocate(image);\n  fill(image);"));
  EXPECT_THAT(folder_.read("ws/src/fill/package.xml"), HasSubstr("<depend>tzc</depend>"));
  EXPECT_THAT(folder_.read("ws/src/fill/CMakeLists.txt"), HasSubstr("CATKIN_DEPENDS sensor_msgs tzc"));
}

TEST_F(CatkinOfTwo, one_whose_build_files_are_refused_keeps_the_other) {
  put("shared/dependencies.cmake", "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)\n");
  configure_both("include(../shared/dependencies.cmake)\n");
  const ProcessResult result = rewrite({"--apply", "--exported-headers=change", folder_ / "ws/src/fill"});
  EXPECT_EQ(result.status, 1) << result.errors;
  EXPECT_EQ(header().find("tzc"), std::string::npos);
  EXPECT_EQ(source(), user);
  EXPECT_THAT(result.output, HasSubstr("it is ported as one with " + (folder_ / "ws/src/fill")));
}

}  // namespace
}  // namespace tzc::rewriter
