// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "proof/process.h"
#include "support/temp_dir.h"

namespace tzc::rewriter::test {

namespace fs = std::filesystem;
using nlohmann::json;

inline const char* const node =
    "#include <ros/ros.h>\n#include <sensor_msgs/Image.h>\n\nint main(int argc, char** argv) {\n"
    "  ros::init(argc, argv, \"node\");\n  ros::NodeHandle nh;\n"
    "  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(\"image\", 10);\n  sensor_msgs::Image image;\n"
    "  image.data.resize(640 * 480);\n  pub.publish(image);\n}\n";

/// A catkin workspace with the package `demo`, ported by the whole tool.
class Catkin : public ::testing::Test {
 protected:
  Catkin() {
    put("demo/package.xml",
        "<package format=\"2\">\n  <name>demo</name>\n  <version>1.0.0</version>\n  "
        "<description>d</description>\n"
        "  <maintainer email=\"a@example.org\">a</maintainer>\n  <license>BSD</license>\n"
        "  <buildtool_depend>catkin</buildtool_depend>\n  <depend>roscpp</depend>\n  "
        "<depend>sensor_msgs</depend>\n"
        "</package>\n");
    put("demo/src/node.cpp", node);
    fs::create_symlink("/usr/share/catkin/cmake/toplevel.cmake", folder_ / "ws/src/CMakeLists.txt");
  }

  void put(const std::string& file, const std::string& content) const {
    folder_.write("ws/src/" + file, content);
  }

  /// Configures the workspace as catkin_make does.
  void configure(const std::string& cmake, const std::vector<std::string>& options = {}) const {
    put("demo/CMakeLists.txt", "cmake_minimum_required(VERSION 3.0.2)\nproject(demo)\n" + cmake);
    std::vector<std::string> words = {"cmake",
                                      "-S",
                                      folder_ / "ws/src",
                                      "-B",
                                      folder_ / "ws/build",
                                      "-G",
                                      "Unix Makefiles",
                                      "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                                      "-DPYTHON_EXECUTABLE=/usr/bin/python3",
                                      "-DCATKIN_DEVEL_PREFIX=" + (folder_ / "ws/devel"),
                                      "-DCMAKE_INSTALL_PREFIX=" + (folder_ / "ws/install")};
    words.insert(words.end(), options.begin(), options.end());
    const ProcessResult result = run_process(words);
    ASSERT_EQ(result.status, 0) << result.errors;
  }

  ProcessResult rewrite(std::vector<std::string> words) const {
    words.insert(words.begin(), {TZC_REWRITE, "--report", folder_ / "report.json"});
    words.push_back(folder_ / "ws/src/demo");
    return run_process(words);
  }
  json summary() const { return json::parse(folder_.read("report.json"))["summary"]; }
  std::string source() const { return folder_.read("ws/src/demo/src/node.cpp"); }

  std::map<std::string, std::string> files_in(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / name))
      if (entry.is_regular_file()) {
        std::ifstream file(entry.path(), std::ios::binary);
        std::ostringstream content;
        content << file.rdbuf();
        files[entry.path()] = content.str();
      }
    return files;
  }

  tzc::test::TempDir folder_;
  const std::string find = "find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)\ncatkin_package()\n";
  const std::string target = "add_executable(node src/node.cpp)\n";
};

}  // namespace tzc::rewriter::test
